//! The table `[noise]`: [`NoiseConfig`].

use super::damping_config::{FORMULA_KEYS, FORMULAS_HAVE, InnerProductConfig, only};
use super::element::{Element, parts};
use crate::errors::{Error, SystemTableError};
use collective_integrators::NoiseRule;
use lie_poisson::IsotropicNoise;
use lie_poisson_formula_systems::{Damping, NoiseFields, NoiseTerms, OpenNames};
use lie_poisson_runs::HarmonicShell;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// The table `[noise]`: of a temperature, of a strength in all directions, or of fields by formulas; or the transport
/// noise and the stirring of a fluid.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct NoiseConfig {
    /// The energy kT, in the unit of the Hamiltonian. It needs `[damping]`, whose inner product the noise has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature: Option<f64>,
    /// The strength σ of noise that is the same in all directions of an inner product.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strength: Option<f64>,
    /// The inner product that goes with a strength.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner_product: Option<InnerProductConfig>,
    /// Fields σ_k by formulas, each with a Brownian motion of its own.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fields: Vec<Element>,
    /// Of a fluid on the sphere, noise that carries it along, σ in 1/√t.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transport: Option<ShellConfig>,
    /// Of a fluid on the sphere, a force that is white in time, σ in 1/(t√t).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stirring: Option<ShellConfig>,
    /// The seed of the random numbers.
    #[serde(default = "first_seed")]
    pub seed: u64,
    /// The number of the path: another number is another run with the same statistics.
    #[serde(default)]
    pub path: u64,
    /// How the noise enters a step.
    #[serde(default)]
    pub rule: Rule,
    /// The length of the intervals of the paths, s; the step of the run, if it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval: Option<f64>,
    /// The bound of an increment, in standard deviations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
}

/// Shells of spherical harmonics in which a fluid has noise: one, or an array of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ShellConfig {
    /// One shell.
    One(Shell),
    /// Several shells.
    Many(Vec<Shell>),
}

/// A shell of spherical harmonics.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Shell {
    /// The least and the largest degree.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<[usize; 2]>,
    /// The strength σ in each harmonic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strength: Option<f64>,
}

impl<'de> Deserialize<'de> for ShellConfig {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(OneOrMany)
    }
}

struct OneOrMany;

impl<'de> Visitor<'de> for OneOrMany {
    type Value = ShellConfig;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(
            "a shell, such as { degrees = [8, 10], strength = 0.1 }, or an array of shells",
        )
    }

    fn visit_map<A: MapAccess<'de>>(self, shell: A) -> Result<ShellConfig, A::Error> {
        Shell::deserialize(MapAccessDeserializer::new(shell)).map(ShellConfig::One)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, shells: A) -> Result<ShellConfig, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(shells)).map(ShellConfig::Many)
    }
}

impl ShellConfig {
    /// Returns the shells of a table.
    ///
    /// # Errors
    /// If one of them lacks its degrees or its strength.
    pub(super) fn shells(&self, table: &str) -> Result<Vec<HarmonicShell>, SystemTableError> {
        let shells = match self {
            Self::One(shell) => core::slice::from_ref(shell),
            Self::Many(shells) => shells,
        };
        let missing = |key| SystemTableError::MissingKey { table: table.into(), key };
        let shell = |shell: &Shell| {
            let degrees = shell.degrees.ok_or_else(|| missing("degrees"))?;
            let strength = shell.strength.ok_or_else(|| missing("strength"))?;
            Ok(HarmonicShell { degrees, strength })
        };
        shells.iter().map(shell).collect()
    }
}

/// The seed where none is written.
const fn first_seed() -> u64 {
    1
}

/// How the noise enters a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// In one step of the scheme: weak order 1.
    #[default]
    Together,
    /// One field after the other: weak order 2, with schemes of order 2 where no field depends on coordinates, and otherwise with those
    /// of order 4 and more.
    Alternating,
}

impl NoiseConfig {
    /// Checks that there are no keys but some, besides those that every noise has.
    pub(super) fn require_only(
        &self,
        known: &[&str],
        has: &'static str,
    ) -> Result<(), SystemTableError> {
        let given = [
            ("noise.temperature", self.temperature.is_some()),
            ("noise.strength", self.strength.is_some()),
            ("noise.inner_product", self.inner_product.is_some()),
            ("noise.fields", !self.fields.is_empty()),
            ("noise.rule", self.rule != Rule::Together),
            ("noise.transport", self.transport.is_some()),
            ("noise.stirring", self.stirring.is_some()),
        ];
        only(&given, known, has)
    }

    /// Returns the noise on an algebra.
    ///
    /// # Errors
    /// If there is not exactly one of temperature, strength and fields, or one of them is impossible.
    pub(super) fn terms(
        &self,
        names: &OpenNames,
        dimension: usize,
        damping: Option<&Damping>,
    ) -> Result<NoiseTerms, Error> {
        self.require_only(FORMULA_KEYS, FORMULAS_HAVE)?;
        let fields = match (self.temperature, self.strength, self.fields.as_slice()) {
            (Some(temperature), None, []) if self.inner_product.is_none() => {
                NoiseFields::thermal(damping, temperature)?
            }
            (None, Some(strength), []) => {
                let rows = self.inner_product.as_ref().map(|given| given.rows(dimension));
                let inner_product = names.inner_product(rows.as_deref())?;
                NoiseFields::Isotropic(IsotropicNoise { inner_product, strength })
            }
            (None, None, [_, ..]) if self.inner_product.is_none() => {
                let field = |(k, element): (usize, &Element)| {
                    names.element(&format!("noise field {k}"), parts(element))
                };
                NoiseFields::Formulas((1..).zip(&self.fields).map(field).collect::<Result<_, _>>()?)
            }
            _ => return Err(SystemTableError::OneNoise.into()),
        };
        let rule = match self.rule {
            Rule::Together => NoiseRule::Together,
            Rule::Alternating => NoiseRule::Alternating,
        };
        let Self { seed, path, interval, bound, .. } = *self;
        Ok(NoiseTerms { fields, seed, path, rule, interval, bound })
    }
}
