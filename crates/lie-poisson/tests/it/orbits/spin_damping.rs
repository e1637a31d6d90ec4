//! Spins with Gilbert's damping: the implicit equation, the loss of energy, and Landau and Lifshitz's form, in all
//! units.

use crate::support::{broken, holds, laws, samples};
use lie_poisson::*;
use nalgebra::Vector3;
use proptest::prelude::*;

type Spins = LiePoisson<PowerAlgebra<So3, 3>>;

/// h = −Σ s_i·s_(i+1) − s₁·B, over any scalar.
struct Chain {
    field: Vector3<f64>,
}

impl Energy for Chain {
    type Space = Spins;
    fn energy<T: Real>(&self, Covector(Power(s)): &Point<Spins, T>) -> T {
        let field: Vector3<T> = self.field.map(T::from_f64);
        -(s[0].dot(&s[1]) + s[1].dot(&s[2]) + s[0].dot(&field))
    }
}

fn spins(numbers: &[f64; 9], unit: f64) -> Covector<Power<Vector3<f64>, 3>> {
    Vector::from_coordinates(|i| numbers[i] * unit)
}

proptest! {
    #[test]
    fn gilberts_equation_holds(
        numbers in prop::array::uniform9(-2.0..2.0_f64),
        field in prop::array::uniform3(-1.0..1.0_f64),
        damping in 0.0..3.0_f64,
        power in -30..30_i32,
        is_plus: bool,
    ) {
        let unit = 10.0_f64.powi(power);
        let sign = if is_plus { Sign::Plus } else { Sign::Minus };
        let orientation = if is_plus { -1.0 } else { 1.0 };
        let space = LiePoisson::new(PowerAlgebra::<So3, 3>(So3), sign);
        let h = Automatic(Chain { field: Vector3::from(field) * unit });
        let damped = GilbertDamping::new(space, Autonomous(&h), damping).unwrap();
        let mu = spins(&numbers, unit);
        let dh: Power<Vector3<f64>, 3> = h.differential(&mu);
        let xi = damped.element(&mu, 0.0);
        let rates = space.hamiltonian_vector(&mu, &xi);
        let (mut loss, mut size) = (0.0, 0.0);
        for ((s, omega), rate) in mu.0.0.iter().zip(dh.0).zip(rates.0.0) {
            let torque = s.cross(&omega) * orientation;
            let gilbert = torque + s.cross(&rate) * (orientation * damping / s.norm());
            let largest = s.norm() * omega.norm();
            // Round-off of some ten operations.
            prop_assert!((rate - gilbert).norm() <= 1e-14 * (1.0 + damping) * largest);
            prop_assert!(rate.dot(s).abs() <= 1e-14 * largest * s.norm());
            // Control: another damping is no solution.
            let other = torque + s.cross(&rate) * (orientation * (damping + 0.1) / s.norm());
            prop_assert!((rate - other).norm() >= 0.09 * rate.norm());
            loss += damping / ((1.0 + damping * damping) * s.norm()) * torque.norm_squared();
            size += largest * omega.norm() * (1.0 + damping);
        }
        prop_assert!((rates.pairing(&dh) + loss).abs() <= 1e-14 * size);
        prop_assert!(loss >= 0.0);
    }

    /// For spins of one length both forms are double brackets, with the constants that the documentation gives.
    #[test]
    fn both_forms_have_one_field(
        numbers in prop::array::uniform3(-2.0..2.0_f64),
        omega in prop::array::uniform3(-2.0..2.0_f64),
        damping in 0.0..3.0_f64,
        power in -30..30_i32,
    ) {
        let unit = 10.0_f64.powi(power);
        let space = LiePoisson::minus(So3);
        let s = Covector(Vector3::from(numbers) * unit);
        let (length, omega) = (s.0.norm(), Vector3::from(omega));
        let slower = 1.0 + damping * damping;
        let gilbert = |field, damping| {
            let damped = GilbertDamping::new(space, Constant(field), damping).unwrap();
            space.hamiltonian_vector(&s, &damped.element(&s, 0.0)).0
        };
        let landau_lifshitz = |field, friction| {
            let inner_product = InnerProduct::euclidean();
            let damped =
                DoubleBracket::new(space, Constant(field), friction, inner_product).unwrap();
            space.hamiltonian_vector(&s, &damped.element(&s, 0.0)).0
        };
        let size = length * omega.norm() * slower;
        let difference = gilbert(omega, damping) - landau_lifshitz(omega / slower, damping / length);
        prop_assert!(difference.norm() <= 1e-14 * size);
        let friction = damping / length;
        let difference =
            landau_lifshitz(omega, friction) - gilbert(omega * slower, friction * length);
        prop_assert!(difference.norm() <= 1e-14 * size);
        // Control: with one field the precessions differ.
        let difference = gilbert(omega, damping) - landau_lifshitz(omega, friction);
        let torque = s.0.cross(&omega).norm();
        prop_assert!(difference.norm() >= 0.9 * (1.0 - 1.0 / slower) * torque);
    }

    /// Lanes have the bits of each spin alone, and a spin of length 0, or nearly so, stays as it is.
    #[test]
    fn lanes_and_powers_have_the_bits_of_each_spin(numbers in prop::array::uniform9(-2.0..2.0_f64)) {
        let omega = Vector3::new(0.3, -0.2, 0.9);
        let alone = GilbertDamping::new(LiePoisson::minus(So3), Constant(omega), 0.3).unwrap();
        let mut each: Vec<_> = numbers.chunks(3).map(Vector3::from_column_slice).collect();
        each.push(Vector3::zeros());
        each.push(Vector3::new(5e-324, 0.0, 0.0));
        let one = |s: &Vector3<f64>| alone.element(&Covector(*s), 0.0);
        prop_assert_eq!(one(&each[3]), omega * (1.0 / (1.0 + 0.3 * 0.3)));
        prop_assert!(one(&each[4]).iter().all(|x| x.is_finite()));
        let lanes = Vector3::from_fn(|k, _| DefaultLanes::from_lanes(|i| each[i % 4][k]));
        let together = alone.element(&Covector(lanes), DefaultLanes::from_f64(0.0));
        for i in 0..DefaultLanes::COUNT {
            prop_assert_eq!(together.map(|x| x.lane(i)), one(&each[i % 4]));
        }
        let several = PowerSpace::<_, 4>(LiePoisson::minus(So3));
        let field = GilbertDamping::new(several, Constant(omega), 0.3).unwrap();
        let points = Power::from_factors(|n| Covector(each[n]));
        let all = OrbitField::<PowerSpace<LiePoisson<So3>, 4>>::element(&field, &points, 0.0);
        for (n, s) in each.iter().take(4).enumerate() {
            prop_assert_eq!(all.0.0[n].0, one(s));
        }
    }
}

