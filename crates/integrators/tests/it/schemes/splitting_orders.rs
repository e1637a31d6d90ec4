//! Splittings have the order that they name, and those that call themselves symmetric lead back.

use collective_integrators::{
    AlternatingSubsteps, ExactFlows, FlowSequence, Integrator, LieTrotter, Splitting, Strang,
    Substeps, fitted_order,
};
use lie_poisson::Real;
use nalgebra::{Rotation3, Vector3};

/// Turns about e₁ and about e₂ at the rate 1. Together they are a turn about e₁ + e₂ at the rate √2.
#[derive(Clone, Copy, Debug)]
struct Turns;

impl<T: Real> ExactFlows<T> for Turns {
    type Point = Vector3<T>;
    const COUNT: usize = 2;

    fn flow(&self, index: usize, time: f64, z: &Vector3<T>) -> Vector3<T> {
        let (sine, cosine) = (T::from_f64(time.sin()), T::from_f64(time.cos()));
        match index {
            0 => Vector3::new(z.x, z.y * cosine - z.z * sine, z.y * sine + z.z * cosine),
            _ => Vector3::new(z.x * cosine + z.z * sine, z.y, z.z * cosine - z.x * sine),
        }
    }
}

fn check<S: FlowSequence>(name: &str, sequence: S) {
    let splitting = Splitting::new(Turns, sequence);
    let start = Vector3::new(0.3, -0.5, 0.8);
    let run = |z: &Vector3<f64>, h: f64, steps: usize| {
        let mut z = *z;
        for _ in 0..steps {
            z = Integrator::<f64>::step(
                &splitting,
                &z,
                h,
                &mut Integrator::<f64>::workspace(&splitting),
            )
            .unwrap()
            .point;
        }
        z
    };
    let exact = Rotation3::new(Vector3::new(1.0, 1.0, 0.0)) * start;
    let errors =
        [5, 10, 20].map(|n| (1.0 / n as f64, (run(&start, 1.0 / n as f64, n) - exact).norm()));
    // Below 1e-14 the errors are rounding.
    let order = fitted_order(&errors, 1e-14).unwrap();
    assert!((order - splitting.order() as f64).abs() < 0.3, "{name}: {order} {errors:?}");
    let defect = (run(&run(&start, 0.2, 1), -0.2, 1) - start).norm();
    // A dozen turns of a vector of length 1, each with a few roundings.
    let returns = defect < 64.0 * f64::EPSILON;
    assert_eq!(returns, splitting.is_symmetric(), "{name}: {defect:e}");
}

#[test]
fn splittings_have_their_orders_and_symmetries() {
    check("Lie–Trotter", LieTrotter);
    check("Strang", Strang);
    check("Blanes–Moan 4", AlternatingSubsteps::blanes_moan4());
    check("Blanes–Moan 6", AlternatingSubsteps::blanes_moan6());
    check("Yoshida 4", AlternatingSubsteps::composed(&Substeps::yoshida4()));
    // One flow after the other, as Lie and Trotter do, and their adjoint.
    check("one and one", AlternatingSubsteps::new(&[1.0], &[1.0]).unwrap());
    check("adjoint", AlternatingSubsteps::new(&[0.0, 1.0], &[1.0, 0.0]).unwrap());
}
