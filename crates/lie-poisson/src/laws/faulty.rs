//! The negative control of the law suites: [`Faulty`].

use generic_scalars::{Real, State};

/// An object with a fault in the result of one method: a negative control, which a law suite must refuse.
///
/// The method with the given name returns half the value in one coordinate. All other methods return the results of
/// the object. The coordinate is halved, and not negated, because squares, and with them many invariants, do not
/// depend on a sign.
///
/// If the coordinate is not much smaller than the others, a suite that uses it has a residual far above 10⁻³: check
/// against 10⁻³. If it is zero in all samples, there is no fault: choose another coordinate or other samples. A suite
/// that passes without such a control may have tested nothing, for example if all samples are zero.
///
/// A `Faulty` object implements these traits if the object does:
///
/// | trait | methods |
/// |---|---|
/// | [`LieAlgebra`](crate::LieAlgebra) | `bracket`, `coadjoint` |
/// | [`Casimirs`](crate::Casimirs) | `casimir_differential` |
/// | [`Hamiltonian`](crate::Hamiltonian) | `differential` |
/// | [`SitesHamiltonian`](crate::SitesHamiltonian) | `differential_into` |
/// | [`OrbitField`](crate::OrbitField) | `element`, `next_break` (always `None`) |
/// | [`Noise`](crate::Noise) | `is_constant` (always true), `next_break` (always `None`) |
///
/// The laws of `momentum-map` and `collective-integrators` add their traits, which are listed in their modules
/// `laws`. The fault of a batch is different and is described there. To implement a trait of your own, call the
/// [`object`](Self::object), and pass the result of each method to [`halve`](Self::halve) or
/// [`halved`](Self::halved).
///
/// If no method has the given name, or if its result does not have the given coordinate, there is no fault: the suite
/// then accepts the object, and the control fails.
///
/// # Example
/// ```
/// use lie_poisson::laws::{Faulty, lie_algebra};
/// use lie_poisson::So3;
/// use nalgebra::Vector3;
/// let samples = [Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0)];
/// lie_algebra(&So3, &samples)?.check(1e-14)?;
/// // Control: the suite refuses a bracket with half the value in its second coordinate.
/// let faulty = Faulty::new(&So3, "bracket", 1);
/// assert!(lie_algebra(&faulty, &samples)?.check(1e-3).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Faulty<'a, S> {
    object: &'a S,
    fault: Option<(&'static str, usize)>,
}

impl<'a, S> Faulty<'a, S> {
    /// Creates the object whose method with this name returns half the value in one coordinate.
    #[must_use]
    pub const fn new(object: &'a S, method: &'static str, coordinate: usize) -> Self {
        Self { object, fault: Some((method, coordinate)) }
    }

    /// Wraps the object without a fault, so that one function can test it and a faulty variant.
    #[must_use]
    pub const fn without_fault(object: &'a S) -> Self {
        Self { object, fault: None }
    }

    /// Returns the object.
    #[must_use]
    pub const fn object(&self) -> &'a S {
        self.object
    }

    /// Returns whether the method with this name has the fault.
    #[must_use]
    pub fn has_fault_in(&self, method: &str) -> bool {
        self.fault.is_some_and(|(wrong, _)| wrong == method)
    }

    /// Halves the faulty coordinate of a result, if the method with this name has the fault.
    pub fn halve<V: State>(&self, method: &str, result: &mut V) {
        if let Some((wrong, coordinate)) = self.fault
            && wrong == method
            && coordinate < result.dimension()
        {
            result.set_coordinate(
                coordinate,
                result.coordinate(coordinate) * V::Scalar::from_f64(0.5),
            );
        }
    }

    /// Returns a result, with its faulty coordinate [halved](Self::halve) if the method with this name has the fault.
    #[must_use]
    pub fn halved<V: State>(&self, method: &str, mut result: V) -> V {
        self.halve(method, &mut result);
        result
    }
}
