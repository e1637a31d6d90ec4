//! The invariants of a vector and a 2-form: [`WedgeProduct`].

/// What does not change under rotations and translations of the forms Γ = Σ Γ_i eⁱ and L = Σ L_ij eⁱ∧eʲ, i < j: of
/// Γ ∧ L^∧k, a form of degree 2k + 1, the square, or the form itself.
///
/// A translation by v adds a multiple of Γ ∧ ηv to L, which Γ ∧ L^∧k does not see. A rotation turns it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum WedgeProduct {
    /// The square of Γ ∧ L^∧k with the form η: the sum of the squares of its components of increasing indices, each with the
    /// signs of its indices.
    Square(usize),
    /// The component of Γ ∧ L^∧k in the space of 2k + 1 dimensions.
    Top(usize),
}

impl WedgeProduct {
    /// Returns the invariants in the space of n dimensions, ⌊(n + 1)/2⌋ in number, in the order of their degrees.
    pub(crate) fn all(n: usize) -> Vec<Self> {
        let of = |k: usize| if 2 * k + 1 == n { Self::Top(k) } else { Self::Square(k) };
        let mut all: Vec<Self> = (0..n.div_ceil(2)).map(of).collect();
        all.sort_by_key(|product| product.degree());
        all
    }

    /// Returns the exponent k of L.
    pub(crate) const fn exponent(self) -> usize {
        match self {
            Self::Square(k) | Self::Top(k) => k,
        }
    }

    /// Returns the degree.
    pub(crate) const fn degree(self) -> usize {
        match self {
            Self::Square(k) => 2 * (k + 1),
            Self::Top(k) => k + 1,
        }
    }

    /// Returns what a reader is shown for the invariant of forms with these texts.
    pub(crate) fn text(self, vector: &str, rotations: &str) -> String {
        let product = match self.exponent() {
            0 => vector.to_owned(),
            1 => format!("{vector} ∧ {rotations}"),
            k => format!("{vector} ∧ {rotations}^{k}"),
        };
        match self {
            Self::Square(_) => format!("|{product}|^2"),
            Self::Top(_) => product,
        }
    }
}
