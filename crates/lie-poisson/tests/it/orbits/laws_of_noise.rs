//! Noise obeys its laws, and faulty twins do not.

use super::orbit_fields::weighted;
use crate::support::{broken, laws, samples};
use laws::Faulty;
use lie_poisson::*;
use nalgebra::Vector3;

/// Fields that turn with the time and may follow the spin.
struct Turning {
    follows: bool,
    offset: f64,
}

impl<T: Real> Noise<LiePoisson<So3>, T> for Turning {
    fn count(&self) -> usize {
        2
    }

    fn element(&self, Covector(s): &Covector<Vector3<T>>, time: T, weights: &[T]) -> Vector3<T> {
        let first = Vector3::new(time.cos(), time.sin(), T::from_f64(0.2));
        let second = if self.follows { *s } else { Vector3::z().map(T::from_f64) };
        let offset = Vector3::x().map(T::from_f64) * T::from_f64(self.offset);
        first * weights[0] + second * weights[1] + offset
    }

    fn is_constant(&self) -> bool {
        !self.follows
    }
}

/// A field about e₃ whose strength is a table.
struct Tabulated(InputTable);

impl<T: Real> Noise<LiePoisson<So3>, T> for Tabulated {
    fn count(&self) -> usize {
        1
    }

    fn element(&self, _: &Covector<Vector3<T>>, time: T, weights: &[T]) -> Vector3<T> {
        Vector3::new(T::zero(), T::zero(), weights[0] * self.0.at(time))
    }

    fn is_constant(&self) -> bool {
        true
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.0.next_break(time, forward)
    }
}

#[test]
fn noise_that_tells_no_breaks_is_not_smooth() {
    let (times, values) = (vec![0.0, 0.45, 1.3, 2.0], vec![0.5, 1.5, 0.2, 0.9]);
    for kind in [Interpolation::Constant, Interpolation::Linear] {
        let noise = Tabulated(InputTable::new(times.clone(), values.clone(), kind).unwrap());
        let space = LiePoisson::minus(So3);
        for times in [(0.0, 2.0), (2.0, 0.0)] {
            assert_eq!(broken(&laws::noise(&space, &&noise, times, &samples()).unwrap()), [""; 0]);
            let silent = Faulty::new(&noise, "next_break", 0);
            let found = broken(&laws::noise(&space, &silent, times, &samples()).unwrap());
            assert_eq!(found, ["smoothness"]);
        }
    }
}

#[test]
fn noise_obeys_its_laws_and_faulty_twins_do_not() {
    let space = LiePoisson::minus(So3);
    fn check<N>(space: &LiePoisson<So3>, noise: &N) -> Vec<&'static str>
    where
        N: Noise<LiePoisson<So3>> + Noise<LiePoisson<So3>, DualNumber>,
    {
        broken(&laws::noise(space, noise, (0.3, 1.7), &samples()).unwrap())
    }
    let isotropic = IsotropicNoise { inner_product: weighted(3), strength: 0.7 };
    assert_eq!(check(&space, &isotropic), [""; 0]);
    assert!(Noise::<LiePoisson<So3>>::is_constant(&&isotropic));
    for follows in [false, true] {
        let turning = Turning { follows, offset: 0.0 };
        assert_eq!(check(&space, &turning), [""; 0]);
        let claimed = Faulty::new(&turning, "is_constant", 0);
        let expected: &[&str] = if follows { &["constant"] } else { &[] };
        assert_eq!(check(&space, &claimed), expected);
        // A field without a weight.
        let twin = Turning { follows, offset: 0.1 };
        assert!(check(&space, &twin).contains(&"linear in the weights"));
    }
    assert!(laws::noise(&space, &isotropic, (0.0, 1.0), &[]).is_err());
}
