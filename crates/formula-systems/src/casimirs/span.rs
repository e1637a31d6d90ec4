//! The space of the differentials of functions at a point: [`Span`].

use nalgebra::DVector;

/// The largest distance of a differential from the space of others, relative to the size of the sums that it is made of,
/// that counts as rounding.
///
/// A differential that lies in the space has a distance of less than 10⁻¹³, measured up to so(16), and one that does not
/// a distance of 10⁻⁵ at least.
const ROUNDING: f64 = 1e-9;

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
