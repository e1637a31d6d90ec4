//! Integrators behind a pointer make the steps of their types, to the last bit.

use collective_integrators::{
    AnyIntegrator, AnyState, AnyTangents, ByPointer, CHECKPOINT, Collective, Composition, Direct,
    HamiltonianField, Integrator, LiftFree, RungeKutta, Start, Substeps, VariationalFlow,
};
use lie_poisson::{
    Automatic, Covector, Energy, LiePoisson, Momentum, Pair, Real, So3, State, Vector,
};
use momentum_map::{HOPF, Quaternions};
use nalgebra::{Vector1, Vector2, Vector3};

/// The size of the steps.
const STEP: f64 = 0.1;

/// A rigid body in a field along its first axis.
#[derive(Clone, Copy)]
struct Body;

impl Energy for Body {
    type Space = LiePoisson<So3>;

    fn energy<T: Real>(&self, Covector(pi): &Momentum<So3, T>) -> T {
        (pi.x * pi.x + pi.y * pi.y * 0.5 + pi.z * pi.z * 0.25) * 0.5 + pi.x * 0.3
    }
}

fn gauss() -> RungeKutta {
    RungeKutta::gauss(3).unwrap()
}

fn start() -> Momentum<So3> {
    Covector(Vector3::new(0.3, -1.1, 0.7))
}

fn coordinates<V: State<Scalar = f64>>(v: &V) -> Vec<f64> {
    (0..v.dimension()).map(|i| v.coordinate(i)).collect()
}

/// Checks single steps, many steps, the first sample and a run that is resumed.
fn same_runs<I>(typed: &I, any: &AnyIntegrator)
where
    I: Start<State: Vector, Momentum = Momentum<So3>>,
{
    let given = AnyState::of(&start());
    let runs = typed.trajectory(&start(), STEP).unwrap().zip(any.trajectory(&given, STEP).unwrap());
    for (one, other) in runs.take(50) {
        let (one, other) = (one.unwrap(), other.unwrap());
        assert_eq!(coordinates(&one.state), other.state.as_slice());
        assert_eq!(coordinates(&one.momentum), other.momentum.as_slice());
        assert_eq!(
            (one.step, one.time, one.iterations),
            (other.step, other.time, other.iterations)
        );
    }
    let whole = any.after(&given, STEP, CHECKPOINT + 7).unwrap();
    assert_eq!(
        coordinates(&typed.after(&start(), STEP, CHECKPOINT + 7).unwrap().state),
        whole.state.as_slice()
    );
    let saved = any.after(&given, STEP, CHECKPOINT).unwrap();
    // A saved state is a list of numbers, without its blocks.
    let read = AnyState::from_slice(saved.state.as_slice());
    let resumed = any.trajectory_resumed(read, CHECKPOINT, STEP).nth(7).unwrap().unwrap();
    assert_eq!(resumed.state.as_slice(), whole.state.as_slice());
}

#[test]
fn hidden_integrators_make_the_same_steps() {
    let space = LiePoisson::minus(So3);
    let direct = Direct::new(gauss(), HamiltonianField { space, hamiltonian: Automatic(Body) });
    let collective = Collective::new(gauss(), HOPF, Automatic(Body));
    let reduced = LiftFree::new(gauss(), Quaternions, Automatic(Body));
    same_runs(&direct, &AnyIntegrator::new(direct.clone(), 3));
    same_runs(&collective, &AnyIntegrator::with_tangents(collective.clone(), 3).without_tangents());
    same_runs(&reduced, &AnyIntegrator::new(reduced.clone(), 3));
    let by_pointer = Collective::new(ByPointer(gauss()), HOPF, Automatic(Body));
    same_runs(&collective, &AnyIntegrator::new(by_pointer, 3));
}

/// Tangent vectors, their lengths and their images are those of the type.
#[test]
fn hidden_integrators_have_the_same_tangent_vectors() {
    let typed = Collective::new(gauss(), HOPF, Automatic(Body));
    let any: AnyIntegrator<dyn AnyTangents> = AnyIntegrator::with_tangents(typed.clone(), 3);
    let state = Start::<f64>::start(&typed, &start()).unwrap();
    let hidden = any.start(&AnyState::of(&start())).unwrap();
    let mut one = VariationalFlow::<_, 2>::generic(&typed, state, 4, STEP);
    let mut other = VariationalFlow::<_, 2>::generic(&any, hidden, 4, STEP);
    for _ in 0..30 {
        one.advance().unwrap();
        other.advance().unwrap();
        assert_eq!(one.normalise().unwrap(), other.normalise().unwrap());
        assert_eq!(coordinates(one.state()), other.state().as_slice());
    }
    let images = one.directions().unwrap().map(|image| coordinates(&image));
    assert_eq!(images, other.directions().unwrap().map(|image| image.as_slice().to_vec()));
}

