//! The feature `serde`: what is written is read back with the same bits, and what is wrong is refused.

use collective_integrators::diagnostics::Drift;
use collective_integrators::{Direct, Direction, HamiltonianField, RungeKutta, Sample, Start};
use heavytop::{Body, Coordinate, EnergyLevel, HeavyTop, Invariant, Surface, SurfaceVariable};
use lie_poisson::{Covector, LiePoisson, Quaternion, Se3, Se3Dual, Sign, Sites};
use momentum_map::{Cotangent, Side};
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::error::Error;
use std::fmt::Debug;

fn there_and_back<T: Serialize + DeserializeOwned>(value: &T) -> Result<T, serde_json::Error> {
    serde_json::from_str(&serde_json::to_string(value)?)
}

fn assert_kept<T>(value: T) -> Result<(), serde_json::Error>
where
    T: Serialize + DeserializeOwned + PartialEq + Debug,
{
    assert_eq!(there_and_back(&value)?, value);
    Ok(())
}

fn body() -> Body {
    Body {
        inertia: Vector3::new(1.1, 1.3, 1.7) * 1e-4,
        mass: 0.3,
        gravity: 9.81,
        length: 0.1 + 0.2,
        center_of_mass: Vector3::new(0.6, 0.0, 0.8),
    }
}

#[test]
fn states_parameters_and_results_are_read_as_they_were_written() -> Result<(), Box<dyn Error>> {
    let v = Vector3::new(0.1, -1e-310, 1.0 / 3.0);
    assert_kept(Quaternion { scalar: 0.7, vector: v })?;
    assert_kept(Sites::new(vec![v, v * 2.0]))?;
    assert_kept(Cotangent::new(v, Covector(v * 3.0)))?;
    let spinor = Vector2::new(Complex::new(0.1, 0.2), Complex::new(-0.3, 1e300));
    assert_kept(Cotangent::new(spinor, Covector(spinor)))?;
    let (sign, side, direction) = (Sign::Minus, Side::Right, Direction::Both);
    assert_kept((sign, side, direction, Invariant::Kovalevskaya, Coordinate::Gamma2))?;
    let variable = Coordinate::Pi1.into();
    assert_kept(Surface { variable, level: 0.1, direction })?;
    assert_kept(Surface { variable: SurfaceVariable::Angle2, level: 7.0, direction })?;
    assert_kept(Drift { samples: 3, largest: 1e-17, slope: -2.5e-20 })?;
    let top = HeavyTop::new(&body())?;
    assert_kept((body(), top))?;
    assert_kept(EnergyLevel { top, energy: 0.1, vertical_momentum: -1e-5 })?;
    Ok(())
}

/// A run that starts from a serialised sample ends in the same bits as an uninterrupted run.
#[test]
fn a_run_goes_on_from_a_sample_in_a_file() -> Result<(), Box<dyn Error>> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
    let field = HamiltonianField { space: LiePoisson::minus(Se3::default()), hamiltonian: top };
    let explicit = Direct::new(RungeKutta::rk4(), field);
    let tenth = explicit.after(&start, 0.02, 10)?;
    let read: Sample<Se3Dual, Se3Dual> = there_and_back(&tenth)?;
    assert_eq!(read, tenth);
    let end = explicit.after(&read.state, 0.02, 10)?.state;
    assert_eq!(end, explicit.after(&start, 0.02, 20)?.state);
    Ok(())
}

#[test]
fn a_top_that_cannot_be_is_refused() -> Result<(), Box<dyn Error>> {
    let top = HeavyTop::lagrange(2.0, 1.0, 1.0)?;
    let text = serde_json::to_string(&top)?;
    // Control: the text is read as long as it is that of a top.
    assert_eq!(serde_json::from_str::<HeavyTop>(&text)?, top);
    let flat = text.replace("2.0,2.0,1.0", "2.0,2.0,5.0");
    assert_ne!(flat, text);
    let refused = serde_json::from_str::<HeavyTop>(&flat).map_err(|error| error.to_string());
    assert!(refused.is_err_and(|message| message.contains("triangle")));
    Ok(())
}
