//! Lifts: a point without a lift, or a lift whose momentum is the point.

use crate::input::Input;
use heavytop::SpinorRealisation;
use lie_poisson::{Covector, InfinitesimalAdjoint, SL2OnR2, Se3Dual, So3, Sum, Vector};

use lie_poisson_systems::So21;
use momentum_map::{
    HOPF, Lift, PARTICLE, QuadraticMomentumMap, Reversed, Side, TargetPoint, clebsch_realisation,
    unitary_realisation,
};

/// The largest error of M(lift(μ)), relative to the largest coordinate of each of its parts. PARTICLE takes Π for
/// perpendicular to Γ up to 1e-12, and `unitary_realisation` H for one of rank one up to 1e-10.
const TOLERANCE: f64 = 2e-10;

pub(crate) fn run(case: &[u8]) {
    let mut input = Input::new(case);
    match input.choice(8) {
        0 => check(&HOPF, &Covector(input.vector())),
        1 | 2 => check(&SpinorRealisation, &Se3Dual::new(input.vector(), input.vector())),
        3 => {
            let gamma = input.vector();
            let pi =
                if input.choice(4) == 0 { input.vector() } else { gamma.cross(&input.vector()) };
            check(&PARTICLE, &Se3Dual::new(pi, gamma));
        }
        4 => {
            let mu = Covector(input.vector());
            check(&QuadraticMomentumMap::new(Sum(SL2OnR2, SL2OnR2), Side::Right), &mu);
            check(&QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Left), &mu);
        }
        5 => {
            let map = unitary_realisation::<3>();
            let z = Vector::from_coordinates(|_| input.number());
            let mu = momentum_map::PoissonMap::apply::<f64>(&map, &z);
            check(&map, &mu);
        }
        6 => {
            let map = clebsch_realisation(InfinitesimalAdjoint(So21), Side::Left);
            let Ok(map) = map else { panic!("so(2, 1) has a Clebsch map") };
            check(&map, &Covector(input.vector()));
        }
        _ => {
            let map = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Right);
            let Ok(map) = map else { panic!("so(3) has a Clebsch map") };
            check(&map, &Covector(input.vector()));
        }
    }
}

/// Asserts that the point has no lift, or one with its momentum.
fn check<M: Lift>(map: &M, mu: &TargetPoint<M, f64>) {
    let Ok(z) = map.lift(mu) else { return };
    let again = map.apply(&z);
    let size = mu.max_abs();
    assert!(size.is_finite(), "a lift of {mu:?}");
    // Where products underflow, digits are lost.
    let error = (again - *mu).max_abs();
    assert!(
        error <= TOLERANCE * size + 1e-290,
        "{error:e} of {size:e}: {mu:?} → {z:?} → {again:?}"
    );
}
