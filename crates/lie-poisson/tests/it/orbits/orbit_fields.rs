//! Orbit fields on so(3)∗, se(3)∗, so(4)∗ and u(3)∗ obey their laws in all units, and each law rejects something that
//! breaks it.

use crate::support::{broken, holds, laws, samples};
use laws::Faulty;
use lie_poisson::*;
use nalgebra::{DMatrix, Vector3};
use proptest::prelude::*;
use std::marker::PhantomData;

/// h = Σ kᵢ μᵢ μᵢ₊₁ + ½ Σ μᵢ².
pub(super) fn quadratic<V: Vector>(mu: &V) -> V::Scalar {
    let n = V::DIM;
    (0..n).fold(num_traits::zero(), |sum: V::Scalar, i| {
        let (x, next) = (mu.coordinate(i), mu.coordinate((i + 1) % n));
        sum + x * next * (0.3 + 0.1 * i as f64) + x * x * 0.5
    })
}

/// The energy h on the dual of any algebra.
struct Quadratic<A>(PhantomData<A>);

impl<A: LieAlgebra> Energy for Quadratic<A> {
    type Space = LiePoisson<A>;
    fn energy<T: Real>(&self, mu: &Momentum<A, T>) -> T {
        quadratic(mu)
    }
}

/// The energy (2 + sin(t/τ)) h.
pub(super) struct Oscillating<A>(pub(super) f64, pub(super) PhantomData<A>);

impl<A: LieAlgebra> Energy for Oscillating<A> {
    type Space = InTime<LiePoisson<A>>;
    fn energy<T: Real>(&self, Pair(mu, Time(t)): &Point<Self::Space, T>) -> T {
        ((*t / self.0).sin() + 2.0) * quadratic(mu)
    }
}

const SIGNS: &[Sign] = &[Sign::Plus, Sign::Minus];
const KINDS: &[Interpolation] =
    &[Interpolation::Constant, Interpolation::Linear, Interpolation::Cubic];

/// The units of momenta and of time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Units {
    momentum: f64,
    time: f64,
}

pub(super) const PLAIN: Units = Units { momentum: 1.0, time: 1.0 };

fn units() -> impl Strategy<Value = Units> {
    [-30..30_i32, -30..30_i32].prop_map(|powers| {
        let [momentum, time] = powers.map(|power| 10.0_f64.powi(power));
        Units { momentum, time }
    })
}

/// Returns inputs along two elements of 𝔤 from the time 0 to 3τ, one of them with the given interpolation.
pub(super) fn inputs<D: Vector<Scalar = f64>>(
    units: Units,
    interpolation: Interpolation,
) -> Inputs<D> {
    let table = |times: &[f64], values: &[f64], interpolation| {
        let times = times.iter().map(|t| t * units.time).collect();
        InputTable::new(times, values.to_vec(), interpolation).unwrap()
    };
    let tables = [
        table(&[0.0, 0.4, 1.0, 3.0], &[1.0, -0.5, 2.0, 0.7], interpolation),
        table(&[-1.0, 2.0, 4.0], &[0.2, 0.9, -0.8], Interpolation::Linear),
    ];
    let elements = samples::<D>().into_iter().map(|xi| xi.scaled(units.momentum));
    Inputs::new(elements.zip(tables).collect()).unwrap()
}

/// Returns the inner product of the matrix AAᵀ + 1 with entries of A below ½.
pub(super) fn weighted(size: usize) -> InnerProduct {
    let root = DMatrix::from_fn(size, size, |i, j| (i as f64 - 1.3 * j as f64).sin() * 0.5);
    let matrix = &root * root.transpose() + DMatrix::identity(size, size);
    InnerProduct::new(matrix.as_slice()).unwrap()
}

fn laws_hold<A>(space: LiePoisson<A>, numbers: &[f64], units: Units, interpolation: Interpolation)
where
    A: Casimirs + Clone,
{
    let mut numbers = numbers.iter().cycle().map(|x| x * units.momentum);
    let samples: Vec<Momentum<A>> =
        (0..2).map(|_| Vector::from_coordinates(|_| numbers.next().unwrap())).collect();
    let h = Automatic(Quadratic::<A>(PhantomData));
    let friction = 0.4 / units.momentum;
    let inner_product = weighted(Momentum::<A>::DIM);
    let damped = |friction| {
        let (space, inner_product) = (space.clone(), inner_product.clone());
        DoubleBracket::new(space, Autonomous(&h), friction, inner_product).unwrap()
    };
    holds(laws::double_bracket(&space, &h, &inner_product, damped, friction, &samples).unwrap());
    let oscillating = TimeDependent(Automatic(Oscillating::<A>(units.time, PhantomData)));
    let control = inputs(units, interpolation);
    let controlled = Controlled { field: oscillating, control };
    let field =
        DoubleBracket::new(space.clone(), controlled, friction, inner_product.clone()).unwrap();
    for (begin, end) in [(0.0, 3.0), (2.5, 0.1)].map(|(a, b)| (a * units.time, b * units.time)) {
        holds(laws::orbit_field(&space, &field, (begin, end), &samples).unwrap());
    }
}

