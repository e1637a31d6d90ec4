//! The trajectories of the page are those of the library, to the last bit.

use collective_integrators::{
    Composition, Direct, HamiltonianField, RungeKutta, Splitting, Start, Substeps,
};
use heavytop::{HeavyTop, SymmetricTopSplitting, TopMidpoint, WithAttitude};
use heavytop_page::{PageMethod, Simulation, Snapshot};
use lie_poisson::{InstructionSet, LiePoisson, Quaternion, Se3, Se3Dual};
use nalgebra::Vector3;

type Failure = Box<dyn std::error::Error>;

const STEP: f64 = 0.05;

/// The number of steps: past the checkpoint at 1024, where implicit methods forget.
const STEPS: u64 = 1500;

fn top() -> Result<HeavyTop, Failure> {
    Ok(HeavyTop::kovalevskaya(1.0, 1.0)?)
}

fn start() -> Se3Dual {
    Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8))
}

/// Returns the moment of the page after all steps, made in pieces of odd sizes.
fn of_the_page(method: PageMethod) -> Result<Snapshot, Failure> {
    let mut simulation = Simulation::new(top()?, &start(), method, STEP)?;
    for piece in [1, 8, 700].iter().cycle() {
        let left = STEPS - simulation.steps();
        if left == 0 {
            break;
        }
        // What is drawn between the steps has no influence on them.
        simulation.at(simulation.time() - 0.3 * STEP);
        simulation.advance(f64::INFINITY, (*piece).min(left as u32))?;
    }
    assert_eq!(simulation.time(), STEPS as f64 * STEP);
    Ok(simulation.at(f64::INFINITY))
}

/// Asserts that the page has the bits of an integrator with attitude.
fn assert_same<I>(method: PageMethod, integrator: I) -> Result<(), Failure>
where
    I: Start<Momentum = Se3Dual>,
    I::State: Attitude,
{
    let sample = integrator.after(&start(), STEP, STEPS)?;
    let moment = of_the_page(method)?;
    assert_eq!(moment.momentum, sample.momentum, "{method:?}");
    assert_eq!(moment.attitude, sample.state.attitude(), "{method:?}");
    Ok(())
}

/// A state with an attitude beside it.
trait Attitude {
    fn attitude(&self) -> Quaternion;
}

impl<S> Attitude for lie_poisson::Pair<S, Quaternion> {
    fn attitude(&self) -> Quaternion {
        self.1
    }
}

#[test]
fn collective_methods_have_the_bits_of_the_library() -> Result<(), Failure> {
    let (top, portable) = (top()?, InstructionSet::Portable);
    for stages in [2, 3, 4, 6, 8] {
        let gauss = top.gauss(stages.into())?.with_instructions(portable)?;
        assert_same(PageMethod::Gauss { stages }, WithAttitude(gauss))?;
    }
    let midpoint = TopMidpoint::new(top).with_instructions(portable)?;
    assert_same(PageMethod::Midpoint, WithAttitude(midpoint))
}

#[test]
fn splittings_have_the_bits_of_the_library() -> Result<(), Failure> {
    let flows = SymmetricTopSplitting::new(top()?)?;
    let strang = Splitting::strang(flows);
    assert_same(PageMethod::Splitting, WithAttitude(strang))?;
    let suzuki = Composition::new(strang, Substeps::suzuki4());
    assert_same(PageMethod::Suzuki, WithAttitude(suzuki))
}

/// The library has no attitude for these methods: the page adds its equation, which changes no bit of (Π, Γ).
#[test]
fn explicit_methods_have_the_bits_of_the_library() -> Result<(), Failure> {
    let space = LiePoisson::minus(Se3::default());
    for (method, scheme) in [
        (PageMethod::RungeKutta4, RungeKutta::rk4()),
        (PageMethod::ExplicitMidpoint, RungeKutta::explicit_midpoint()),
    ] {
        let direct = Direct::new(scheme, HamiltonianField { space, hamiltonian: top()? });
        let last = direct.after(&start(), STEP, STEPS)?.momentum;
        assert_eq!(of_the_page(method)?.momentum, last, "{method:?}");
    }
    Ok(())
}

/// All methods tend to one motion, attitude included; the attitude of the explicit ones has an equation of its own.
#[test]
fn all_methods_show_the_same_motion() -> Result<(), Failure> {
    let shown = |method| -> Result<Snapshot, Failure> {
        let mut simulation = Simulation::new(top()?, &start(), method, 1e-3)?;
        simulation.advance(1.0005, 2000)?;
        // In the middle of a step.
        Ok(simulation.at(1.0005))
    };
    let exact = shown(PageMethod::Gauss { stages: 8 })?;
    for method in PageMethod::ALL {
        let moment = shown(method)?;
        let distance = (moment.momentum.0.0 - exact.momentum.0.0).norm()
            + (moment.attitude.vector - exact.attitude.vector).norm();
        // Methods of order 2 have errors of about h² |Ω|³.
        assert!(distance < 5e-5, "{method:?}: {distance:e}");
    }
    // Control: a step later the state is another.
    let mut simulation = Simulation::new(top()?, &start(), PageMethod::RungeKutta4, 1e-3)?;
    simulation.advance(1.0, 2000)?;
    assert!((simulation.at(1.0).momentum.0.0 - exact.momentum.0.0).norm() > 1e-4);
    Ok(())
}
