//! From structure constants to a collective integrator, for every algebra of the list: the order of Gauss methods, and
//! whether their steps are maps of 𝔤∗.

use collective_integrators::{
    Collective, Direct, HamiltonianField, Integrator, RungeKutta, Start,
    diagnostics::step_poisson_defect, fitted_order,
};
use lie_poisson::{
    Automatic, Covector, Diagonal, Differential, Energy, ExtendedAdjoint, Hamiltonian,
    InfinitesimalAdjoint, LiePoisson, Point, PoissonSpace, Power, Real, Representation, Se3, So3,
    StructureConstants, Vector, larger, odd_power_defect,
};
use momentum_map::{ClebschRealisation, Cotangent, Lift, PoissonMap, Side, clebsch_realisation};
use nalgebra::SVector;
use workspace_tests::low_dimensional::{
    Check, Entry, WITHOUT_DERIVATION, coextended, every_algebra, extended, samples, table,
};

/// The round-off of a step and of its derivative, for numbers of size 1.
const ROUND_OFF: f64 = 1e-13;

/// A Hamiltonian on the dual of any algebra: a quadratic form with a cubic term.
#[derive(Clone, Copy)]
struct Generic<const N: usize>;

impl<const N: usize> Energy for Generic<N> {
    type Space = LiePoisson<StructureConstants<N>>;

    fn energy<T: Real>(&self, mu: &Covector<SVector<T, N>>) -> T {
        let term = |i: usize| mu.0[i] * mu.0[i] * (0.3 + 0.1 * i as f64);
        let squares = (0..N).fold(T::zero(), |sum, i| sum + term(i));
        squares + mu.0[0] * mu.0[N - 1] * 0.2 + mu.0[N - 1] * mu.0[N - 1] * mu.0[0] * 0.1
    }
}

/// The algebra [e₀, e₂] = e₀, [e₁, e₂] = e₁ + s e₀: A3,3 for s = 0 and A3,2 for s = 1.
fn dilation(s: f64) -> StructureConstants<3> {
    let upper = |i, j, k| match (i, j, k) {
        (0, 2, 0) | (1, 2, 1) => 1.0,
        (1, 2, 0) => s,
        _ => 0.0,
    };
    StructureConstants::new(|i, j, k| upper(i, j, k) - upper(j, i, k)).unwrap()
}

/// Returns the largest change of μ₁/μ₀ − s ln μ₀, the Casimir of these algebras, up to t = 4.
fn casimir_change(s: f64, step: f64) -> f64 {
    let map = clebsch_realisation(extended(&dilation(s)).unwrap(), Side::Right).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, Automatic(Generic));
    let casimir = |mu: &Covector<SVector<f64, 3>>| mu.0[1] / mu.0[0] - s * mu.0[0].ln();
    let start = Covector(SVector::<f64, 3>::new(0.8, 0.5, -0.3));
    let steps = (4.0 / step) as usize;
    gauss.trajectory(&start, step).unwrap().take(steps).fold(0.0, |most, sample| {
        larger(most, (casimir(&sample.unwrap().momentum) - casimir(&start)).abs())
    })
}

/// Finds the order from runs of these numbers of steps.
struct Orders(&'static [u64]);

fn order<R: Representation<Algebra = StructureConstants<N>>, const N: usize>(
    r: R,
    steps: &[u64],
) -> f64 {
    let map = clebsch_realisation(r, Side::Right).unwrap();
    let mu = samples::<Covector<SVector<f64, N>>>(1)[0];
    let field = HamiltonianField { space: map.target(), hamiltonian: Automatic(Generic) };
    let exact = Direct::new(RungeKutta::gauss(4).unwrap(), field).after(&mu, 0.025, 32).unwrap();
    let gauss = Collective::new(RungeKutta::gauss(2).unwrap(), map, Automatic(Generic));
    let error = |&steps: &u64| {
        let step = 0.8 / steps as f64;
        let end = gauss.after(&mu, step, steps).unwrap().momentum;
        (step, (end - exact.momentum).max_abs())
    };
    // The two longest steps are so long that z is lifted anew in some of the runs alone.
    fitted_order(&steps.iter().map(error).collect::<Vec<_>>(), 1e-14).unwrap()
}

impl Check for Orders {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0).unwrap();
        let order = if WITHOUT_DERIVATION.contains(&entry.name) {
            order(coextended(&algebra).unwrap(), self.0)
        } else {
            order(extended(&algebra).unwrap(), self.0)
        };
        assert!((order - 4.0).abs() < 0.4, "{}: {order}", entry.name);
    }
}

/// Structure constants in, collective integrator out: the Gauss method of order 4 has order 4 on every 𝔤∗.
#[test]
#[ignore = "long"]
fn collective_gauss_methods_have_their_order_on_all_algebras() {
    assert_eq!(every_algebra(&mut Orders(&[4, 8, 16])), 62);
}

#[test]
#[ignore = "long"]
fn collective_gauss_methods_have_their_order_at_four_steps() {
    assert_eq!(every_algebra(&mut Orders(&[4, 8, 16, 32])), 62);
}

