//! The formulations by name, and the schemes that each offers.

use super::scheme_name::SchemeName;
use super::unknown_name::{UnknownName, by_name, name_of};
use core::fmt;
use core::str::FromStr;

/// The formulation of an integrator: the space and the equations to which its scheme is applied.
///
/// # Example
/// ```
/// use heavytop::methods::{Formulation, SchemeName};
/// let reduced: Formulation = "reduced".parse()?;
/// assert!(reduced.offers(SchemeName::Gauss(4)) && !reduced.offers(SchemeName::Rk4));
/// assert_eq!("lifted".parse::<Formulation>().unwrap_err().to_string(),
///     "unknown formulation `lifted`; there are collective, reduced, direct, splitting");
/// # Ok::<(), heavytop::methods::UnknownName>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// A scheme on T∗C², read through M: T∗C² → se(3)∗.
    #[default]
    Collective,
    /// The maps of the collective formulation, computed on se(3)∗ itself without a lift.
    Reduced,
    /// A scheme on the six equations of the heavy top.
    Direct,
    /// Exact flows of parts of h, on se(3)∗.
    Splitting,
}

impl Formulation {
    /// The names of all formulations.
    pub const NAMES: &[(&str, Self)] = &[
        ("collective", Self::Collective),
        ("reduced", Self::Reduced),
        ("direct", Self::Direct),
        ("splitting", Self::Splitting),
    ];

    /// Returns the name of the formulation.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns whether the scheme makes sense in this formulation of a top. The spherical midpoint method does in none.
    #[must_use]
    pub fn offers(self, scheme: SchemeName) -> bool {
        let composed = matches!(scheme, SchemeName::Composed(_));
        let symplectic =
            composed || matches!(scheme, SchemeName::ImplicitMidpoint | SchemeName::Gauss(_));
        match self {
            _ if scheme == SchemeName::SphericalMidpoint => false,
            Self::Collective => true,
            Self::Reduced => symplectic,
            Self::Direct => !matches!(scheme, SchemeName::Partitioned(_)),
            Self::Splitting => composed,
        }
    }

    /// Returns the schemes that make sense in this formulation.
    pub fn schemes(self) -> impl Iterator<Item = SchemeName> {
        SchemeName::NAMES
            .iter()
            .map(|(_, scheme)| *scheme)
            .filter(move |&scheme| self.offers(scheme))
    }

    /// Returns whether the scheme, which must be offered, is a Poisson map of se(3)∗ at every step size.
    #[must_use]
    pub fn is_poisson(self, scheme: SchemeName) -> bool {
        match self {
            Self::Collective | Self::Reduced => Self::Reduced.offers(scheme),
            Self::Direct => false,
            Self::Splitting => true,
        }
    }
}

impl FromStr for Formulation {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        by_name("formulation", Self::NAMES, name)
    }
}

impl fmt::Display for Formulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
