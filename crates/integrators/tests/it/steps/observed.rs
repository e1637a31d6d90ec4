//! What is observed keeps its steps, to the last bit, with their iterations.

use crate::laws::integrator_laws::{Body, STEP, momenta};
use crate::support::{field, start};
use collective_integrators::*;
use lie_poisson::*;
use momentum_map::{HOPF, Quaternions};
use std::cell::Cell;

/// Returns the coordinates and the iterations of 40 steps.
fn steps<I: Integrator<State: Vector>>(integrator: &I, start: I::State) -> Vec<(Vec<u64>, usize)> {
    let samples = integrator.trajectory_from(start, STEP).take(41);
    let bits = |z: &I::State| {
        (0..I::State::DIM).map(|i| z.coordinate(i).as_f64().unwrap().to_bits()).collect()
    };
    samples.map(|sample| sample.map(|s| (bits(&s.state), s.iterations)).unwrap()).collect()
}

/// A scheme that makes the steps of Gauss's method with a field that it wraps.
#[derive(Clone)]
struct Wrapping<'a> {
    gauss: RungeKutta,
    calls: &'a Cell<usize>,
    /// Whether what the field says beside its values is passed on.
    passes_on: bool,
}

/// A field that is known by its values alone.
struct Values<'a, F>(&'a F);

impl<T: Real, F: VectorField<T>> VectorField<T> for Values<'_, F> {
    type Point = F::Point;
    fn at(&self, z: &F::Point) -> F::Point {
        self.0.at(z)
    }
}

impl Scheme for Wrapping<'_> {
    type Workspace<V: State> = <RungeKutta as Scheme>::Workspace<V>;
    fn workspace<V: State>(&self) -> Self::Workspace<V> {
        self.gauss.workspace()
    }
    fn increment<T: Real, F: VectorField<T>>(
        &self,
        field: &F,
        z: &F::Point,
        step: f64,
        workspace: &mut Self::Workspace<F::Point>,
    ) -> Result<Step<F::Point>, StepError> {
        let called = || self.calls.set(self.calls.get() + 1);
        match self.passes_on {
            true => self.gauss.increment(&Observed::new(field, called), z, step, workspace),
            false => self.gauss.increment(&Values(field), z, step, workspace),
        }
    }
    fn forget<V: State>(&self, workspace: &mut Self::Workspace<V>) {
        self.gauss.forget(workspace);
    }
    fn order(&self) -> usize {
        self.gauss.order()
    }
    fn is_symplectic(&self) -> bool {
        true
    }
    fn is_symmetric(&self) -> bool {
        true
    }
}

impl Equivariant for Wrapping<'_> {}

/// The multipliers of the lift-free method are predicted in a frame of their own, and stages side by side are solved by
/// the field: a wrapper that passes on the values alone loses both.
#[test]
fn a_scheme_that_wraps_its_field_keeps_predictions_and_lanes() {
    let (calls, mu) = (Cell::new(0), momenta()[1]);
    let gauss = || RungeKutta::gauss(4).unwrap();
    let wrapping = |passes_on| Wrapping { gauss: gauss(), calls: &calls, passes_on };
    let free = steps(&LiftFree::new(gauss(), Quaternions, Automatic(Body)), mu);
    let wrapped = |passes_on| LiftFree::new(wrapping(passes_on), Quaternions, Automatic(Body));
    assert_eq!(steps(&wrapped(true), mu), free);
    assert!(calls.get() > 40);
    let sweeps =
        |steps: &[(Vec<u64>, usize)]| steps.iter().map(|(_, sweeps)| sweeps).sum::<usize>();
    assert!(sweeps(&steps(&wrapped(false), mu)) > sweeps(&free));

    let lanes = |passes_on| StagesInLanes::new(Direct::new(wrapping(passes_on), field()));
    let side_by_side = steps(&StagesInLanes::new(Direct::new(gauss(), field())), start());
    assert_eq!(steps(&lanes(true), start()), side_by_side);
    let one_by_one = steps(&Direct::new(gauss(), field()), start());
    assert_eq!(steps(&lanes(false), start()), one_by_one);
    assert_ne!(one_by_one, side_by_side);
}

#[test]
fn observed_fields_schemes_and_integrators_keep_their_bits() {
    let calls = Cell::new(0);
    let called = || calls.set(calls.get() + 1);
    let taken = || calls.replace(0);
    let gauss = || RungeKutta::gauss(3).unwrap();
    let (z, mu) = (start(), momenta()[0]);
    let direct = Direct::new(gauss(), field());
    let expected = steps(&direct, z);

    assert_eq!(steps(&Direct::new(gauss(), Observed::new(field(), called)), z), expected);
    let sweeps: usize = expected.iter().map(|(_, sweeps)| sweeps).sum();
    // three stages in each sweep, and X(z) in the steps without a prediction
    let evaluations = taken();
    assert!(evaluations > 3 * sweeps && evaluations <= 3 * sweeps + 40, "{evaluations} {sweeps}");
    assert_eq!(steps(&Direct::new(Observed::new(gauss(), called), field()), z), expected);
    assert_eq!(taken(), 40);
    assert_eq!(steps(&Observed::new(direct.clone(), called), z), expected);
    assert_eq!(taken(), 40);

    let sums = Compensated::new(Observed::new(direct.clone(), called));
    let exact = Pair(z, z.scaled(0.0));
    assert_eq!(steps(&sums, exact), steps(&Compensated::new(direct.clone()), exact));
    assert_eq!(taken(), 40);

    let lanes = StagesInLanes::new(direct.clone());
    let observed = StagesInLanes::new(Observed::new(direct, called));
    assert_eq!(steps(&observed, z), steps(&lanes, z));
    assert_eq!(taken(), 40);
    let in_lanes = Direct::new(gauss(), Observed::new(field(), called));
    assert_eq!(steps(&StagesInLanes::new(in_lanes), z), steps(&lanes, z));
    // one evaluation for all stages
    assert!((sweeps..2 * sweeps).contains(&taken()));

    let composed = |scheme| Composition::new(scheme, Substeps::yoshida4());
    let lift = |scheme| Collective::new(scheme, HOPF, Automatic(Body));
    let z = lift(composed(gauss())).start(&mu).unwrap();
    let expected = steps(&lift(composed(gauss())), z);
    let parts = Composition::new(Observed::new(gauss(), called), Substeps::yoshida4());
    assert_eq!(steps(&Collective::new(parts, HOPF, Automatic(Body)), z), expected);
    assert_eq!(taken(), 3 * 40);
}