/// On A3,3, whose representation has its odd powers, the Gauss method of order 4 keeps the Casimir to round-off. The
/// negative control is A3,2, whose representation lacks them: the Casimir changes by the error of the method.
#[test]
fn casimirs_are_kept_or_lost_to_the_order_of_the_scheme() {
    let steps = [0.2, 0.1, 0.05, 0.025];
    for step in steps {
        assert!(casimir_change(0.0, step) < ROUND_OFF, "{:e}", casimir_change(0.0, step));
    }
    let lost = steps.map(|step| (step, casimir_change(1.0, step)));
    println!("{lost:?}");
    assert!(lost[0].1 > 1e5 * ROUND_OFF, "{lost:?}");
    let order = fitted_order(&lost, 1e-14).unwrap();
    assert!((order - 4.0).abs() < 0.4, "{order} {lost:?}");
}

/// The Hamiltonian 0 on every space.
#[derive(Clone, Debug, PartialEq)]
struct Rest;

impl<P: PoissonSpace> Hamiltonian<P> for Rest {
    fn value(&self, _: &Point<P, f64>) -> f64 {
        0.0
    }

    fn differential(&self, _: &Point<P, f64>) -> Differential<P, f64> {
        Vector::zero()
    }
}

/// The constructor asks the map whether the steps descend.
#[test]
fn the_constructor_knows_whether_steps_descend() {
    let scheme = || RungeKutta::gauss(2).unwrap();
    let so3 = clebsch_realisation(InfinitesimalAdjoint(So3), Side::Right).unwrap();
    let se3 = clebsch_realisation(InfinitesimalAdjoint(Se3::default()), Side::Right).unwrap();
    assert!(Collective::new(scheme(), so3.clone(), Rest).descends());
    assert!(Collective::new(scheme(), se3, Rest).descends());
    assert!(!Collective::that_does_not_descend(scheme(), so3, Rest).descends());
    let of = |s| clebsch_realisation(extended(&dilation(s)).unwrap(), Side::Right).unwrap();
    assert!(Collective::new(scheme(), of(0.0), Rest).descends());
    assert!(!Collective::new(scheme(), of(1.0), Rest).descends());
    assert!(!Collective::that_does_not_descend(scheme(), of(1.0), Rest).descends());
}

#[derive(Default)]
struct Descent {
    descends: Vec<&'static str>,
    largest_defect: f64,
    least_control: Option<f64>,
}

/// Returns the Poisson defect of a step, and the difference of the steps from two points of one fibre.
fn descent<R: Representation<Algebra = StructureConstants<N>>, const N: usize>(r: R) -> [f64; 2] {
    let one: ClebschRealisation<R> = clebsch_realisation(r.clone(), Side::Right).unwrap();
    let two = clebsch_realisation(Diagonal::<_, 2>(r), Side::Right).unwrap();
    let mu = samples::<Covector<SVector<f64, N>>>(2)[1];
    let space = two.target();
    let z = one.lift::<f64>(&mu).unwrap();
    let embedded =
        Cotangent::new(Power([z.q, Vector::zero()]), Covector(Power([z.p.0, Vector::zero()])));
    let scheme = RungeKutta::gauss(2).unwrap();
    let gauss = Collective::that_does_not_descend(scheme, two, Automatic(Generic));
    let image = |z| {
        let end = Integrator::<f64>::step(&gauss, &z, 0.3, &mut gauss.workspace()).unwrap();
        Integrator::<f64>::momentum(&gauss, &end.point)
    };
    let start = Start::<f64>::start(&gauss, &mu).unwrap();
    let difference = (image(embedded) - image(start)).max_abs();
    [step_poisson_defect(&space, &gauss, &mu, 0.3).unwrap(), difference]
}

impl Check for Descent {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        if WITHOUT_DERIVATION.contains(&entry.name) {
            return;
        }
        let algebra = table::<N>(entry, 1.0).unwrap();
        let r = ExtendedAdjoint::of(algebra).unwrap();
        let closed = odd_power_defect(&r) < 1e-13;
        let [poisson, difference] = descent(r);
        if closed {
            self.descends.push(entry.name);
            self.largest_defect = larger(self.largest_defect, larger(poisson, difference));
        } else {
            let least = self.least_control.map_or(difference, |least| least.min(difference));
            self.least_control = Some(least);
        }
    }
}

/// Where the odd powers of the representation belong to it, a step depends on μ alone and is a Poisson map of 𝔤∗.
/// Elsewhere it depends on the point of the fibre.
#[test]
fn steps_descend_if_odd_powers_stay_in_the_representation() {
    let mut check = Descent::default();
    every_algebra(&mut check);
    println!("{:?}, {:e}, {:?}", check.descends, check.largest_defect, check.least_control);
    assert!(check.largest_defect < ROUND_OFF, "{:e}", check.largest_defect);
    // The difference is an error of order 5 of the step 0.3, and a thousand times the round-off.
    assert!(check.least_control.unwrap() > 1e3 * ROUND_OFF, "{:?}", check.least_control);
    let expected = [
        "A2,1", "A3,1", "A3,3", "A3,4", "A3,6", "A3,8", "A3,9", "A4,1", "A4,8", "A4,10", "A4,12",
        "A5,1", "A5,3", "A5,4", "A5,5",
    ];
    assert_eq!(check.descends, expected);
}
