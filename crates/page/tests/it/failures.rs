//! What fails has a message, and leaves the top as it was.

use heavytop::HeavyTop;
use heavytop_page::{PageError, PageMethod, Simulation};
use lie_poisson::Se3Dual;
use nalgebra::Vector3;

type Failure = Box<dyn std::error::Error>;

fn fast() -> Se3Dual {
    Se3Dual::new(Vector3::new(20.0, 30.0, 40.0), Vector3::new(0.6, 0.0, 0.8))
}

#[test]
fn a_method_that_blows_up_stops_before_numbers_are_lost() -> Result<(), Failure> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let mut simulation = Simulation::new(top, &fast(), PageMethod::ExplicitMidpoint, 1.0)?;
    let error = simulation.advance(f64::INFINITY, 100_000);
    let message = error.map_or_else(|error| error.message(), |_| String::new());
    assert!(message.contains("finite"), "{message}");
    let moment = simulation.at(f64::INFINITY);
    assert!(moment.momentum.0.0.iter().chain(moment.attitude.vector.iter()).all(|x| x.is_finite()));
    assert!(simulation.columns().iter().all(|c| c.largest.iter().all(|x| x.is_finite())));
    Ok(())
}

#[test]
fn what_is_refused_leaves_the_top_as_it_was() -> Result<(), Failure> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let mut simulation = Simulation::new(top, &fast(), PageMethod::Midpoint, 0.01)?;
    simulation.advance(0.05, 100)?;
    let before = simulation.at(f64::INFINITY);
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(simulation.change_step(step), Err(PageError::StepSize { .. })), "{step}");
    }
    let refused = simulation.change_method(PageMethod::Gauss { stages: 9 }, 1.0);
    assert!(matches!(refused, Err(PageError::Scheme(_))), "{refused:?}");
    assert_eq!((simulation.at(f64::INFINITY), simulation.method()), (before, PageMethod::Midpoint));
    simulation.advance(0.1, 100)?;
    Ok(())
}

#[test]
fn throws_that_are_none_are_refused() -> Result<(), Failure> {
    let top = HeavyTop::kovalevskaya(1.0, 1.0)?;
    let pi = Vector3::new(2.0, 3.0, 4.0);
    for method in PageMethod::ALL {
        for gamma in [Vector3::zeros(), Vector3::new(f64::NAN, 0.0, 1.0)] {
            let thrown = Simulation::new(top, &Se3Dual::new(pi, gamma), method, 0.01);
            assert!(thrown.is_err(), "{method:?} {gamma}");
        }
        let huge = Se3Dual::new(Vector3::repeat(1e200), Vector3::z());
        assert!(Simulation::new(top, &huge, method, 0.01).is_err(), "{method:?}");
        // Control
        assert!(Simulation::new(top, &Se3Dual::new(pi, Vector3::z()), method, 0.01).is_ok());
    }
    Ok(())
}
