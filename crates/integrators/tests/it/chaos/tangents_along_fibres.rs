//! Tangent vectors of lifted states: motions along the fibres, which runs make, have no part in them.

use collective_integrators::diagnostics::step_map;
use collective_integrators::*;
use core::marker::PhantomData;
use lie_poisson::{
    Automatic, Covector, Diagonal, DualNumber, Energy, InfinitesimalAdjoint, Point, PoissonSpace,
    Real, SL2OnR2, SO3OnR3, So3, State, Sum, Vector, derivative_part, map_coordinates, seed,
};
use momentum_map::{
    AffineAction, Cotangent, HOPF, Lift, MomentumMap, Opposite, PARTICLE, PoissonMap,
    QuadraticMomentumMap, Reversed, Side, SourcePoint, TargetPoint, clebsch_map,
    unitary_realisation,
};
use nalgebra::Vector3;

/// The Hamiltonian ½ Σ a_i μ_i² + b_i μ_i, with a_i between 1 and 2 and small b_i, which has no symmetry.
#[derive(Clone)]
struct Generic<P>(PhantomData<P>);

impl<P: PoissonSpace> Energy for Generic<P> {
    type Space = P;

    fn energy<T: Real>(&self, mu: &Point<P, T>) -> T {
        let mut sum = T::zero();
        for i in 0..<Point<P, T> as Vector>::DIM {
            let (x, i) = (mu.coordinate(i), i as f64);
            sum += x * x * (0.5 + 0.5 * (i * 0.618).fract()) + x * (0.2 * (i * 0.755).fract());
        }
        sum
    }
}

type Lifted<M> = Collective<RungeKutta, M, Automatic<Generic<<M as PoissonMap>::Target>>>;

const STEP: f64 = 0.05;

/// Returns the integrator that moves z along its fibre, and the one that never does.
fn integrators<M: PoissonMap>(map: M) -> [Lifted<M>; 2] {
    let (gauss, h) = (RungeKutta::gauss(2).unwrap(), || Automatic(Generic(PhantomData)));
    [
        Collective::new(gauss.clone(), map.clone(), h()),
        Collective::that_does_not_descend(gauss, map, h()),
    ]
}

/// Checks that the exponents of a lifted state have the sum 0, and are those of the run without motions along fibres.
/// Returns them, and whether the run itself moves z.
fn spectrum<I, const N: usize>(
    name: &str,
    [moving, still]: [I; 2],
    z: <I as Integrator>::State,
    flag: [usize; N],
    steps: usize,
) -> ([f64; N], bool)
where
    I: TangentIntegrator + Integrator<State: Vector, Momentum: Vector>,
{
    let followed = |integrator: &I| {
        let basis = flag.map(<<I as Integrator>::State as Vector>::basis);
        let flow = VariationalFlow::new(integrator, z, basis, STEP);
        let last = LyapunovExponents::from_flow(flow).nth(steps - 1).unwrap().unwrap();
        (last.exponents, last.state)
    };
    let (exponents, end) = followed(&moving);
    assert_eq!((exponents, end), followed(&still), "{name}");
    // The bound is the round-off of the lengths in a step, divided by its size.
    let sum: f64 = exponents.iter().sum();
    assert!(sum.abs() < 1e-12, "{name}: {sum:e}");
    let last = Integrator::<f64>::trajectory_from(&moving, z, STEP).nth(steps).unwrap().unwrap();
    let momentum = Integrator::<f64>::momentum(&moving, &end);
    // Where z is far out, M(z) has lost some digits.
    let apart = (momentum - last.momentum).max_abs() / last.momentum.max_abs();
    assert!(apart < 1e-9, "{name}: {apart:e}");
    (exponents, last.state != end)
}

/// Checks also that the exponents come in pairs ±λ. Returns whether the run moves z.
///
/// The first half of the coordinates in `flag` is an isotropic space, and each is paired with one from the end. If the
/// scales of all pairs have one product, as with one block of q and one of p, the pairs of exponents are then exact at
/// every time, since the tangent map is symplectic.
fn has_pairs<I, const N: usize>(
    name: &str,
    integrators: [I; 2],
    z: <I as Integrator>::State,
    flag: [usize; N],
    steps: usize,
) -> bool
where
    I: TangentIntegrator + Integrator<State: Vector, Momentum: Vector>,
{
    let (exponents, moved) = spectrum(name, integrators, z, flag, steps);
    for i in 0..N {
        let pair = exponents[i] + exponents[N - 1 - i];
        assert!(pair.abs() < 1e-12, "{name}: {i} {pair:e}");
    }
    moved
}