/// The same element of so(3) for each spin.
#[derive(Clone, Copy)]
struct Constant(Vector3<f64>);

impl<P: PoissonSpace, T: Real> OrbitField<P, T> for Constant {
    fn element(&self, _: &Point<P, T>, _: T) -> Differential<P, T> {
        Vector::from_coordinates(|i| T::from_f64(self.0[i % 3]))
    }
}

#[test]
fn laws_of_gilbert_damping() {
    let space = LiePoisson::minus(PowerAlgebra::<So3, 3>(So3));
    let h = Automatic(Chain { field: Vector3::new(0.1, 0.7, -0.2) });
    let damped = GilbertDamping::new(space, Autonomous(h), 0.4).unwrap();
    holds(laws::orbit_field(&space, &damped, (0.0, 1.0), &samples()).unwrap());
}

/// A double bracket of dh with the friction θ as Gilbert's equation with α = θ |s| and the field (1 + α²) dh, and one thing wrong.
#[derive(Clone, Copy, PartialEq)]
enum AsGilbert {
    Sound,
    /// α is not larger for longer spins.
    OneLength,
    /// The precession slows down.
    SlowsDown,
    /// The damping is that for the other bracket, and feeds energy.
    OtherBracket,
}

/// The form of Gilbert's equation with the friction θ.
struct WithFriction<'a, H>(AsGilbert, &'a H, f64);

