//! The closed forms of actions and of quadratic momentum maps, compared with what follows from `act` by dual numbers.

use crate::support::faulty::FaultyRotations;
use crate::support::{holds, laws, samples};
use lie_poisson::*;
use momentum_map::*;
use nalgebra::{Vector2, Vector3};
use num_complex::Complex;
use proptest::prelude::*;

/// An action of which only `act` is known: generators, momenta and lifts are derived by dual numbers.
#[derive(Clone)]
struct Derived<A>(A);

impl<A: GroupAction> GroupAction for Derived<A> {
    type Group = A::Group;
    type Space = A::Space;
    const SIDE: Side = A::SIDE;
    fn group(&self) -> A::Group {
        self.0.group()
    }
    fn space(&self) -> A::Space {
        self.0.space()
    }
    fn act<T: Real>(&self, g: &ActingElement<A, T>, q: &ActionPoint<A, T>) -> ActionPoint<A, T> {
        self.0.act::<T>(g, q)
    }
}

/// The round-off of sums of a dozen products.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// Returns the largest relative difference of the closed forms from the derived ones, at ξ and (q, p).
fn deviation<A: GroupAction>(action: &A, xi: &Generator<A>, z: &Cotangent<ActionPoint<A>>) -> f64 {
    let derived = Derived(action.clone());
    let generator = action.infinitesimal_generator::<f64>(xi, &z.q)
        - derived.infinitesimal_generator::<f64>(xi, &z.q);
    let lifted = action.lifted_generator::<f64>(xi, z) - derived.lifted_generator::<f64>(xi, z);
    let momentum = action.momentum::<f64>(z) - derived.momentum::<f64>(z);
    let pulled = MomentumMap(action.clone()).pull_back::<f64>(xi, z)
        - by_dual_numbers(&MomentumMap(derived), xi, z);
    let (size, speed) = (1.0 + z.max_abs(), xi.max_abs().max(f64::MIN_POSITIVE));
    let deviations = [
        generator.max_abs() / (size * speed),
        lifted.max_abs() / (size * speed),
        momentum.max_abs() / (size * size),
        pulled.max_abs() / (size * speed),
    ];
    deviations.into_iter().fold(0.0, larger)
}

/// Returns the pull-back as the transposed tangent map of `apply`.
fn by_dual_numbers<M: PoissonMap>(
    map: &M,
    alpha: &TargetDifferential<M>,
    z: &SourcePoint<M>,
) -> Differential<M::Source> {
    let apply = |z: &SourcePoint<M, DualNumber>| map.apply::<DualNumber>(z);
    transposed_tangent(apply, z, alpha)
}

/// Compares the closed forms with the derived ones for the given coordinates, at zero, near it and far from it.
fn agree<A: GroupAction>(action: &A, coordinates: &[f64]) -> Result<(), TestCaseError> {
    let at = |i: usize| coordinates[i % coordinates.len()];
    for (near, far) in [(0.0, 1.0), (1e-8, 1.0), (1.0, 0.0), (1.0, 1e-8), (1.0, 1.0), (50.0, 3.0)] {
        let xi: Generator<A> = Vector::from_coordinates(|i| near * at(i));
        let z: Cotangent<ActionPoint<A>> = Vector::from_coordinates(|i| far * at(i + 7));
        let deviation = deviation(action, &xi, &z);
        prop_assert!(deviation <= ROUND_OFF, "{near} {far}: {deviation:e}");
    }
    Ok(())
}

/// Compares the forms of an action and of its opposite.
fn both_sides<A: GroupAction>(action: &A, coordinates: &[f64]) -> Result<(), TestCaseError> {
    agree(action, coordinates)?;
    agree(&Opposite(action.clone()), coordinates)
}

/// The coordinates of ξ, q and p, which are used in turn.
fn coordinates() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-2.0..2.0, 23)
}

fn linear_actions_agree(x: &[f64]) -> Result<(), TestCaseError> {
    both_sides(&LinearAction(SO2OnR2), x)?;
    both_sides(&LinearAction(SO3OnR3), x)?;
    both_sides(&LinearAction(SL2OnR2), x)?;
    both_sides(&LinearAction(SU2OnC2), x)?;
    both_sides(&LinearAction(UnitaryOnComplexSpace::<2>), x)?;
    both_sides(&LinearAction(SP1OnQuaternions::<2>), x)?;
    both_sides(&LinearAction(Adjoint(SL2)), x)?;
    both_sides(&LinearAction(Sum(SU2OnC2, Adjoint(SU2))), x)?;
    Ok(())
}

