//! What wraps an integrator: the same bits over states on the heap as over small states.

use collective_integrators::{
    Alternating, Collective, CollectiveSites, Composition, Direct, ExactFlows, HamiltonianField,
    Integrator, LyapunovExponents, RungeKutta, SphericalMidpoint, Splitting, Start, StepError,
    Substeps, TangentIntegrator, TaoFlows, VariationalError, VariationalFlow, VectorField,
    fitted_order, smaller_alignment_index,
};
use lie_poisson::{Covector, LiePoisson, Pair, Power, PowerAlgebra, Sites, So3, State, larger};
use lie_poisson_systems::{HeisenbergLattice, ManyVortices, PointVortices, SpinSpace, Spins};
use momentum_map::{HOPF, PowerMap, QuadraticMomentumMap, Side, So3OnC2};
use nalgebra::{Vector2, Vector3};

const STRENGTHS: [f64; 3] = [1.0, -0.7, 1.5];
const STEP: f64 = 0.1;

type Many = Covector<Sites<Vector3<f64>>>;
type FewField = HamiltonianField<SpinSpace<3>, PointVortices<3>>;

fn few() -> FewField {
    let hamiltonian = PointVortices::new(STRENGTHS).unwrap();
    HamiltonianField { space: LiePoisson::minus(PowerAlgebra(So3)), hamiltonian }
}

fn many() -> ManyVortices {
    ManyVortices::new(STRENGTHS.to_vec()).unwrap()
}

fn start() -> Spins<3> {
    let x = [[1.0, 0.2, -0.3], [-0.4, 1.0, 0.5], [0.1, -0.8, 0.7]];
    few().hamiltonian.momentum(&x.map(|x| Vector3::from(x).normalize()))
}

fn heap(m: &Spins<3>) -> Many {
    Covector(m.0.0.into_iter().collect())
}

/// Asserts equal coordinates.
fn assert_same<V: State<Scalar = f64>, W: State<Scalar = f64>>(v: &V, w: &W) {
    assert_eq!(v.dimension(), w.dimension());
    (0..v.dimension()).for_each(|i| assert_eq!(v.coordinate(i), w.coordinate(i), "coordinate {i}"));
}

/// Asserts that steps by value and in place, and those of both integrators, have the same bits.
fn assert_same_run<I: Integrator, J: Integrator>(few: &I, many: &J, z: I::State, w: J::State) {
    let (mut z, mut w) = (z, w);
    let mut spaces = (few.workspace(), many.workspace(), many.workspace());
    for _ in 0..20 {
        let next = few.step(&z, STEP, &mut spaces.0).unwrap();
        let by_value = many.step(&w, STEP, &mut spaces.1).unwrap();
        let iterations = many.step_in_place(&mut w, STEP, &mut spaces.2).unwrap();
        z = next.point;
        assert_same(&z, &w);
        assert_same(&by_value.point, &w);
        assert_eq!([next.iterations, by_value.iterations], [iterations; 2]);
    }
    // A step that fails leaves the state.
    let kept = w.clone();
    let failed = many.step_in_place(&mut w, f64::NAN, &mut spaces.2);
    assert!(failed.is_err() && w == kept);
}

#[test]
fn compensated_sums() {
    let suzuki = |base| Composition::new(base, Substeps::suzuki4());
    let schemes = [RungeKutta::rk4(), RungeKutta::gauss(2).unwrap()];
    for scheme in schemes {
        let small = Direct::new(scheme.clone(), few()).compensated();
        let large = Direct::new(scheme.clone(), many()).compensated();
        let (z, w) = (start(), heap(&start()));
        let states = (Start::<f64>::start(&small, &z).unwrap(), large.start(&w).unwrap());
        assert_same_run(&small, &large, states.0, states.1);
        let small = Direct::new(suzuki(scheme.clone()), few()).compensated();
        let large = Direct::new(suzuki(scheme), many()).compensated();
        let states = (Start::<f64>::start(&small, &z).unwrap(), large.start(&w).unwrap());
        assert_same_run(&small, &large, states.0, states.1);
    }
}