impl<H: Hamiltonian<LiePoisson<So3>>> OrbitField<LiePoisson<So3>> for WithFriction<'_, H> {
    fn element(&self, s: &Covector<Vector3<f64>>, time: f64) -> Vector3<f64> {
        let Self(kind, h, friction) = *self;
        let length = if kind == AsGilbert::OneLength { 1.0 } else { s.0.norm() };
        let damping = friction * length;
        let faster = if kind == AsGilbert::SlowsDown { 1.0 } else { 1.0 + damping * damping };
        let sign = if kind == AsGilbert::OtherBracket { Sign::Plus } else { Sign::Minus };
        let field = Constant(h.differential(s) * faster);
        GilbertDamping::new(LiePoisson::new(So3, sign), field, damping).unwrap().element(s, time)
    }
}

/// As a double bracket, Gilbert's damping obeys the laws of these, which reject what breaks it.
#[test]
fn laws_of_gilbert_damping_reject_what_breaks_them() {
    const BOTH: [&str; 2] = ["loss of energy", "linear in the friction"];
    let (space, euclidean) = (LiePoisson::minus(So3), InnerProduct::euclidean());
    let h = from_closure::<LiePoisson<So3>, _>(|Covector(s)| s.x * s.y * 0.3 - s.z + s.x * s.x);
    let cases: [(AsGilbert, &[&str]); 4] = [
        (AsGilbert::Sound, &[]),
        (AsGilbert::OneLength, &BOTH),
        (AsGilbert::SlowsDown, &BOTH),
        (AsGilbert::OtherBracket, &BOTH),
    ];
    for (kind, expected) in cases {
        let field = |friction| WithFriction(kind, &h, friction);
        let report = laws::double_bracket(&space, &h, &euclidean, field, 0.7, &samples()).unwrap();
        assert_eq!(broken(&report), expected);
    }
    // A damped field has the breaks of the field that it damps.
    let table = InputTable::new(vec![0.0, 0.4, 1.0], vec![1.0, -0.5, 2.0], Interpolation::Linear);
    let inputs = Inputs::new(vec![(Vector3::new(0.3, 1.0, -0.4), table.unwrap())]).unwrap();
    let damped = GilbertDamping::new(space, inputs, 0.4).unwrap();
    for (field, expected) in [
        (laws::Faulty::without_fault(&damped), &[][..]),
        (laws::Faulty::new(&damped, "next_break", 0), &["smoothness"]),
    ] {
        let report = laws::orbit_field(&space, &field, (0.0, 1.0), &samples()).unwrap();
        assert_eq!(broken(&report), expected);
    }
}

#[test]
fn what_is_no_damping_is_refused() {
    let with =
        |damping| GilbertDamping::new(LiePoisson::minus(So3), Constant(Vector3::z()), damping);
    for damping in [-0.1, -f64::MIN_POSITIVE, f64::INFINITY, f64::NAN] {
        let error = with(damping).map(drop).unwrap_err();
        assert_eq!(error.damping.to_bits(), damping.to_bits());
    }
    assert_eq!(
        with(-0.1).map(drop).unwrap_err().to_string(),
        "the damping of spins is a finite number of at least 0, got -0.1"
    );
    for damping in [0.0, -0.0, 1e300] {
        let field = with(damping).unwrap();
        let xi = field.element(&Covector(Vector3::x()), 0.0);
        assert!(field.damping() == damping && xi.iter().all(|x: &f64| x.is_finite()));
    }
    assert_eq!(with(0.0).unwrap().element(&Covector(Vector3::x()), 0.0), Vector3::z());
}
