//! The formulations by name, and the schemes that each offers.

use super::named::{by_name, name_of};
use super::scheme::Scheme;
use serde::{Deserialize, Serialize};

/// The formulation of an integrator: where its scheme is applied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Formulation {
    /// A scheme on T∗C², read through M: T∗C² → se(3)∗.
    #[default]
    Collective,
    /// The maps of the collective formulation without a lift, on se(3)∗ itself.
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

    /// Returns the name in configurations and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns whether the scheme makes sense in this formulation.
    #[must_use]
    pub fn offers(self, scheme: Scheme) -> bool {
        let composed = matches!(scheme, Scheme::Composed(_));
        let symplectic = composed || matches!(scheme, Scheme::ImplicitMidpoint | Scheme::Gauss(_));
        match self {
            Self::Collective => true,
            Self::Reduced => symplectic,
            Self::Direct => !matches!(scheme, Scheme::Partitioned(_)),
            Self::Splitting => composed,
        }
    }

    /// Returns the schemes that make sense in this formulation.
    pub fn schemes(self) -> impl Iterator<Item = Scheme> {
        Scheme::NAMES.iter().map(|(_, scheme)| *scheme).filter(move |&scheme| self.offers(scheme))
    }

    /// Returns whether the scheme, which must be offered, is a Poisson map of se(3)∗ at every step size.
    #[must_use]
    pub fn is_poisson(self, scheme: Scheme) -> bool {
        match self {
            Self::Collective | Self::Reduced => Self::Reduced.offers(scheme),
            Self::Direct => false,
            Self::Splitting => true,
        }
    }
}

impl TryFrom<String> for Formulation {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        by_name("formulation", Self::NAMES, &name)
    }
}

impl From<Formulation> for &'static str {
    fn from(formulation: Formulation) -> Self {
        formulation.name()
    }
}
