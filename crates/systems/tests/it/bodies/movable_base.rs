//! The heavy top on a movable base: its equations, its limit, and what a collective Gauss method conserves.

use crate::all_systems::drifts::{ROUND_OFF, drifts};
use collective_integrators::{
    Collective, Direct, HamiltonianField, RungeKutta, Start, fitted_order,
};
use lie_poisson::{
    Covector, Diagonal, Hamiltonian, InfinitesimalAdjoint, LiePoisson, Pair, PoissonSpace, Vector,
    differential, odd_power_defect,
};
use lie_poisson_systems::{
    Gyrostat, MovableBaseAlgebra, MovableBaseDual, MovableBaseElement, MovableBaseTop, SystemError,
};
use momentum_map::{Lift, PoissonMap, Side, clebsch_realisation};
use nalgebra::Vector3;

const INERTIA: Vector3<f64> = Vector3::new(2.0, 2.2, 1.0);

/// The mass of the top and the acceleration of gravity, in units in which neither is 1.
const MASS: f64 = 1.4;
const GRAVITY: f64 = 1.3;

fn top() -> MovableBaseTop {
    MovableBaseTop::new(INERTIA, [MASS, 2.0], GRAVITY, Vector3::new(0.1, 0.0, 0.8)).unwrap()
}

fn start() -> MovableBaseDual {
    let pi = Vector3::new(0.4, -0.3, 2.0);
    Covector(Pair(Pair(pi, Vector3::new(0.5, 0.2, -0.7)), Vector3::new(0.48, 0.6, 0.64)))
}

fn adjoint() -> InfinitesimalAdjoint<MovableBaseAlgebra> {
    InfinitesimalAdjoint(MovableBaseAlgebra::default())
}

#[test]
fn the_differential_and_the_equations() {
    let (top, mu) = (top(), start());
    let exact: MovableBaseElement = differential(|mu| top.value(mu), &mu);
    let dh: MovableBaseElement =
        Hamiltonian::<LiePoisson<MovableBaseAlgebra>>::differential(&top, &mu);
    assert!((dh - exact).max_abs() < 1e-14);
    let Covector(Pair(Pair(pi, p), gamma)) = mu;
    let Pair(Pair(omega, y), force) = dh;
    let rate = LiePoisson::minus(MovableBaseAlgebra::default()).hamiltonian_vector(&mu, &dh);
    let torque = pi.cross(&omega) + p.cross(&y) + gamma.cross(&force);
    let expected = Covector(Pair(Pair(torque, p.cross(&omega)), gamma.cross(&omega)));
    assert!((rate - expected).max_abs() < 1e-14);
    // The momenta of the velocities are Π and P.
    let c = Vector3::new(0.1, 0.0, 0.8);
    assert!((INERTIA.component_mul(&omega) + c.cross(&y) * MASS - pi).norm() < 1e-14);
    assert!((y * (MASS + 2.0) + omega.cross(&c) * MASS - p).norm() < 1e-14);
    assert!((force - c * (MASS * GRAVITY)).norm() < 1e-15);
}

/// On a base of 10⁹ kg at rest the top is a heavy top with a fixed point.
#[test]
fn a_heavy_base_is_a_fixed_point() {
    let c = Vector3::new(0.1, 0.0, 0.8);
    let top = MovableBaseTop::new(INERTIA, [MASS, 1e9], GRAVITY, c).unwrap();
    let fixed = Gyrostat::new(INERTIA, MASS * GRAVITY, c, Vector3::zeros()).unwrap();
    let Covector(Pair(Pair(pi, _), gamma)) = start();
    let map = clebsch_realisation(Diagonal::<_, 2>(adjoint()), Side::Right).unwrap();
    let on_base = Collective::new(RungeKutta::gauss(4).unwrap(), map, top);
    let mu = Covector(Pair(Pair(pi, Vector3::zeros()), gamma));
    let Covector(Pair(Pair(moved, _), _)) = on_base.after(&mu, 0.05, 40).unwrap().momentum;
    let field = HamiltonianField {
        space: LiePoisson::minus(lie_poisson::Se3::default()),
        hamiltonian: fixed,
    };
    let direct = Direct::new(RungeKutta::gauss(4).unwrap(), field);
    let expected = direct.after(&Covector(Pair(pi, gamma)), 0.05, 40).unwrap().momentum.0.0;
    // The base gives way by m/M = 1e-9, and the methods of order 8 have errors of 1e-10.
    assert!((moved - expected).norm() < 1e-8, "{:e}", (moved - expected).norm());
}