/// Coordinates of two momenta, units, a sign, and an interpolation of inputs.
fn cases() -> impl Strategy<Value = ([f64; 18], Units, Sign, Interpolation)> {
    let numbers = prop::array::uniform18(-2.0..2.0_f64);
    (numbers, units(), prop::sample::select(SIGNS), prop::sample::select(KINDS))
}

proptest! {
    #[test]
    fn laws_of_orbit_fields_of_rotations((numbers, units, sign, kind) in cases()) {
        laws_hold(LiePoisson::new(So3, sign), &numbers, units, kind);
    }

    #[test]
    fn laws_of_orbit_fields_of_motions((numbers, units, sign, kind) in cases()) {
        laws_hold(LiePoisson::new(Se3::default(), sign), &numbers, units, kind);
    }

    #[test]
    fn laws_of_orbit_fields_of_a_product((numbers, units, sign, kind) in cases()) {
        laws_hold(LiePoisson::new(ProductAlgebra(So3, So3), sign), &numbers, units, kind);
    }
}

/// The Casimirs are cubic here, and their derivatives take seconds.
#[test]
#[ignore = "long"]
fn laws_of_orbit_fields_of_unitary_matrices() {
    let numbers = core::array::from_fn::<f64, 18, _>(|i| 2.0 * (7.0 * i as f64 + 1.0).sin());
    let units =
        [PLAIN, Units { momentum: 1e-30, time: 1e30 }, Units { momentum: 1e30, time: 1e-30 }];
    for ((units, kind), sign) in units.into_iter().zip(KINDS).zip(SIGNS.iter().cycle()) {
        laws_hold(LiePoisson::new(UnitaryAlgebra::<3>, *sign), &numbers, units, *kind);
    }
}

/// The field (1, |t| or 0, 0) with a kink at 0, and one thing wrong.
#[derive(Clone, Copy, PartialEq)]
enum Kink {
    Sound,
    /// The field changes where its derivatives are sought.
    OtherOverDualNumbers,
    /// The kink is told in one direction of time alone.
    OneWay,
    /// The break is no later than the time.
    StandsStill,
    /// The break is elsewhere.
    Elsewhere,
}

impl<T: Real> OrbitField<LiePoisson<So3>, T> for Kink {
    fn element(&self, _: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        let is_other = *self == Self::OtherOverDualNumbers && time.as_f64().is_none();
        let first = T::from_f64(if is_other { 1.5 } else { 1.0 });
        Vector3::new(first, time.select_nonnegative(time, -time), T::zero())
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        match self {
            Self::OneWay if !forward => None,
            Self::StandsStill => Some(time),
            Self::Elsewhere => Some(0.1).filter(|t| if forward { *t > time } else { *t < time }),
            _ => Some(0.0).filter(|t| if forward { *t > time } else { *t < time }),
        }
    }
}

#[test]
fn laws_of_orbit_fields_reject_what_breaks_them() {
    let space = LiePoisson::minus(So3);
    let cases: [(Kink, &[&str]); 5] = [
        (Kink::Sound, &[]),
        (Kink::OtherOverDualNumbers, &["dual numbers"]),
        (Kink::OneWay, &["breaks"]),
        (Kink::StandsStill, &["breaks", "smoothness"]),
        (Kink::Elsewhere, &["smoothness"]),
    ];
    for (field, expected) in cases {
        let report = laws::orbit_field(&space, &field, (-1.0, 1.5), &samples()).unwrap();
        assert_eq!(broken(&report), expected);
    }
    // A kink need not be told where it is not reached.
    let report = laws::orbit_field(&space, &Kink::Elsewhere, (0.2, 1.5), &samples()).unwrap();
    assert_eq!(broken(&report), [""; 0]);
    let wrong = LiePoisson::minus(Faulty::new(&So3, "casimir_differential", 1));
    let report = laws::orbit_field(&wrong, &Still, (0.0, 1.0), &samples()).unwrap();
    assert_eq!(broken(&report), ["tangent to orbits"]);
    assert!(laws::orbit_field(&space, &Kink::Sound, (0.0, 1.0), &[]).is_err());
}