fn affine_actions_agree(x: &[f64]) -> Result<(), TestCaseError> {
    both_sides(&AffineAction(SO2OnR2), x)?;
    both_sides(&AffineAction(Diagonal::<_, 2>(SO3OnR3)), x)?;
    both_sides(&AffineAction(SU2OnC2), x)?;
    let inherited = Inherited { quotient: SO3OnR3, representation: SO3OnR3 };
    both_sides(&AffineAction(inherited), x)?;
    Ok(())
}

fn actions_on_products_agree(x: &[f64]) -> Result<(), TestCaseError> {
    both_sides(&ProductAction(AffineAction(SO2OnR2), LinearAction(SU2OnC2)), x)?;
    let nested = ProductAction(Opposite(AffineAction(SL2OnR2)), Opposite(LinearAction(SO2OnR2)));
    both_sides(&nested, x)?;
    Ok(())
}

/// The lift of an action is an action with closed forms of its own.
fn cotangent_lifts_agree(x: &[f64]) -> Result<(), TestCaseError> {
    both_sides(&CotangentLift(AffineAction(SO2OnR2)), x)?;
    both_sides(&CotangentLift(LinearAction(SO3OnR3)), x)?;
    Ok(())
}

/// J(z) has the components ½ Ω(ξ_P z, z), and its pull-back is the transposed derivative.
fn quadratic_momentum_maps_agree(x: &[f64]) -> Result<(), TestCaseError> {
    for side in [Side::Left, Side::Right] {
        quadratic(&QuadraticMomentumMap::new(So3OnC2, side), x)?;
        quadratic(&QuadraticMomentumMap::new(SU2OnC2, side), x)?;
        quadratic(&QuadraticMomentumMap::new(UnitaryOnComplexSpace::<3>, side), x)?;
        quadratic(&QuadraticMomentumMap::new(Sum(SL2OnR2, Reversed(SL2OnR2)), side), x)?;
        quadratic(&QuadraticMomentumMap::new(Diagonal::<_, 3>(SL2OnR2), side), x)?;
    }
    Ok(())
}

proptest! {
    #[test]
    fn linear_actions(x in coordinates()) {
        linear_actions_agree(&x)?;
    }

    #[test]
    fn affine_actions(x in coordinates()) {
        affine_actions_agree(&x)?;
    }

    #[test]
    fn actions_on_products(x in coordinates()) {
        actions_on_products_agree(&x)?;
    }

    #[test]
    fn cotangent_lifts(x in coordinates()) {
        cotangent_lifts_agree(&x)?;
    }

    #[test]
    fn quadratic_momentum_maps(x in coordinates()) {
        quadratic_momentum_maps_agree(&x)?;
    }
}

/// Products and powers pull back by their factors, whether these have closed forms or not.
/// (v·σ)(w·σ) = v·w + i (v×w)·σ, with σ₁ from the definition; and (T_α ϖ₂)ᵀ γ is the gradient of γ·ϖ₂.
#[test]
fn pauli_matrices_and_the_pull_back_of_the_hopf_map() {
    let (i, swap) = (Complex::<f64>::i(), |chi: &Vector2<Complex<f64>>| chi.yx());
    let vectors = [Vector3::new(0.3, -1.1, 0.7), Vector3::new(-0.4, 0.2, 1.9)];
    let [v, w] = vectors;
    let chi = Vector2::new(Complex::new(0.8, -0.5), Complex::new(1.3, 0.6));
    let both = pauli(&v, &pauli(&w, &chi));
    let expected = chi.map(|x| x * v.dot(&w)) + pauli(&v.cross(&w), &chi).map(|x| x * i);
    // A dozen products of numbers up to 4.
    assert!((both - expected).norm() < 1e-14, "{both} {expected}");
    assert_eq!(pauli(&Vector3::x(), &chi), swap(&chi));
    assert_eq!(pauli(&Vector3::z(), &chi), Vector2::new(chi.x, -chi.y));
    assert_eq!(pauli(&Vector3::y(), &chi), Vector2::new(-i * chi.y, i * chi.x));
    for gamma in vectors {
        let gradient = hopf_pull_back(&gamma, &chi);
        for k in 0..4 {
            let moved: Vector2<Complex<DualNumber>> = seed(&chi, &Vector::basis(k));
            let slope = hopf_map(&moved).map(|x| x.derivative()).dot(&gamma);
            assert!((gradient.coordinate(k) - slope).abs() < 1e-14, "{k}");
        }
    }
}