/// The storage of another integrator is replaced, and the state after a failed step is the one before it.
#[test]
fn storage_of_another_integrator_is_replaced() {
    let collective = AnyIntegrator::new(Collective::new(gauss(), HOPF, Automatic(Body)), 3);
    let reduced = AnyIntegrator::new(LiftFree::new(gauss(), Quaternions, Automatic(Body)), 3);
    let state = reduced.start(&AnyState::of(&start())).unwrap();
    let mut foreign = collective.workspace();
    let step = reduced.step(&state, STEP, &mut foreign).unwrap();
    assert_eq!(step, reduced.step(&state, STEP, &mut reduced.workspace()).unwrap());
    let (mut kept, mut space) = (state.clone(), reduced.workspace());
    assert!(reduced.step_in_place(&mut kept, f64::NAN, &mut space).is_err());
    assert_eq!(kept, state);
}

/// Coordinates that complete a momentum to the width of its type are left out, and the dimensions are those of the type.
#[test]
fn what_completes_a_momentum_is_left_out() {
    let space = LiePoisson::minus(So3);
    let direct = Direct::new(gauss(), HamiltonianField { space, hamiltonian: Automatic(Body) });
    let direct = AnyIntegrator::new(direct, 2);
    let end = direct.after(&AnyState::from_slice(&[0.3, 0.0]), STEP, 3).unwrap();
    assert_eq!((end.momentum.as_slice().len(), end.state.as_slice().len()), (2, 3));
    assert!(direct.states_are_momenta() && direct.state_dimension() == 3);
    let lifted = AnyIntegrator::new(Collective::new(gauss(), HOPF, Automatic(Body)), 3);
    assert!(!lifted.states_are_momenta() && lifted.state_dimension() == 4);
}

#[test]
fn blocks_are_those_of_the_type() {
    type Two = Pair<Vector1<f64>, Vector2<f64>>;
    let v = AnyState::of(&Two::from_coordinates(|i| i as f64));
    assert_eq!((v.blocks(), v.shape()), (2, v.zeros_like().shape()));
    // What comes after the third block counts as the fourth, and more than 12 coordinates are on the heap.
    type Five = Pair<Pair<Two, Two>, Vector1<f64>>;
    let v = AnyState::of(&Five::from_coordinates(|i| i as f64));
    assert_eq!((0..7).map(|i| v.block(i)).collect::<Vec<_>>(), [0, 1, 1, 2, 3, 3, 3]);
    assert_eq!(v.as_slice(), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(v.zeros_like().as_slice(), [0.0; 7]);
    let mut long = AnyState::from_slice(&[1.0; 40]);
    long.add_multiple(2.0, &AnyState::from_slice(&[0.5; 40]));
    assert!(long.as_slice() == [2.0; 40] && long.blocks() == 1 && long.coordinate(40) == 0.0);
    long.set_coordinate(40, 1.0);
    assert_eq!(AnyState::from_slice(&[0.0; 0]).blocks(), 1);
    assert!(long.is_finite() && !AnyState::from_slice(&[f64::NAN]).is_finite());
}

/// Methods by name are compositions, of one substep where nothing is composed: a step of the base to the last bit.
#[test]
fn one_substep_is_a_step_of_the_base() {
    let once = Composition::new(gauss(), Substeps::new(&[1.0]).unwrap());
    let base = Collective::new(gauss(), HOPF, Automatic(Body));
    let once = Collective::new(once, HOPF, Automatic(Body));
    let [mut a, mut b] = [base.start(&start()).unwrap(); 2];
    base.advance(&mut a, STEP, 0..20, &mut base.workspace()).unwrap();
    once.advance(&mut b, STEP, 0..20, &mut once.workspace()).unwrap();
    assert_eq!(a, b);
}
