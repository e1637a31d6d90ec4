//! What the tests of torques share: a body, its start, and the order of a method.

use collective_integrators::diagnostics::fitted_order;
use collective_integrators::{Start, Substeps};
use lie_poisson::{Covector, Energy, LiePoisson, Point, Real, So3};
use nalgebra::Vector3;

pub(super) type Spin = Covector<Vector3<f64>>;

/// A body with the moments of inertia 2, 3/2 and 1, in units of its own.
#[derive(Clone, Copy)]
pub(super) struct Body {
    pub(super) unit: f64,
}

impl Energy for Body {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(pi): &Point<Self::Space, T>) -> T {
        (pi.x * pi.x / 2.0 + pi.y * pi.y / 1.5 + pi.z * pi.z) * (0.5 * self.unit)
    }
}

pub(super) fn start() -> Spin {
    Covector(Vector3::new(1.0, 2.0, 0.5))
}

/// Returns the order of a method by its errors at t = 4, and the errors.
pub(super) fn order<I: Start<Momentum = Spin>>(
    integrator: &I,
    exact: &Vector3<f64>,
    counts: &[u64],
) -> (f64, Vec<(f64, f64)>) {
    let errors = counts.iter().map(|&count| {
        let step = 4.0 / count as f64;
        (step, (integrator.after(&start(), step, count).unwrap().momentum.0 - exact).norm())
    });
    let errors: Vec<_> = errors.collect();
    (fitted_order(&errors, 1e-14).unwrap(), errors)
}

/// Returns the fractions of the substeps of each order, and numbers of steps to measure it.
pub(super) fn orders() -> [(f64, Option<Substeps>, [u64; 3]); 3] {
    [
        (2.0, None, [40, 80, 160]),
        (4.0, Some(Substeps::suzuki4()), [20, 40, 80]),
        (6.0, Some(Substeps::yoshida6()), [20, 30, 40]),
    ]
}
