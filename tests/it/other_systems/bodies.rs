//! Bodies that are not tops: a gyrostat without a rotor is the heavy top, and the paper's realisation integrates all
//! of them.

use collective_integrators::{Collective, RungeKutta};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{Casimirs, DualNumber, Hamiltonian, Se3, Se3Dual, Vector};
use lie_poisson_systems::{Gyrostat, Kirchhoff};
use nalgebra::{Matrix3, Vector3};
use std::error::Error;
use workspace_tests::{advance, largest_deviation, tops};

/// Returns the gyrostat with the moments and the weight of a top.
fn gyrostat(top: &HeavyTop, rotor: Vector3<f64>) -> Result<Gyrostat, Box<dyn Error>> {
    Ok(Gyrostat::new(top.inertia(), top.weight_moment(), top.center_of_mass(), rotor)?)
}

#[test]
fn a_gyrostat_without_a_rotor_is_the_heavy_top() -> Result<(), Box<dyn Error>> {
    let (top, start) = (tops::paper()?, tops::paper_start());
    let same = gyrostat(&top, Vector3::zeros())?;
    let direction = Se3Dual::new(Vector3::new(0.3, -0.1, 0.7), Vector3::new(-0.2, 0.5, 0.4));
    assert_eq!(same.value(&start), top.value(&start));
    assert_eq!(same.differential(&start), top.differential(&start));
    assert_eq!(same.hessian(&start, &direction), top.hessian(&start, &direction));
    let seeded: Se3Dual<DualNumber> = lie_poisson::seed(&start, &direction);
    assert_eq!(same.value(&seeded), top.value(&seeded));

    let scheme = RungeKutta::gauss(2)?;
    let of_top = Collective::new(scheme.clone(), SpinorRealisation, top);
    let end = advance(&of_top, &start, 0.02, 500)?;
    let of_gyrostat = Collective::new(scheme.clone(), SpinorRealisation, same);
    assert_eq!(advance(&of_gyrostat, &start, 0.02, 500)?, end);

    // Negative control: a rotor changes the motion.
    let other = gyrostat(&top, Vector3::new(0.0, 0.0, 1e-3))?;
    let other = Collective::new(scheme, SpinorRealisation, other);
    assert!((advance(&other, &start, 0.02, 500)? - end).max_abs() > 1e-4);
    Ok(())
}

/// Returns the largest deviations of h, |Γ|² and Π·Γ over 1000 collective steps.
fn deviations<H>(h: H, start: &Se3Dual, step: f64) -> Result<[f64; 3], Box<dyn Error>>
where
    H: Hamiltonian<lie_poisson::LiePoisson<Se3>> + Copy,
{
    let gauss = Collective::new(RungeKutta::gauss(3)?, SpinorRealisation, h);
    let casimir = |i| move |mu: &Se3Dual| Se3::default().casimir(i, mu);
    Ok([
        largest_deviation(&gauss, start, step, 1000, |mu| h.value(mu))?,
        largest_deviation(&gauss, start, step, 1000, casimir(0))?,
        largest_deviation(&gauss, start, step, 1000, casimir(1))?,
    ])
}

#[test]
fn the_realisation_of_the_paper_conserves_their_casimirs() -> Result<(), Box<dyn Error>> {
    let rotor = gyrostat(&tops::paper()?, Vector3::new(0.1, -0.2, 0.7))?;
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.6, 0.0, -0.8));
    let [energy, square, level] = deviations(rotor, &start, 0.05)?;
    assert!(energy < 0.05_f64.powi(6) + 1e-12 && square < 1e-12 && level < 1e-12);

    let a = Matrix3::new(0.9, 0.1, 0.0, 0.1, 0.6, 0.05, 0.0, 0.05, 0.4);
    let b = Matrix3::new(0.1, -0.05, 0.02, 0.0, 0.08, 0.1, -0.07, 0.0, 0.03);
    let c = Matrix3::new(0.5, 0.0, 0.1, 0.0, 0.7, -0.1, 0.1, -0.1, 0.3);
    let start = Se3Dual::new(Vector3::new(0.4, -0.8, 0.6), Vector3::new(0.5, 0.3, -0.9));
    let [energy, square, level] = deviations(Kirchhoff::new(a, b, c)?, &start, 0.1)?;
    assert!(energy < 0.1_f64.powi(6) + 1e-12 && square < 1e-12 && level < 1e-12);
    Ok(())
}
