//! Faulty twins of controlled fields and of fields with time, which the laws reject.

use super::orbit_fields::{Oscillating, PLAIN, inputs, quadratic, weighted};
use crate::support::{broken, laws, samples};
use laws::{Faulty, Report};
use lie_poisson::*;
use nalgebra::Vector3;
use std::marker::PhantomData;

/// A sum of two fields that tells the breaks of its first part alone.
struct HalfTold<X, U>(Controlled<X, U>);

impl<X, U, T: Real> OrbitField<LiePoisson<So3>, T> for HalfTold<X, U>
where
    X: OrbitField<LiePoisson<So3>, T>,
    U: OrbitField<LiePoisson<So3>, T>,
{
    fn element(&self, mu: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        OrbitField::<LiePoisson<So3>, T>::element(&self.0, mu, time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.field.next_break(time, forward)
    }
}

/// A controlled field has the breaks of both parts; and with the control θ (Λ dh)♯ it is a double bracket, whose suite sees every
/// coordinate of the control.
#[test]
fn laws_of_controlled_fields_reject_what_breaks_them() {
    let space = LiePoisson::minus(So3);
    let [one, other] =
        [Interpolation::Constant, Interpolation::Linear].map(|kind| inputs(PLAIN, kind));
    let check = |report: Result<Report, _>| broken(&report.unwrap());
    let times = (0.0, 2.8);
    for (field, control) in [(&one, &other), (&other, &one)] {
        let controlled = Controlled { field, control };
        assert_eq!(check(laws::orbit_field(&space, &controlled, times, &samples())), [""; 0]);
        // The breaks of the second part lie elsewhere.
        let control = Shifted(control, 0.125);
        let sum = || Controlled { field, control: Shifted(control.0, control.1) };
        assert_eq!(check(laws::orbit_field(&space, &sum(), times, &samples())), [""; 0]);
        let twin = HalfTold(sum());
        assert_eq!(check(laws::orbit_field(&space, &twin, times, &samples())), ["smoothness"]);
    }
    let h = from_closure::<LiePoisson<So3>, _>(quadratic);
    let inner_product = weighted(3);
    let bracket = |friction| {
        let (field, inner_product) = (Autonomous(&h), inner_product.clone());
        DoubleBracket::new(space, field, friction, inner_product).unwrap()
    };
    let suite = |fault| {
        let field = |friction| {
            let control = Friction { damped: bracket(friction), fault };
            Controlled { field: Autonomous(&h), control }
        };
        laws::double_bracket(&space, &h, &inner_product, field, 0.7, &samples())
    };
    assert_eq!(check(suite(None)), [""; 0]);
    for coordinate in 0..3 {
        assert_eq!(check(suite(Some(coordinate))), ["loss of energy", "linear in the friction"]);
    }
}

/// A field at later times.
struct Shifted<X>(X, f64);

impl<T: Real, X: OrbitField<LiePoisson<So3>, T>> OrbitField<LiePoisson<So3>, T> for Shifted<X> {
    fn element(&self, mu: &Covector<Vector3<T>>, time: T) -> Vector3<T> {
        self.0.element(mu, time + self.1)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.next_break(time + self.1, forward).map(|next| next - self.1)
    }
}

/// The control θ (Λ dh)♯, with half the value in one coordinate if there is a fault.
struct Friction<X> {
    damped: X,
    fault: Option<usize>,
}

impl<H: Hamiltonian<LiePoisson<So3>>> OrbitField<LiePoisson<So3>>
    for Friction<DoubleBracket<LiePoisson<So3>, Autonomous<H>>>
{
    fn element(&self, mu: &Covector<Vector3<f64>>, time: f64) -> Vector3<f64> {
        let damped = self.damped.element(mu, time);
        let mut control: Vector3<f64> = damped - self.damped.field().element(mu, time);
        if let Some(coordinate) = self.fault {
            control[coordinate] *= 0.5;
        }
        control
    }
}

/// The energy of a field along e₃ that is 1 before the time 0.4 and 2 from then on, and one along e₁ that oscillates.
struct Switched;

impl Energy for Switched {
    type Space = InTime<LiePoisson<So3>>;
    fn energy<T: Real>(&self, Pair(Covector(pi), Time(t)): &Point<Self::Space, T>) -> T {
        let field = (*t - 0.4).select_nonnegative(T::from_f64(2.0), T::one());
        -pi.z * field - pi.x * t.cos()
    }
}

/// Energies that depend on time have to tell their jumps, and their differential is that of their value at each time.
#[test]
fn laws_of_fields_with_time_reject_what_breaks_them() {
    let space = LiePoisson::minus(So3);
    let check = |report: Result<Report, _>| broken(&report.unwrap());
    let silent = TimeDependent(Automatic(Switched));
    let told = WithBreakpoints::new(&silent, vec![0.4]).unwrap();
    let elsewhere = WithBreakpoints::new(&silent, vec![0.5]).unwrap();
    let times = (0.0, 1.0);
    assert_eq!(check(laws::orbit_field(&space, &told, times, &samples())), [""; 0]);
    assert_eq!(check(laws::orbit_field(&space, &silent, times, &samples())), ["smoothness"]);
    assert_eq!(check(laws::orbit_field(&space, &elsewhere, times, &samples())), ["smoothness"]);
    // Without friction a double bracket is its field, and the suite compares it with dh.
    let h = Automatic(Oscillating::<So3>(1.0, PhantomData));
    let at_zero = from_closure::<LiePoisson<So3>, _>(|mu| quadratic(mu) * 2.0);
    let inner_product = weighted(3);
    let suite = |h: Faulty<'_, Automatic<Oscillating<So3>>>| {
        let field = |friction| {
            DoubleBracket::new(space, TimeDependent(&h), friction, inner_product.clone()).unwrap()
        };
        laws::double_bracket(&space, &at_zero, &inner_product, field, 0.7, &samples())
    };
    assert_eq!(check(suite(Faulty::without_fault(&h))), [""; 0]);
    for coordinate in 0..3 {
        let twin = Faulty::new(&h, "differential", coordinate);
        assert_eq!(check(suite(twin)), ["loss of energy", "linear in the friction"]);
    }
}