#[test]
fn compositions_of_integrators() {
    let small = Composition::new(SphericalMidpoint::new(few()), Substeps::yoshida4());
    let large = Composition::new(SphericalMidpoint::new(many()), Substeps::yoshida4());
    assert_same_run(&small, &large, start(), heap(&start()));
}

/// Oscillators with H = (q⁴ + p²)/2, by value on a power of the plane and in place on the heap.
#[derive(Clone, Copy)]
struct Oscillators;
struct OnHeap;

fn kick(z: &mut Vector2<f64>, time: f64) {
    z.y -= 2.0 * time * z.x * z.x * z.x;
}

fn drift(z: &mut Vector2<f64>, time: f64) {
    z.x += time * z.y;
}

fn rate(z: &Vector2<f64>) -> Vector2<f64> {
    Vector2::new(z.y, -2.0 * z.x * z.x * z.x)
}

impl ExactFlows for Oscillators {
    type Point = Power<Vector2<f64>, 3>;
    const COUNT: usize = 2;

    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point {
        let mut z = *z;
        z.0.iter_mut().for_each(|z| if index == 0 { drift(z, time) } else { kick(z, time) });
        z
    }
}

impl ExactFlows for OnHeap {
    type Point = Sites<Vector2<f64>>;
    const COUNT: usize = 2;

    fn flow(&self, index: usize, time: f64, z: &Self::Point) -> Self::Point {
        let mut end = z.clone();
        self.flow_in_place(index, time, &mut end, &mut Vec::new());
        end
    }

    fn flow_in_place(
        &self,
        index: usize,
        time: f64,
        z: &mut Self::Point,
        _: &mut Vec<Self::Point>,
    ) {
        z.iter_mut().for_each(|z| if index == 0 { drift(z, time) } else { kick(z, time) });
    }
}

impl VectorField for Oscillators {
    type Point = Power<Vector2<f64>, 3>;

    fn at(&self, z: &Self::Point) -> Self::Point {
        Power(z.0.map(|z| rate(&z)))
    }
}

impl VectorField for OnHeap {
    type Point = Sites<Vector2<f64>>;

    fn at(&self, z: &Self::Point) -> Self::Point {
        z.iter().map(rate).collect()
    }
}

#[test]
fn splittings_and_the_method_of_tao() {
    let z = Power([Vector2::new(1.0, 0.0), Vector2::new(0.3, -0.5), Vector2::new(-1.2, 0.1)]);
    let w: Sites<_> = z.0.into_iter().collect();
    let (small, large) = (Splitting::strang(Oscillators), Splitting::strang(OnHeap));
    assert_same_run(&small, &large, z, w.clone());
    let small = Composition::new(small, Substeps::kahan_li6());
    let large = Composition::new(large, Substeps::kahan_li6());
    assert_same_run(&small, &large, z, w.clone());
    let small = Splitting::strang(TaoFlows::<_, Alternating>::new(Oscillators, 3.0));
    let large = Splitting::strang(TaoFlows::<_, Alternating>::new(OnHeap, 3.0));
    assert_same_run(&small, &large, Pair(z, z), Pair(w.clone(), w));
}

/// Returns the numbers of [`LyapunovExponents`] and of [`smaller_alignment_index`] after some steps.
fn chaos<I: TangentIntegrator>(integrator: &I, start: &<I as Integrator>::State) -> Vec<f64> {
    let mut spectrum = LyapunovExponents::<_, 4>::new(integrator, start.clone(), STEP);
    let last = spectrum.nth(30).unwrap().unwrap();
    let mut numbers = last.exponents.to_vec();
    let flow = spectrum.flow();
    numbers
        .extend(flow.tangents().iter().flat_map(|v| (0..v.dimension()).map(|i| v.coordinate(i))));
    let [v, w, ..] = flow.tangents();
    numbers.push(smaller_alignment_index(&[v.clone(), w.clone()]));
    numbers
}

