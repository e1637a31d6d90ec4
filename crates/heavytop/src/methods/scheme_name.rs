//! The schemes by name.

use super::unknown_name::{UnknownName, by_name, name_of};
use collective_integrators::{SchemeError, Substeps};
use core::fmt;
use core::str::FromStr;

/// A one-step method by name, from which a [`Method`](super::Method) makes its
/// [`Scheme`](collective_integrators::Scheme).
///
/// # Example
/// ```
/// use heavytop::methods::SchemeName;
/// let gauss: SchemeName = "gauss-12".parse()?;
/// assert_eq!((gauss, gauss.order()), (SchemeName::Gauss(6), 12));
/// assert_eq!(SchemeName::default().name(), "gauss-8"); // where none is named
/// assert!("gauss-13".parse::<SchemeName>().is_err());
/// # Ok::<(), heavytop::methods::UnknownName>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SchemeName {
    /// The implicit midpoint rule.
    ImplicitMidpoint,
    /// The implicit midpoint rule whose midpoint is moved to the spheres |s_i| = constant. It is for systems of spins and
    /// of vortices; no top has it.
    SphericalMidpoint,
    /// Gauss–Legendre collocation with this number of stages.
    Gauss(u8),
    /// The explicit midpoint rule.
    ExplicitMidpoint,
    /// The classical method of Runge and Kutta.
    Rk4,
    /// A partitioned method, which treats q and p differently.
    Partitioned(PartitionedScheme),
    /// A composition of the implicit midpoint rule, or of Strang's splitting.
    Composed(ComposedScheme),
}

/// The partitioned Runge–Kutta methods by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PartitionedScheme {
    /// The symplectic Euler method, implicit in p.
    SymplecticEuler,
    /// The Störmer–Verlet method that moves p first.
    StormerVerlet,
    /// The Lobatto IIIA–IIIB pair with 3 stages.
    Lobatto,
}

/// The compositions by name, by their substeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ComposedScheme {
    /// One whole step, of order 2.
    Strang,
    /// Three substeps, of order 4.
    Yoshida4,
    /// Five substeps, of order 4.
    Suzuki4,
    /// Seven substeps, of order 6.
    Yoshida6,
    /// Nine substeps, of order 6.
    KahanLi6,
    /// Seventeen substeps, of order 8.
    KahanLi8,
}

impl SchemeName {
    /// The names of all schemes.
    pub const NAMES: &[(&str, Self)] = &[
        ("implicit-midpoint", Self::ImplicitMidpoint),
        ("spherical-midpoint", Self::SphericalMidpoint),
        ("gauss-4", Self::Gauss(2)),
        ("gauss-6", Self::Gauss(3)),
        ("gauss-8", Self::Gauss(4)),
        ("gauss-10", Self::Gauss(5)),
        ("gauss-12", Self::Gauss(6)),
        ("gauss-16", Self::Gauss(8)),
        ("explicit-midpoint", Self::ExplicitMidpoint),
        ("rk4", Self::Rk4),
        ("symplectic-euler", Self::Partitioned(PartitionedScheme::SymplecticEuler)),
        ("stormer-verlet", Self::Partitioned(PartitionedScheme::StormerVerlet)),
        ("lobatto-iiia-iiib-4", Self::Partitioned(PartitionedScheme::Lobatto)),
        ("strang", Self::Composed(ComposedScheme::Strang)),
        ("yoshida-4", Self::Composed(ComposedScheme::Yoshida4)),
        ("suzuki-4", Self::Composed(ComposedScheme::Suzuki4)),
        ("yoshida-6", Self::Composed(ComposedScheme::Yoshida6)),
        ("kahan-li-6", Self::Composed(ComposedScheme::KahanLi6)),
        ("kahan-li-8", Self::Composed(ComposedScheme::KahanLi8)),
    ];

    /// Returns the name of the scheme; it is empty for a Gauss method that is not among [`NAMES`](Self::NAMES).
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns the order p of the method: the error after a given time decreases as the p-th power of the step.
    #[must_use]
    pub fn order(self) -> u16 {
        match self {
            Self::Gauss(stages) => 2 * u16::from(stages),
            Self::Partitioned(PartitionedScheme::SymplecticEuler) => 1,
            Self::ImplicitMidpoint | Self::SphericalMidpoint | Self::ExplicitMidpoint => 2,
            Self::Partitioned(PartitionedScheme::StormerVerlet)
            | Self::Composed(ComposedScheme::Strang) => 2,
            Self::Rk4 | Self::Partitioned(PartitionedScheme::Lobatto) => 4,
            Self::Composed(ComposedScheme::Yoshida4 | ComposedScheme::Suzuki4) => 4,
            Self::Composed(ComposedScheme::Yoshida6 | ComposedScheme::KahanLi6) => 6,
            Self::Composed(ComposedScheme::KahanLi8) => 8,
        }
    }
}

/// Gauss's method of order 8: accurate to round-off at steps at which the midpoint rule is wrong in the first digits.
impl Default for SchemeName {
    fn default() -> Self {
        Self::Gauss(4)
    }
}

impl ComposedScheme {
    /// Returns the substeps as fractions of a step.
    ///
    /// # Errors
    /// Returns no error, since all the fractions add up to 1.
    pub fn substeps(self) -> Result<Substeps, SchemeError> {
        Ok(match self {
            Self::Strang => Substeps::new(&[1.0])?,
            Self::Yoshida4 => Substeps::yoshida4(),
            Self::Suzuki4 => Substeps::suzuki4(),
            Self::Yoshida6 => Substeps::yoshida6(),
            Self::KahanLi6 => Substeps::kahan_li6(),
            Self::KahanLi8 => Substeps::kahan_li8(),
        })
    }
}

impl FromStr for SchemeName {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        by_name("scheme", Self::NAMES, name)
    }
}

impl fmt::Display for SchemeName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // Messages name Gauss methods of every number of stages.
            Self::Gauss(_) => write!(f, "gauss-{}", self.order()),
            _ => f.write_str(self.name()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_of_a_scheme_is_its_name() {
        for &(name, scheme) in SchemeName::NAMES {
            assert_eq!((scheme.to_string().as_str(), scheme.name()), (name, name));
        }
    }

    /// Messages about schemes without a name must not be empty, and the order of the largest one must not overflow.
    #[test]
    fn gauss_methods_without_a_name_have_a_text_and_an_order() {
        for (stages, text, order) in [(0, "gauss-0", 0), (255, "gauss-510", 510)] {
            let scheme = SchemeName::Gauss(stages);
            assert_eq!((scheme.name(), scheme.to_string().as_str()), ("", text));
            assert_eq!(scheme.order(), order);
        }
    }
}