/// The constant field e₃ on any algebra.
struct Still;

impl<A: LieAlgebra, T: Real> OrbitField<LiePoisson<A>, T> for Still {
    fn element(&self, _: &Momentum<A, T>, _: T) -> A::Element<T> {
        Vector::basis(2)
    }
}

/// Inputs that tell no breaks are refused, whatever their interpolation: the third derivative of a spline jumps.
#[test]
fn silent_inputs_are_refused() {
    let space = LiePoisson::minus(So3);
    let mut last = f64::INFINITY;
    for interpolation in [Interpolation::Constant, Interpolation::Linear, Interpolation::Cubic] {
        let inputs: Inputs<Vector3<f64>> = inputs(PLAIN, interpolation);
        let check =
            |inputs: Faulty<_>| laws::orbit_field(&space, &inputs, (0.0, 3.0), &samples()).unwrap();
        holds(check(Faulty::without_fault(&inputs)));
        let jump = check(Faulty::new(&inputs, "next_break", 0)).residual("smoothness").unwrap();
        assert!(jump < last && jump > 1e-9, "{interpolation}: {jump}");
        last = jump;
    }
}

/// A field, and μ, along which nothing moves on so(3)∗.
struct Extra<X>(X);

impl<T: Real, X: OrbitField<LiePoisson<So3>, T>> OrbitField<LiePoisson<So3>, T> for Extra<X> {
    fn element(&self, mu: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        self.0.element(mu, time) + mu.0
    }
}

#[test]
fn laws_of_double_brackets_reject_what_breaks_them() {
    const BOTH: [&str; 2] = ["loss of energy", "linear in the friction"];
    let space = LiePoisson::minus(So3);
    let h = from_closure::<LiePoisson<So3>, _>(quadratic);
    let [euclidean, weighted] = [InnerProduct::euclidean(), weighted(3)];
    let of = |space: LiePoisson<So3>, inner_product: &InnerProduct, friction: f64| {
        let inner_product = inner_product.clone();
        DoubleBracket::new(space, Autonomous(&h), friction, inner_product).unwrap()
    };
    // The friction is θ^power, and with the other bracket it feeds energy.
    let cases: [(LiePoisson<So3>, i32, &InnerProduct, &[&str]); 4] = [
        (space, 1, &weighted, &[]),
        (LiePoisson::plus(So3), 1, &weighted, &BOTH),
        (space, 2, &weighted, &BOTH),
        (space, 1, &euclidean, &BOTH),
    ];
    for (damped, power, inner_product, expected) in cases {
        let field = |friction: f64| of(damped, inner_product, friction.powi(power));
        let report = laws::double_bracket(&space, &h, &weighted, field, 0.7, &samples());
        assert_eq!(broken(&report.unwrap()), expected);
    }
    let none =
        laws::double_bracket(&space, &h, &weighted, |theta| of(space, &weighted, theta), 0.7, &[]);
    assert!(none.is_err());
    let extra = |friction| Extra(of(space, &weighted, friction));
    let report = laws::double_bracket(&space, &h, &weighted, extra, 0.7, &samples());
    assert_eq!(broken(&report.unwrap()), ["linear in the friction"]);
    // With Λ that is not antisymmetric the energy does something else.
    let algebra = Faulty::new(&So3, "coadjoint", 1);
    let space = LiePoisson::minus(algebra);
    let h = from_closure::<LiePoisson<Faulty<So3>>, _>(quadratic);
    let field = |friction| {
        DoubleBracket::new(space.clone(), Autonomous(&h), friction, weighted.clone()).unwrap()
    };
    let report = laws::double_bracket(&space, &h, &weighted, field, 0.7, &samples());
    assert_eq!(broken(&report.unwrap()), ["loss of energy"]);
}

/// Friction that would feed energy, or is no number, is refused by all that have it.
#[test]
fn friction_that_is_negative_or_no_number_is_refused() {
    let space = LiePoisson::minus(So3);
    let bracket = |friction| DoubleBracket::new(space, (), friction, InnerProduct::euclidean());
    for friction in [-1e-300, f64::NEG_INFINITY, f64::INFINITY, f64::NAN] {
        let error = bracket(friction).unwrap_err();
        assert!(matches!(error, DissipationError::Friction { friction: found }
            if found.to_bits() == friction.to_bits()));
        let noise = IsotropicNoise::thermal(InnerProduct::euclidean(), (friction, 1.0));
        assert_eq!(noise.unwrap_err().to_string(), error.to_string());
        assert!(GilbertDamping::new(space, (), friction).is_err());
    }
    assert!(bracket(0.0).is_ok() && bracket(f64::MAX).is_ok());
}
