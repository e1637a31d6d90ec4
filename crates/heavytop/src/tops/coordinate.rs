//! The six coordinates of a top's momentum.

use core::fmt;
use lie_poisson::{Covector, Pair, Se3Dual};

/// A coordinate of (Π, Γ) ∈ se(3)∗ in the body frame: Π in kg m²/s, Γ dimensionless.
///
/// # Example
/// ```
/// use heavytop::Coordinate;
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let mu = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
/// let values = Coordinate::ALL.map(|coordinate| coordinate.of(&mu));
/// assert_eq!(values, [2.0, 3.0, 4.0, 0.6, 0.0, 0.8]);
/// assert_eq!(Coordinate::Gamma3.to_string(), "Gamma3");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Coordinate {
    /// The first component Π₁ of the angular momentum.
    Pi1,
    /// The second component Π₂ of the angular momentum.
    Pi2,
    /// The third component Π₃ of the angular momentum.
    Pi3,
    /// The first component Γ₁ of the vertical.
    Gamma1,
    /// The second component Γ₂ of the vertical.
    Gamma2,
    /// The third component Γ₃ of the vertical.
    Gamma3,
}

impl Coordinate {
    /// All six coordinates, in the order of the columns of tables.
    pub const ALL: [Self; 6] =
        [Self::Pi1, Self::Pi2, Self::Pi3, Self::Gamma1, Self::Gamma2, Self::Gamma3];

    /// Returns the value of the coordinate at (Π, Γ).
    #[must_use]
    pub fn of(self, mu: &Se3Dual) -> f64 {
        let Covector(Pair(pi, gamma)) = mu;
        if self.is_momentum() { pi[self.axis()] } else { gamma[self.axis()] }
    }

    /// Returns whether the coordinate is a component of Π; otherwise it is a component of Γ.
    #[must_use]
    pub const fn is_momentum(self) -> bool {
        matches!(self, Self::Pi1 | Self::Pi2 | Self::Pi3)
    }

    /// Returns the principal axis of the coordinate: 0, 1 or 2.
    #[must_use]
    pub const fn axis(self) -> usize {
        match self {
            Self::Pi1 | Self::Gamma1 => 0,
            Self::Pi2 | Self::Gamma2 => 1,
            Self::Pi3 | Self::Gamma3 => 2,
        }
    }

    /// Returns the name in tables and configurations: `Pi1` … `Gamma3`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pi1 => "Pi1",
            Self::Pi2 => "Pi2",
            Self::Pi3 => "Pi3",
            Self::Gamma1 => "Gamma1",
            Self::Gamma2 => "Gamma2",
            Self::Gamma3 => "Gamma3",
        }
    }
}

impl fmt::Display for Coordinate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
