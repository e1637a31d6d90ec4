//! Clebsch maps and their lifts, for every real Lie algebra of dimension up to 5 of a published list.

use lie_poisson::{
    Contragredient, Covector, DefaultLanes, Diagonal, DualNumber, InfinitesimalAdjoint, Lanes,
    LieAlgebra, LiePoisson, Real, Representation, Sign, State, StructureConstants, StructureError,
    Vector, euclidean_norm, larger, laws,
};
use momentum_map::{
    ClebschMap, Lift, PoissonMap, Side, SourcePoint, TargetPoint, clebsch_map, clebsch_realisation,
    laws as map_laws,
};
use nalgebra::SVector;
use workspace_tests::low_dimensional::{
    Check, Entry, FIVE, THREE, WITHOUT_DERIVATION, coextended, every_algebra, extended, samples,
    table,
};

/// The round-off of a bracket, a sum of up to 60 products of numbers up to 3, relative to the sizes of its factors.
const ROUND_OFF: f64 = 1e-13;

struct Jacobi {
    refused: usize,
}

impl Check for Jacobi {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0);
        assert!(algebra.is_ok(), "{}: {:?}", entry.name, algebra.err());
        let (algebra, n) = (algebra.unwrap(), N);
        let c = |i, j, k| algebra.constant(i, j, k);
        assert!(entry.brackets.iter().all(|(i, j, _)| i < j && *j <= n), "{}", entry.name);
        // Negative control: [e₀, e₁] and [e_(N−1), e₀] with another coordinate.
        let spoilt = StructureConstants::<N>::new(|i, j, k| match (i, j, k) {
            (0, 1, 1) => c(i, j, k) + 0.5,
            (1, 0, 1) => c(i, j, k) - 0.5,
            (0, j, k) if j + 1 == n && k == j => c(i, j, k) + 0.3,
            (i, 0, k) if i + 1 == n && k == i => c(i, j, k) - 0.3,
            _ => c(i, j, k),
        });
        self.refused += usize::from(matches!(spoilt, Err(StructureError::Jacobi { .. })));
    }
}

/// The list has 1 + 9 + 12 + 40 entries, and the constructor accepts them all. It refuses most of them with two constants
/// changed.
#[test]
fn all_62_tables_are_lie_algebras() {
    let mut check = Jacobi { refused: 0 };
    assert_eq!(every_algebra(&mut check), 62);
    println!("{} of 62 spoilt tables are refused", check.refused);
    assert!(check.refused > 50, "{}", check.refused);
}

/// A Clebsch map that claims the other sign of the bracket.
#[derive(Clone)]
struct WrongSign<R>(ClebschMap<R>);

impl<R: Representation> PoissonMap for WrongSign<R> {
    type Source = <ClebschMap<R> as PoissonMap>::Source;
    type Target = LiePoisson<R::Algebra>;

    fn source(&self) -> Self::Source {
        self.0.source()
    }

    fn target(&self) -> Self::Target {
        LiePoisson::new(self.0.target().algebra().clone(), Sign::Minus)
    }

    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        self.0.apply::<T>(z)
    }
}

#[derive(Default)]
struct PoissonDefects {
    worst: f64,
    least_control: Option<f64>,
}

impl PoissonDefects {
    fn representation<R: Representation>(&mut self, r: R) {
        let represented = laws::representation(&r, &samples(3), &samples(3)).unwrap();
        represented.check(ROUND_OFF).unwrap();
        for side in [Side::Left, Side::Right] {
            let report = map_laws::poisson_map(&clebsch_map(r.clone(), side), &samples(3)).unwrap();
            report.check(ROUND_OFF).unwrap();
            self.worst = larger(self.worst, report.residual("Poisson").unwrap());
        }
    }

    /// Negative control: the other sign of the bracket. (Where J reaches only momenta with Λ = 0, both are right.)
    fn control<R: Representation>(&mut self, name: &str, r: R) {
        let wrong = map_laws::poisson_map(&WrongSign(clebsch_map(r, Side::Left)), &samples(3));
        let control = wrong.unwrap().residual("Poisson").unwrap();
        assert!(control > 1e-3, "{name}: {control:e}");
        self.least_control = Some(self.least_control.map_or(control, |least| least.min(control)));
    }
}