#[test]
fn products_of_maps() {
    let (spins, spin) = (PowerMap::<_, 3>(HOPF), QuadraticMomentumMap::new(So3OnC2, Side::Right));
    let canonical = Identity(CotangentBundle(RealSpace::<2>));
    pulls_back(&spins);
    pulls_back(&PowerMap::<_, 1>(PARTICLE));
    pulls_back(&ProductMap(spins, canonical));
    pulls_back(&ProductMap(ProductMap(canonical, PARTICLE), spin));
    pulls_back(&ProductMap(MomentumMap(Derived(LinearAction(SO3OnR3))), HOPF));
    pulls_back(&ProductAlgebraMap::new(HOPF, PARTICLE).unwrap());
    pulls_back(&ProductAlgebraMap::new(spin, ProductAlgebraMap::new(HOPF, spin).unwrap()).unwrap());
}

/// Compares the pull-back with the derivative by dual numbers at points of many sizes.
fn pulls_back<M: PoissonMap>(map: &M) {
    for (n, z) in samples::<SourcePoint<M>>().into_iter().enumerate() {
        for scale in [1e-30, 1e-3, 1.0, 1e30] {
            let z = z.scaled(scale);
            let alpha: TargetDifferential<M> =
                Vector::from_coordinates(|i| ((n + 2) as f64 * (i as f64 + 0.4)).sin());
            let error = map.pull_back::<f64>(&alpha, &z) - by_dual_numbers(map, &alpha, &z);
            let size = alpha.max_abs() * (1.0 + z.max_abs());
            assert!(error.max_abs() <= ROUND_OFF * size, "{n} {scale:e}: {:e}", error.max_abs());
        }
    }
}

fn quadratic<R: SymplecticRepresentation>(
    map: &QuadraticMomentumMap<R>,
    coordinates: &[f64],
) -> Result<(), TestCaseError> {
    let z: R::Space<f64> = Vector::from_coordinates(|i| coordinates[i % coordinates.len()]);
    let size = (1.0 + z.max_abs()) * (1.0 + z.max_abs());
    let j = map.apply::<f64>(&z);
    for i in 0..<RepresentedElement<R>>::DIM {
        let xi: RepresentedElement<R> = Vector::basis(i);
        let component = map.representation().form(&map.generator::<f64>(&xi, &z), &z) * 0.5;
        let error = (j.coordinate(i) - component).abs() / size;
        prop_assert!(error <= ROUND_OFF, "component {i}: {error:e}");
        let pulled = map.pull_back::<f64>(&xi, &z) - by_dual_numbers(map, &xi, &z);
        prop_assert!(pulled.max_abs() <= ROUND_OFF * size, "pull-back {i}");
    }
    let back = map.representation().sharp(&map.representation().flat(&z)) - z;
    prop_assert_eq!(back.max_abs(), 0.0);
    Ok(())
}

/// A negative control: each closed form with a wrong sign is seen by the comparison and by its own law.
#[test]
fn closed_forms_with_a_wrong_sign_are_refused() {
    let (xi, z): (Vec<Vector3<f64>>, Vec<Cotangent<Vector3<f64>>>) = (samples(), samples());
    for wrong in [FaultyRotations::Generator, FaultyRotations::Momentum, FaultyRotations::Lift] {
        assert!(deviation(&wrong, &xi[0], &z[1]) > 0.01);
    }
    let report =
        |action: &FaultyRotations| laws::cotangent_lift(action, &samples(), &samples()).unwrap();
    let laws = ["momentum", "lifted generator"];
    for (wrong, broken) in [(FaultyRotations::Momentum, laws[0]), (FaultyRotations::Lift, laws[1])]
    {
        let report = report(&wrong);
        for law in laws {
            assert_eq!(report.residual(law).unwrap() > 0.1, law == broken, "{law} of {broken}");
        }
    }
    holds(report(&FaultyRotations::Generator));
    let generator =
        laws::group_action(&FaultyRotations::Generator, &samples(), &samples()).unwrap();
    assert!(generator.residual("generator").unwrap() > 0.1);
}

/// Coordinates of q and of p are compared with those of one kind alone, block by block.
#[test]
fn positions_and_momenta_are_blocks_of_their_own() {
    fn blocks<V: Vector>() -> Vec<usize> {
        (0..V::DIM).map(|i| V::zero().block(i)).collect()
    }
    type Place = Pair<nalgebra::Vector1<f64>, Vector2<f64>>;
    assert_eq!(blocks::<Cotangent<Vector3<f64>>>(), [0, 0, 0, 1, 1, 1]);
    assert_eq!(blocks::<Cotangent<Place>>(), [0, 1, 1, 2, 3, 3]);
}
