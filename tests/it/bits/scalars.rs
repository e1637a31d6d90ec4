//! One code over every scalar: steps on SIMD lanes (several numbers in one register) and on dual numbers against
//! steps on f64.

use collective_integrators::{
    Collective, Direct, HamiltonianField, Integrator, RungeKutta, Scheme, Start, StepError,
};
use heavytop::{HeavyTop, SpinorPoint, SpinorRealisation};
use lie_poisson::{
    DefaultLanes, DualNumber, Lanes, LiePoisson, Real, Se3, Se3Dual, State, Vector,
    derivative_part, map_coordinates, seed,
};
use momentum_map::Lift;
use std::error::Error;
use workspace_tests::{assert_near, relative_error, tops};

type Outcome = Result<(), Box<dyn Error>>;

/// The difference that one more sweep makes: iterations of dual numbers, which wait for the derivatives, may stop
/// later.
const ROUND_OFF: f64 = 1e-15;

fn schemes() -> Result<[RungeKutta; 5], Box<dyn Error>> {
    Ok([
        RungeKutta::explicit_midpoint(),
        RungeKutta::rk4(),
        RungeKutta::implicit_midpoint(),
        RungeKutta::gauss(2)?,
        RungeKutta::gauss(4)?,
    ])
}

/// Makes one step of size h of the collective integrator on T*C².
fn step<T: Real>(
    scheme: &RungeKutta,
    top: HeavyTop,
    z: &SpinorPoint<T>,
    h: f64,
) -> Result<SpinorPoint<T>, StepError> {
    let integrator = Collective::new(scheme.clone(), SpinorRealisation, top);
    let mut workspace = Integrator::<T>::workspace(&integrator);
    Ok(Integrator::<T>::step(&integrator, z, h, &mut workspace)?.point)
}

/// Returns four different states.
fn states() -> [Se3Dual; 4] {
    let x = [1.2, -0.7, 2.3, 0.4, 0.8, -0.5];
    [0, 1, 2, 3].map(|shift| Se3Dual::from_coordinates(|i| x[(i + shift) % 6]))
}

#[test]
fn lanes_are_four_separate_runs() -> Outcome {
    let top = tops::generic()?;
    let together = Se3Dual::<DefaultLanes>::from_coordinates(|i| {
        DefaultLanes::load(&states().map(|mu| mu.coordinate(i)))
    });
    for scheme in schemes()? {
        let lifted = SpinorRealisation.lift(&together)?;
        let stepped = step(&scheme, top, &lifted, 0.05)?;
        let integrator = Collective::new(scheme.clone(), SpinorRealisation, top);
        let mut all = Start::<DefaultLanes>::trajectory(&integrator, &together, 0.05)?;
        let last = all.nth(20).ok_or("no sample")??.momentum;
        for (lane, mu) in states().iter().enumerate() {
            let pick = |x: DefaultLanes| x.lane(lane);
            let z: SpinorPoint = map_coordinates(&lifted, pick);
            // Each lane makes the same operations as alone, hence the same bits.
            assert_eq!(z, SpinorRealisation.lift(mu)?);
            let alone = step(&scheme, top, &z, 0.05)?;
            assert_eq!(map_coordinates::<_, SpinorPoint>(&stepped, pick), alone);

            let run = integrator.trajectory(mu, 0.05)?.nth(20).ok_or("no sample")??;
            assert_eq!(map_coordinates::<_, Se3Dual>(&last, pick), run.momentum);
        }
    }
    Ok(())
}

/// Negative control: lanes are not exchanged; another lane's run is another run.
#[test]
fn lanes_differ() -> Outcome {
    let top = tops::generic()?;
    let midpoint = RungeKutta::implicit_midpoint();
    let [first, second, ..] = states();
    let one = step(&midpoint, top, &SpinorRealisation.lift(&first)?, 0.05)?;
    let two = step(&midpoint, top, &SpinorRealisation.lift(&second)?, 0.05)?;
    assert!(relative_error(&one, &two) > 0.1);
    Ok(())
}

/// The derivative of a step by dual numbers against the symmetric difference quotient, along every
/// coordinate.
#[test]
fn the_derivative_of_a_step() -> Outcome {
    let (top, z) = (tops::generic()?, SpinorRealisation.lift(&tops::generic_start())?);
    let (size, h) = (1e-5, 0.1);
    for scheme in schemes()? {
        for k in 0..SpinorPoint::<f64>::DIM {
            let along = SpinorPoint::basis(k);
            let moved: SpinorPoint<DualNumber> = step(&scheme, top, &seed(&z, &along), h)?;
            let exact: SpinorPoint = derivative_part(&moved);
            let at = |s: f64| step(&scheme, top, &(z + along.scaled(s)), h);
            let quotient = (at(size)? - at(-size)?).scaled(0.5 / size);
            // Truncation size² and round-off 1e-16/size are both near 1e-10.
            assert_near(&exact, &quotient, 1e-9);
            // Negative control: neither the derivative of the identity nor of another step.
            assert!((exact - along).max_abs() > 1e-4);
            let other: SpinorPoint<DualNumber> = step(&scheme, top, &seed(&z, &along), 0.9 * h)?;
            assert!((derivative_part::<_, _, SpinorPoint>(&other) - exact).max_abs() > 1e-6);
            // The values are those of the step on f64.
            let value: SpinorPoint =
                map_coordinates(&moved, |x: DualNumber| x.value_without_derivative());
            assert!(relative_error(&value, &at(0.0)?) <= ROUND_OFF);
        }
    }
    Ok(())
}

/// Dual numbers over lanes give derivatives of four steps at once.
#[test]
fn derivatives_of_four_steps_at_once() -> Outcome {
    let top = tops::generic()?;
    let space = LiePoisson::minus(Se3::default());
    let direct = Direct::new(RungeKutta::gauss(2)?, HamiltonianField { space, hamiltonian: top });
    fn one<T: Real>(
        direct: &Direct<RungeKutta, HamiltonianField<heavytop::HeavyTopSpace, HeavyTop>>,
        mu: &Se3Dual<T>,
    ) -> Result<Se3Dual<T>, StepError> {
        let mut workspace = RungeKutta::implicit_midpoint().workspace();
        Ok(Integrator::<T>::step(direct, mu, 0.05, &mut workspace)?.point)
    }
    let together = Se3Dual::<DualNumber<DefaultLanes>>::from_coordinates(|i| {
        DualNumber::new(
            DefaultLanes::load(&states().map(|mu| mu.coordinate(i))),
            DefaultLanes::from_f64(if i == 2 { 1.0 } else { 0.0 }),
        )
    });
    let stepped = one(&direct, &together)?;
    for (lane, mu) in states().iter().enumerate() {
        let alone: Se3Dual<DualNumber> = one(&direct, &seed(mu, &Se3Dual::basis(2)))?;
        let pick = |x: DualNumber<DefaultLanes>| x.derivative().lane(lane);
        let derivative: Se3Dual = derivative_part(&alone);
        assert_near(&map_coordinates::<_, Se3Dual>(&stepped, pick), &derivative, ROUND_OFF);
    }
    Ok(())
}
