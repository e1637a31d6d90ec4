//! Formulations and schemes by name.

use collective_integrators::{RungeKutta, StageSolver};
use serde::Deserialize;

/// Where a scheme is applied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub enum Formulation {
    /// On T∗C², read through M: T∗C² → se(3)∗.
    #[default]
    Collective,
    /// On the six equations of the heavy top.
    Direct,
}

/// A one-step method.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
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
}

impl Formulation {
    const NAMES: &[(&str, Self)] = &[("collective", Self::Collective), ("direct", Self::Direct)];

    /// Its name in configurations and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }
}

impl Scheme {
    const NAMES: &[(&str, Self)] = &[
        ("implicit-midpoint", Self::ImplicitMidpoint),
        ("gauss-4", Self::Gauss(2)),
        ("gauss-6", Self::Gauss(3)),
        ("gauss-8", Self::Gauss(4)),
        ("gauss-10", Self::Gauss(5)),
        ("gauss-12", Self::Gauss(6)),
        ("gauss-16", Self::Gauss(8)),
        ("explicit-midpoint", Self::ExplicitMidpoint),
        ("rk4", Self::Rk4),
    ];

    /// Its name in configurations and tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_of(Self::NAMES, self)
    }

    /// The method, with stages solved to `tolerance`; 0 iterates to the round-off floor.
    #[must_use]
    pub fn method(self, tolerance: f64) -> RungeKutta {
        let method = match self {
            Self::ImplicitMidpoint => RungeKutta::implicit_midpoint(),
            // `gauss` refuses 0 stages alone, which no name asks for; one stage is the midpoint.
            Self::Gauss(stages) => {
                RungeKutta::gauss(stages.into()).unwrap_or_else(|_| RungeKutta::implicit_midpoint())
            }
            Self::ExplicitMidpoint => RungeKutta::explicit_midpoint(),
            Self::Rk4 => RungeKutta::rk4(),
        };
        method.with_solver(StageSolver { tolerance, ..StageSolver::default() })
    }
}

impl TryFrom<String> for Formulation {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        by_name("formulation", Self::NAMES, &name)
    }
}

impl TryFrom<String> for Scheme {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        by_name("scheme", Self::NAMES, &name)
    }
}

fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], item: T) -> &'static str {
    names.iter().find(|(_, other)| *other == item).map_or("", |(name, _)| name)
}

fn by_name<T: Copy>(kind: &str, names: &[(&str, T)], name: &str) -> Result<T, String> {
    let found = names.iter().find(|(known, _)| *known == name).map(|(_, item)| *item);
    found.ok_or_else(|| {
        let known: Vec<&str> = names.iter().map(|(known, _)| *known).collect();
        format!("unknown {kind} `{name}`; there are {}", known.join(", "))
    })
}
