//! A uniform magnetic field that depends on the time: [`FieldInTime`].

use lie_poisson::{Covector, Inputs, LiePoisson, OrbitField, So3};
use nalgebra::Vector3;

/// A uniform magnetic field B(t), which adds −B(t)·Σ s_i to the Hamiltonian h of spins, so that dh/dt = −Ḃ·Σ s_i along a
/// motion without friction and noise. `()` is no field, and [`Inputs`] along vectors, by tables, are one.
///
/// # Example
/// A field that turns about e₃:
/// ```
/// use lie_poisson_systems::FieldInTime;
/// use nalgebra::Vector3;
/// #[derive(Clone, Debug)]
/// struct Turning {
///     rate: f64,
/// }
/// impl FieldInTime for Turning {
///     fn at(&self, time: f64) -> Vector3<f64> {
///         let (sine, cosine) = (self.rate * time).sin_cos();
///         Vector3::new(cosine, sine, 0.0)
///     }
/// }
/// assert_eq!(Turning { rate: 2.0 }.at(0.0), Vector3::x());
/// assert_eq!(Turning { rate: 2.0 }.next_break(0.0, true), None);
/// ```
pub trait FieldInTime {
    /// Returns B(t), which is not finite where the field has no value.
    fn at(&self, time: f64) -> Vector3<f64>;

    /// Returns the next time strictly after `time`, or strictly before it if `forward` is false, at which B or a derivative of
    /// it jumps; none unless a field says so. Steps are divided there.
    fn next_break(&self, _time: f64, _forward: bool) -> Option<f64> {
        None
    }
}

impl FieldInTime for () {
    fn at(&self, _: f64) -> Vector3<f64> {
        Vector3::zeros()
    }
}

impl FieldInTime for Inputs<Vector3<f64>> {
    fn at(&self, time: f64) -> Vector3<f64> {
        OrbitField::<LiePoisson<So3>>::element(self, &Covector(Vector3::zeros()), time)
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        OrbitField::<LiePoisson<So3>>::next_break(self, time, forward)
    }
}

impl<F: FieldInTime> FieldInTime for Option<F> {
    fn at(&self, time: f64) -> Vector3<f64> {
        self.as_ref().map_or(Vector3::zeros(), |field| field.at(time))
    }

    fn next_break(&self, time: f64, forward: bool) -> Option<f64> {
        self.as_ref()?.next_break(time, forward)
    }
}