#[test]
fn tangent_vectors_and_exponents() {
    let z = start();
    let small = SphericalMidpoint::new(few());
    let large = SphericalMidpoint::new(many());
    let numbers = chaos(&small, &z);
    assert_eq!(numbers, chaos(&large, &heap(&z)));
    assert!(numbers.iter().all(|x| x.is_finite()) && numbers[0] != 0.0);
    let small = Direct::new(RungeKutta::gauss(2).unwrap(), few());
    let large = Direct::new(RungeKutta::gauss(2).unwrap(), many());
    assert_eq!(chaos(&small, &z), chaos(&large, &heap(&z)));
}

#[test]
fn tangent_vectors_of_another_dimension_are_refused() {
    let midpoint = SphericalMidpoint::new(many());
    let tangent = Covector(Sites::new(vec![Vector3::x(); 2]));
    let mut flow = VariationalFlow::new(&midpoint, heap(&start()), [tangent], STEP);
    let refused = StepError::Dimension { expected: 9, found: 6 };
    let is_refused = |e| matches!(e, VariationalError::Integration(e) if e.source == refused);
    assert!(flow.advance().is_err_and(is_refused));
    assert_eq!(flow.steps(), 0);
}

/// Collective Gauss methods on copies of the Hopf map: few vortices by the power of the map, as many as one likes by sites.
#[test]
fn collective_vortices() {
    let gauss = || RungeKutta::gauss(2).unwrap();
    let small = Collective::new(gauss(), PowerMap::<_, 3>(HOPF), few().hamiltonian);
    let large = CollectiveSites::new(gauss(), HOPF, many());
    let (z, w) = (small.start(&start()).unwrap(), large.start(&heap(&start())).unwrap());
    assert_same_run(&small, &large, z, w);
    // On another way to the same solution: the difference is the error of both methods.
    let direct = Direct::new(RungeKutta::gauss(3).unwrap(), many());
    let end = |steps: u64| {
        let h = 8.0 / steps as f64;
        let collective = large.after(&heap(&start()), h, steps).unwrap().momentum;
        let mut apart = Start::<f64>::after(&direct, &heap(&start()), 0.02, 400).unwrap().state;
        apart.subtract_in_place(&collective);
        (h, apart.0.iter().map(|x| x.norm()).fold(0.0, larger))
    };
    let order = fitted_order(&[end(10), end(20), end(40)], 1e-12).unwrap();
    assert!((order - 4.0).abs() < 0.2, "{order}");
}

/// The lattice has the plus bracket: the Hopf map of the left action.
#[test]
fn collective_lattices() {
    let lattice = HeisenbergLattice::new([4, 3, 2]).unwrap();
    let lattice = lattice.with_exchange([1, 0, 1], 0.8).unwrap();
    let lattice = lattice.with_anisotropy(Vector3::z(), -0.3).unwrap();
    let spin = |i: usize| start().0.0[i % 3].normalize();
    let spins: Many = Covector((0..24).map(spin).collect());
    let end = |side: Side, steps: u64| {
        let map = QuadraticMomentumMap::new(So3OnC2, side);
        let gauss = CollectiveSites::new(RungeKutta::gauss(2).unwrap(), map, lattice.clone());
        gauss.after(&spins, 1.0 / steps as f64, steps).unwrap().momentum
    };
    let direct = Direct::new(RungeKutta::gauss(3).unwrap(), lattice.clone());
    let exact = Start::<f64>::after(&direct, &spins, 0.01, 100).unwrap().state;
    let error = |side, steps| {
        let mut apart = end(side, steps);
        apart.subtract_in_place(&exact);
        apart.0.iter().map(|x| x.norm()).fold(0.0, larger)
    };
    let errors = [10, 20, 40].map(|steps| (1.0 / steps as f64, error(Side::Left, steps)));
    let order = fitted_order(&errors, 1e-12).unwrap();
    assert!((order - 4.0).abs() < 0.2, "{order} {errors:?}");
    // control: the other bracket turns the spins the other way
    assert!(error(Side::Right, 40) > 0.1);
}