/// The coordinates q₁, …, q_n, p_n, …, p₁ of a cotangent bundle.
fn cotangent<const N: usize>() -> [usize; N] {
    core::array::from_fn(|i| if i < N / 2 { i } else { N / 2 + N - 1 - i })
}

/// The coordinates x₁, x₂, …, y₂, y₁ of a sum of planes.
fn planes<const N: usize>() -> [usize; N] {
    core::array::from_fn(|i| if i < N / 2 { 2 * i } else { 2 * (N - 1 - i) + 1 })
}

fn generic<V: Vector<Scalar = f64>>() -> V {
    V::from_coordinates(|i| ((i + 1) as f64 * 0.618).fract() - 0.4)
}

fn particle(along: f64) -> Cotangent<Vector3<f64>> {
    let (q, p) = (Vector3::new(0.3, -1.0, 0.7), Vector3::new(0.9, 0.4, -0.5));
    Cotangent::new(q + p * along, Covector(p))
}

#[test]
fn exponents_of_lifted_states_are_those_of_a_symplectic_map() {
    exponents_are_those_of_a_symplectic_map(30);
}

#[test]
#[ignore = "long"]
fn exponents_of_longer_runs_are_those_of_a_symplectic_map() {
    exponents_are_those_of_a_symplectic_map(100);
}

fn exponents_are_those_of_a_symplectic_map(steps: usize) {
    let fields = MomentumMap(Opposite(AffineAction(Diagonal::<_, 2>(SO3OnR3))));
    let so3 = clebsch_map(InfinitesimalAdjoint(So3), Side::Left);
    let moved = has_pairs("particle", integrators(PARTICLE), particle(70.0), cotangent::<6>(), 100);
    assert!(moved, "the run from a point far out moves it");
    has_pairs("two fields", integrators(fields), generic(), cotangent::<12>(), steps / 2);
    has_pairs("so(3)", integrators(so3), generic(), cotangent::<6>(), steps);
    has_pairs("Hopf", integrators(HOPF), generic(), planes::<4>(), steps);
    has_pairs("u(2)", integrators(unitary_realisation::<2>()), generic(), planes::<4>(), steps);
    let plane = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
    // The two planes have scales of their own, so that pairs are exact in the limit alone.
    spectrum("sl(2)", integrators(plane), generic(), planes::<4>(), steps);
}

/// Checks that DM takes the tangent vectors of a lifted state to those of μ, by steps that lift μ anew each time.
fn descends<M>(name: &str, map: M, z: SourcePoint<M>, steps: usize)
where
    M: Lift,
    Lifted<M>: Start<f64, State = SourcePoint<M>, Momentum = TargetPoint<M>>
        + Start<DualNumber, State = SourcePoint<M, DualNumber>, Momentum = TargetPoint<M, DualNumber>>,
    SourcePoint<M, DualNumber>: State<Shape = <SourcePoint<M> as State>::Shape>,
{
    let [lifted, _] = integrators(map.clone());
    let image = |z: &SourcePoint<M>, v: &SourcePoint<M>| -> TargetPoint<M> {
        derivative_part(&map.apply::<DualNumber>(&seed(z, v)))
    };
    let mut tangents = generic_tangents(<SourcePoint<M> as Vector>::DIM);
    let v: SourcePoint<M> = tangents.nth(1).unwrap();
    let mut flow = VariationalFlow::new(&lifted, z, [v], STEP);
    let (mut mu, mut below) = (map.apply::<f64>(&z), image(&z, &v));
    for _ in 0..steps {
        let dual: TargetPoint<M, DualNumber> = seed(&mu, &below);
        let next = step_map::<DualNumber, _>(&lifted, &dual, STEP).unwrap();
        (mu, below) =
            (map_coordinates(&next, |x| x.value_without_derivative()), derivative_part(&next));
        flow.advance().unwrap();
    }
    let above = image(flow.state(), &flow.tangents()[0]);
    let apart = (above - below).max_abs() / below.max_abs();
    assert!(apart < 1e-9, "{name}: {apart:e}");
}

#[test]
fn tangent_vectors_of_momenta_are_images_of_those_of_lifted_states() {
    tangent_vectors_of_momenta_are_images(100);
}

#[test]
#[ignore = "long"]
fn tangent_vectors_of_longer_runs_are_images_of_those_of_lifted_states() {
    tangent_vectors_of_momenta_are_images(300);
}

fn tangent_vectors_of_momenta_are_images(steps: usize) {
    descends("particle", PARTICLE, particle(0.0), 5 * steps);
    descends("far particle", PARTICLE, particle(70.0), steps);
    descends("Hopf", HOPF, generic(), steps);
    descends("u(2)", unitary_realisation::<2>(), generic(), steps);
    let plane = QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), Side::Right);
    descends("sl(2)", plane, generic(), steps / 3);
}