impl Check for PoissonDefects {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0).unwrap();
        let adjoint = InfinitesimalAdjoint(algebra.clone());
        self.representation(Diagonal::<_, 2>(adjoint.clone()));
        self.representation(Contragredient(adjoint.clone()));
        self.representation(adjoint);
        self.representation(extended(&algebra).unwrap());
        self.representation(coextended(&algebra).unwrap());
        if WITHOUT_DERIVATION.contains(&entry.name) {
            self.control(entry.name, coextended(&algebra).unwrap());
        } else {
            self.control(entry.name, extended(&algebra).unwrap());
        }
    }
}

/// {J_i, J_j} = Λ_ij∘J for one copy of 𝔤, for two, for 𝔤∗, and for two copies of the extensions, on both sides.
#[test]
#[ignore = "long"]
fn clebsch_maps_of_all_algebras_are_poisson() {
    let mut check = PoissonDefects::default();
    assert_eq!(every_algebra(&mut check), 62);
    println!("Poisson defect {:e}, of the wrong sign {:?}", check.worst, check.least_control);
}

#[derive(Default)]
struct Lifts {
    worst: f64,
}

impl Lifts {
    fn representation<R: Representation>(&mut self, name: &str, r: R) {
        let map = clebsch_realisation(r, Side::Right).unwrap();
        assert_eq!(map.fibres().rank(), R::Algebra::dimension(), "{name}");
        let momenta = samples::<TargetPoint<ClebschMap<R>>>(3);
        let report = map_laws::lift(&map, &momenta).unwrap();
        report.check(ROUND_OFF).unwrap();
        self.worst = larger(self.worst, report.residual("section").unwrap());
        for mu in momenta {
            for size in [1e-30, 1.0, 1e30] {
                let mu = mu.scaled(size);
                let z = map.lift::<f64>(&mu).unwrap();
                let residual = (map.apply::<f64>(&z) - mu).max_abs() / size;
                assert!(residual < ROUND_OFF, "{name}, {size:e}: {residual:e}");
                let (q, p) = (euclidean_norm(&z.q), euclidean_norm(&z.p));
                assert!((q / p - 1.0).abs() < ROUND_OFF, "{name}: |q| = {q:e}, |p| = {p:e}");
            }
        }
    }
}

/// The dimension of an algebra.
trait Dimension: LieAlgebra {
    fn dimension() -> usize {
        <Self::Element<f64> as Vector>::DIM
    }
}

impl<A: LieAlgebra> Dimension for A {}

impl Check for Lifts {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        // Structure constants of every size: the units of 𝔤 may be of any size, too.
        for scale in [1e-30, 1.0, 1e30] {
            let algebra = table::<N>(entry, scale).unwrap();
            if WITHOUT_DERIVATION.contains(&entry.name) {
                let rank = clebsch_realisation(extended(&algebra).unwrap(), Side::Right).unwrap();
                assert_eq!(rank.fibres().rank(), N - 1, "{}", entry.name);
                self.representation(entry.name, coextended(&algebra).unwrap());
            } else {
                self.representation(entry.name, extended(&algebra).unwrap());
            }
        }
    }
}

/// Two copies of an extension reach all of 𝔤∗, for momenta and structure constants of every size.
#[test]
fn every_momentum_of_all_algebras_has_a_lift() {
    let mut check = Lifts::default();
    assert_eq!(every_algebra(&mut check), 62);
    println!("largest residual of the lifts {:e}", check.worst);
}

#[derive(Default)]
struct Centres {
    with_centre: usize,
    by_one_copy: usize,
}

impl Check for Centres {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra = table::<N>(entry, 1.0).unwrap();
        let adjoint = InfinitesimalAdjoint(algebra);
        let many = clebsch_realisation(Diagonal::<_, 5>(adjoint.clone()), Side::Left).unwrap();
        let one = clebsch_realisation(adjoint, Side::Left).unwrap();
        for mu in samples(3) {
            if many.fibres().rank() < N {
                let errors =
                    [one.lift::<f64>(&mu).unwrap_err(), many.lift::<f64>(&mu).unwrap_err()];
                for error in errors {
                    assert!(error.value > 1e-3, "{}: {error}", entry.name);
                    assert!(error.to_string().contains("not in the image"), "{error}");
                }
            } else {
                let outside = entry.name == "A5,37" && half(&mu) < 0.0;
                match one.lift::<f64>(&mu) {
                    Ok(z) => assert!((one.apply::<f64>(&z) - mu).max_abs() < ROUND_OFF),
                    Err(error) => assert!(outside, "{}: {error}", entry.name),
                }
            }
        }
        let centre = many.fibres().rank() < N;
        self.with_centre += usize::from(centre);
        self.by_one_copy += usize::from(!centre);
    }
}

