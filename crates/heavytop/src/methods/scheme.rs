//! The schemes by name.

use super::named::{by_name, name_of};
use collective_integrators::{SchemeError, Substeps};
use serde::{Deserialize, Serialize};

/// A one-step method by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "&'static str")]
pub enum Scheme {
    /// The implicit midpoint rule.
    #[default]
    ImplicitMidpoint,
    /// Gauss–Legendre collocation with this number of stages.
    Gauss(u8),
    /// The explicit midpoint rule.
    ExplicitMidpoint,
    /// The classical method of Runge and Kutta.
    Rk4,
    /// A partitioned method, which treats q and p differently.
    Partitioned(Pair),
    /// A composition of the implicit midpoint rule, or of Strang's splitting.
    Composed(Raise),
}

/// The partitioned Runge–Kutta methods by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pair {
    /// The symplectic Euler method, implicit in p.
    SymplecticEuler,
    /// The Störmer–Verlet method that moves p first.
    StormerVerlet,
    /// The Lobatto IIIA–IIIB pair with 3 stages.
    Lobatto,
}

/// The compositions by name, by their substeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Raise {
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

impl Scheme {
    /// The names of all schemes.
    pub const NAMES: &[(&str, Self)] = &[
        ("implicit-midpoint", Self::ImplicitMidpoint),
        ("gauss-4", Self::Gauss(2)),
        ("gauss-6", Self::Gauss(3)),
        ("gauss-8", Self::Gauss(4)),
        ("gauss-10", Self::Gauss(5)),
        ("gauss-12", Self::Gauss(6)),
        ("gauss-16", Self::Gauss(8)),
        ("explicit-midpoint", Self::ExplicitMidpoint),
        ("rk4", Self::Rk4),
        ("symplectic-euler", Self::Partitioned(Pair::SymplecticEuler)),
        ("stormer-verlet", Self::Partitioned(Pair::StormerVerlet)),
        ("lobatto-iiia-iiib-4", Self::Partitioned(Pair::Lobatto)),
        ("strang", Self::Composed(Raise::Strang)),
        ("yoshida-4", Self::Composed(Raise::Yoshida4)),
        ("suzuki-4", Self::Composed(Raise::Suzuki4)),
        ("yoshida-6", Self::Composed(Raise::Yoshida6)),
        ("kahan-li-6", Self::Composed(Raise::KahanLi6)),
        ("kahan-li-8", Self::Composed(Raise::KahanLi8)),
    ];

    /// Returns the name in configurations and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// Returns the order p of the method: the error after a given time decreases as the p-th power of the step.
    #[must_use]
    pub fn order(self) -> u8 {
        match self {
            Self::Gauss(stages) => 2 * stages,
            Self::Partitioned(Pair::SymplecticEuler) => 1,
            Self::ImplicitMidpoint | Self::ExplicitMidpoint => 2,
            Self::Partitioned(Pair::StormerVerlet) | Self::Composed(Raise::Strang) => 2,
            Self::Rk4 | Self::Partitioned(Pair::Lobatto) => 4,
            Self::Composed(Raise::Yoshida4 | Raise::Suzuki4) => 4,
            Self::Composed(Raise::Yoshida6 | Raise::KahanLi6) => 6,
            Self::Composed(Raise::KahanLi8) => 8,
        }
    }
}

impl Raise {
    /// Returns the substeps as fractions of a step.
    ///
    /// # Errors
    /// None: all the fractions add up to 1.
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

impl TryFrom<String> for Scheme {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        by_name("scheme", Self::NAMES, &name)
    }
}

impl From<Scheme> for &'static str {
    fn from(scheme: Scheme) -> Self {
        scheme.name()
    }
}
