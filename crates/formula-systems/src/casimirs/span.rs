//! The space of the differentials of functions at a point: [`Span`].

use nalgebra::DVector;

/// The largest distance of a differential from the space of others, relative to the size of the sums that it is made of,
/// that counts as rounding.
///
/// One that lies in the space has a distance of 3·10⁻¹⁵ at most, and one that does not of 2·10⁻⁵ at least, measured on all
/// invariants of algebras up to so(16), gl(13), sp(14, R) and su(8). The bound is the geometric mean. The differentials of
/// wedge products up to so(11) ⋉ R¹¹ have a distance of 0.1 at least from those before.
const ROUNDING: f64 = 2e-10;

/// An orthonormal basis of the space that vectors span.
#[derive(Clone, Debug, Default)]
pub(crate) struct Span {
    basis: Vec<DVector<f64>>,
}

impl Span {
    /// Returns the direction of a vector at right angles to the space, or `None` if the vector, which is made of sums of
    /// size 1, lies in it.
    pub(crate) fn apart(&self, mut vector: DVector<f64>) -> Option<DVector<f64>> {
        // The second round removes the rounding errors of the first.
        for other in self.basis.iter().chain(&self.basis) {
            vector.axpy(-other.dot(&vector), other, 1.0);
        }
        let distance = vector.norm();
        (distance > ROUNDING).then(|| vector / distance)
    }

    /// Adds a direction at right angles to the space.
    pub(crate) fn add(&mut self, direction: DVector<f64>) {
        self.basis.push(direction);
    }
}
