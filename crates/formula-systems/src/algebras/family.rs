//! The kind of an algebra, and how large one may be: [`Family`], [`MOST_DIMENSIONS`].

/// The largest dimension of an algebra.
pub(super) const MOST_DIMENSIONS: usize = 256;

/// The kind of an algebra. It decides which methods, besides the direct ones, integrate its systems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// The algebras of rotations, so(3) and su(2).
    Rotations,
    /// Sums of several such algebras.
    ManyRotations,
    /// The algebra of rigid motions, se(3).
    Motions,
    /// Any other Lie algebra.
    Other,
}

impl Family {
    /// Returns the kind of the direct sum with an algebra of another kind.
    pub(crate) fn with(self, other: Self) -> Self {
        let rotates = |family| matches!(family, Self::Rotations | Self::ManyRotations);
        if rotates(self) && rotates(other) { Self::ManyRotations } else { Self::Other }
    }
}
