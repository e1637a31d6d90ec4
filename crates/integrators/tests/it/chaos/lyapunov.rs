//! Lyapunov exponents of a linear map, against their exact values.

use collective_integrators::*;
use lie_poisson::Real;
use nalgebra::Vector2;

/// The linear vector field ẋ = x, ẏ = −2y.
struct Saddle;

impl<T: Real> VectorField<T> for Saddle {
    type Point = Vector2<T>;

    fn at(&self, z: &Vector2<T>) -> Vector2<T> {
        Vector2::new(z.x, z.y * -2.0)
    }
}

/// Exponents of a flow that has advanced already are means over the time since then, at every step. The rate is that
/// at which RK4 stretches, ln(1 + x + x²/2 + x³/6 + x⁴/24)/h with x = λh.
#[test]
fn a_transient_is_left_out() {
    let rk4 = Direct::new(RungeKutta::rk4(), Saddle);
    let start = Vector2::new(1e-3, 1.0);
    for (step, transient) in [(0.1, 0), (0.1, 50), (-0.1, 50)] {
        let mut flow = VariationalFlow::new(&rk4, start, [Vector2::x(), Vector2::y()], step);
        for _ in 0..transient {
            flow.advance().unwrap();
        }
        // Lengths at the start do not count as stretches, be they 1, e⁵ or e⁻¹⁰.
        let exponents = LyapunovExponents::from_flow(flow);
        let stretch = |x: f64| 1.0 + x + x * x / 2.0 + x.powi(3) / 6.0 + x.powi(4) / 24.0;
        let exact = [1.0, -2.0].map(|rate: f64| stretch(rate * step).ln() / step.abs());
        for (n, item) in (1..=10).zip(exponents) {
            let item = item.unwrap();
            assert_eq!(item.step, transient + n);
            assert!((item.time - (transient + n) as f64 * step).abs() < 1e-14);
            for (found, exact) in item.exponents.iter().zip(exact) {
                assert!((found - exact).abs() < 1e-13, "{transient} + {n}: {found} {exact}");
            }
        }
    }
}