/// Returns μ₂² + μ₃² + 2μ₁μ₅, whose sign is an invariant of the coadjoint orbits of A5,37.
fn half<const N: usize>(mu: &Covector<SVector<f64, N>>) -> f64 {
    let [a, b, c, d] = [0, 1, 2, 4].map(|i| mu.coordinate(i));
    b * b + c * c + 2.0 * a * d
}

/// The plain Clebsch map of one copy reaches an open set of momenta of every algebra without a centre, and no number of
/// copies reaches a momentum that does not vanish on the centre.
#[test]
#[ignore = "long"]
fn one_copy_reaches_an_open_set_if_there_is_no_centre() {
    let mut check = Centres::default();
    assert_eq!(every_algebra(&mut check), 62);
    assert_eq!((check.with_centre, check.by_one_copy), (18, 44));
}

/// One copy need not reach almost all momenta. A generic q of A5,37 commutes with a conjugate of the span of e₄ and e₅.
/// So J(q, p) vanishes there, and its orbit contains a point with μ₅ = 0, where the invariant is μ₂² + μ₃².
#[test]
fn one_copy_of_a537_reaches_one_of_two_halves() {
    let algebra = table::<5>(&FIVE[36], 1.0).unwrap();
    assert_eq!(FIVE[36].name, "A5,37");
    let one = clebsch_realisation(InfinitesimalAdjoint(algebra.clone()), Side::Left).unwrap();
    let two = clebsch_realisation(Diagonal::<_, 2>(InfinitesimalAdjoint(algebra)), Side::Left);
    let two = two.unwrap();
    let momenta = samples::<Covector<SVector<f64, 5>>>(60);
    for mu in &momenta {
        assert_eq!(one.lift::<f64>(mu).is_ok(), half(mu) > 0.0, "{mu:?}, {:e}", half(mu));
        assert!(two.lift::<f64>(mu).is_ok());
    }
    let inside = momenta.iter().filter(|mu| half(mu) > 0.0).count();
    assert!((10..=50).contains(&inside), "{inside}");
}

/// A SIMD lane has the bits of its own lift, and the lift over dual numbers is a section to first order.
#[test]
fn lifts_over_lanes_and_dual_numbers() {
    let so3 = table::<3>(&THREE[8], 1.0).unwrap();
    let one = clebsch_realisation(InfinitesimalAdjoint(so3.clone()), Side::Left).unwrap();
    let two = clebsch_realisation(extended(&so3).unwrap(), Side::Left).unwrap();
    let member = |lane: usize| samples::<Covector<SVector<f64, 3>>>(16)[lane % 16];
    let lanes = Covector::<SVector<DefaultLanes, 3>>::from_coordinates(|i| {
        DefaultLanes::from_lanes(|lane| member(lane).coordinate(i))
    });
    let (z, w) = (one.lift(&lanes).unwrap(), two.lift(&lanes).unwrap());
    for lane in 0..DefaultLanes::COUNT {
        let (alone, other) = (one.lift(&member(lane)).unwrap(), two.lift(&member(lane)).unwrap());
        assert!((0..6).all(|i| z.coordinate(i).lane(lane) == alone.coordinate(i)));
        assert!((0..16).all(|i| w.coordinate(i).lane(lane) == other.coordinate(i)));
    }
    let moved = Covector::<SVector<DualNumber, 3>>::from_coordinates(|i| {
        DualNumber::new(member(0).coordinate(i), member(1).coordinate(i))
    });
    for image in [one.apply(&one.lift(&moved).unwrap()), two.apply(&two.lift(&moved).unwrap())] {
        assert!((image - moved).max_abs() < ROUND_OFF, "{image:?} {moved:?}");
    }
}