/// One copy of the algebra suffices for P not parallel to Γ, and two for every momentum.
#[test]
fn lifts_by_one_copy_and_by_two() {
    let one = clebsch_realisation(adjoint(), Side::Right).unwrap();
    let two = clebsch_realisation(Diagonal::<_, 2>(adjoint()), Side::Right).unwrap();
    let mu = start();
    assert!((one.apply::<f64>(&one.lift::<f64>(&mu).unwrap()) - mu).max_abs() < 1e-13);
    assert!((two.apply::<f64>(&two.lift::<f64>(&mu).unwrap()) - mu).max_abs() < 1e-13);
    assert_eq!((one.fibres().rank(), two.fibres().rank()), (6, 9));
    let parallel = Covector(Pair(Pair(Vector3::x(), Vector3::z()), Vector3::z()));
    assert!((two.apply::<f64>(&two.lift::<f64>(&parallel).unwrap()) - parallel).max_abs() < 1e-13);
}

#[test]
fn energy_and_casimirs_are_conserved() {
    assert!(odd_power_defect(&adjoint()) < 1e-14);
    let (top, mu) = (top(), start());
    let quantities = |mu: &MovableBaseDual| {
        let [a, b, c] = MovableBaseTop::casimirs(mu);
        [top.value(mu), a, b, c]
    };
    let gauss = |step: f64, steps: usize| {
        let map = clebsch_realisation(adjoint(), Side::Right).unwrap();
        let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, top);
        drifts(&gauss, &mu, (step, steps), quantities)
    };
    let steps = [0.2, 0.1, 0.05];
    let energies = steps.map(|step| (step, gauss(step, (40.0 / step) as usize)[0]));
    let order = fitted_order(&energies, 1e-13).unwrap();
    assert!((order - 4.0).abs() < 0.3, "{order} {energies:?}");
    let [energy, casimirs @ ..] = gauss(0.1, 2000);
    println!("Gauss 4, t = 200: h {energy:e}, Casimirs {casimirs:?}");
    assert!(casimirs.iter().all(|drift| *drift < ROUND_OFF), "{casimirs:?}");
    // Negative control: the explicit method loses them.
    let map = clebsch_realisation(adjoint(), Side::Right).unwrap();
    let explicit = Collective::new(RungeKutta::rk4(), map, top);
    let [_, lost @ ..] = drifts(&explicit, &mu, (0.1, 2000), quantities);
    assert!(lost.iter().all(|drift| *drift > 1e3 * ROUND_OFF), "{lost:?}");
}

#[test]
fn parameters_are_checked() {
    let new = |moments, masses, g| MovableBaseTop::new(moments, masses, g, Vector3::z());
    assert!(matches!(new(INERTIA, [0.0, 1.0], 1.0), Err(SystemError::NotPositive { .. })));
    assert!(matches!(new(INERTIA, [1.0, -1.0], 1.0), Err(SystemError::Negative { .. })));
    assert!(matches!(new(INERTIA, [1.0, 1.0], f64::NAN), Err(SystemError::NotFinite { .. })));
    // Finite numbers whose products are not.
    let far = MovableBaseTop::new(INERTIA, [1.0, 2.0], 1.0, Vector3::new(0.0, 1e200, 1e200));
    let expected = "matrix of the moments about the centre of both masses";
    assert!(
        matches!(far, Err(SystemError::NotFinite { name, value }) if name == expected && !value.is_finite())
    );
    assert!(matches!(
        new(INERTIA, [f64::MAX, f64::MAX], 1.0),
        Err(SystemError::NotFinite { name: "mass of top and base", .. })
    ));
    // The mass of 9 kg at 1 m needs moments of at least 9 kg m².
    assert!(
        matches!(new(INERTIA, [9.0, 0.0], 1.0), Err(SystemError::NotPositive { value, .. }) if value < 0.0)
    );
}
