//! The table `[damping]`: [`DampingConfig`].

use crate::errors::{Error, SystemTableError};
use lie_poisson::InnerProduct;
use lie_poisson_formula_systems::{Damping, OpenNames};
use serde::{Deserialize, Serialize};

/// The table `[damping]`: a double bracket, which lowers the energy and keeps the Casimirs; or the viscosity and the
/// drag of a fluid.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct DampingConfig {
    /// The friction θ, at least 0; or Gilbert's α.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// Of spins, which damping this is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<DampingForm>,
    /// Of a fluid on the sphere, the viscosity ν, at least 0: harmonics of degree l decay at the rate α + ν (l(l +
    /// 1))ᵖ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub viscosity: Option<f64>,
    /// The power p of the Laplace operator in the viscosity: 1, or more for a hyperviscosity.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power: Option<u32>,
    /// Of a fluid on the sphere, the linear drag α, at least 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drag: Option<f64>,
    /// The inner product ♯ on the dual of the algebra; the unit matrix where all coordinates are of one vector.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner_product: Option<InnerProductConfig>,
}

/// The keys of `[damping]` and `[noise]` for tops and systems by formula, but for those that every noise has.
pub(super) const FORMULA_KEYS: &[&str] = &[
    "damping.friction",
    "damping.form",
    "damping.inner_product",
    "noise.temperature",
    "noise.strength",
    "noise.inner_product",
    "noise.fields",
    "noise.rule",
];
/// The keys of `[damping]` with a form.
const FORM_KEYS: &[&str] = &["damping.friction", "damping.form"];
const FORMS_HAVE: &str = "a damping with form, which is of spins, has friction alone beside it";
pub(super) const FORMULAS_HAVE: &str = "tops and systems by formula have friction and inner_product in [damping], or \
                                        of spins form, and temperature, strength, inner_product, fields, rule, seed, \
                                        path, interval and bound in [noise]";

/// The form of the damping of spins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DampingForm {
    /// ds/dt = s × H − θ s × (s × H)
    #[default]
    LandauLifshitz,
    /// ds/dt = s × H − (α/|s|) s × ds/dt
    Gilbert,
}

/// An inner product: a multiple of the unit matrix, a diagonal matrix, or any symmetric, positive definite one.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(
    untagged,
    expecting = "expected a number for a multiple of the unit matrix, an array for a diagonal, or an array of rows"
)]
pub enum InnerProductConfig {
    /// A multiple of the unit matrix.
    Multiple(f64),
    /// The diagonal.
    Diagonal(Vec<f64>),
    /// The rows.
    Rows(Vec<Vec<f64>>),
}

impl DampingConfig {
    /// Checks that there are no keys but some.
    pub(super) fn require_only(
        &self,
        known: &[&str],
        has: &'static str,
    ) -> Result<(), SystemTableError> {
        let given = [
            ("damping.friction", self.friction.is_some()),
            ("damping.form", self.form.is_some()),
            ("damping.viscosity", self.viscosity.is_some()),
            ("damping.power", self.power.is_some()),
            ("damping.drag", self.drag.is_some()),
            ("damping.inner_product", self.inner_product.is_some()),
        ];
        only(&given, known, has)
    }

    /// Returns the friction.
    ///
    /// # Errors
    /// If it is missing.
    pub(super) fn required_friction(&self) -> Result<f64, SystemTableError> {
        let missing = || SystemTableError::MissingKey { table: "damping".into(), key: "friction" };
        self.friction.ok_or_else(missing)
    }

    /// Returns the friction with its inner product.
    ///
    /// # Errors
    /// If the inner product is none, is missing where it needs a choice, or stands beside a form, which is of spins alone.
    pub(super) fn damping(&self, names: &OpenNames, dimension: usize) -> Result<Damping, Error> {
        self.require_only(FORMULA_KEYS, FORMULAS_HAVE)?;
        let friction = self.required_friction()?;
        if self.form.is_some() {
            names.require_spins()?;
            self.require_only(FORM_KEYS, FORMS_HAVE)?;
        }
        let rows = self.inner_product.as_ref().map(|given| given.rows(dimension));
        let inner_product = match self.form {
            Some(DampingForm::Gilbert) => return Ok(Damping::Gilbert(friction)),
            Some(DampingForm::LandauLifshitz) => InnerProduct::euclidean(),
            None => names.inner_product(rows.as_deref())?,
        };
        Ok(Damping::DoubleBracket { friction, inner_product })
    }
}

/// Checks that no keys are given but some.
pub(super) fn only(
    given: &[(&str, bool)],
    known: &[&str],
    has: &'static str,
) -> Result<(), SystemTableError> {
    match given.iter().find(|(key, is_there)| *is_there && !known.contains(key)) {
        Some((key, _)) => Err(SystemTableError::OtherKey { key: (*key).to_owned(), has }),
        None => Ok(()),
    }
}

impl InnerProductConfig {
    /// Returns the rows of the matrix, one after the other, for so many coordinates.
    pub(super) fn rows(&self, size: usize) -> Vec<f64> {
        let diagonal = |entries: &[f64]| {
            let size = entries.len();
            let mut rows = vec![0.0; size * size];
            rows.iter_mut().step_by(size + 1).zip(entries).for_each(|(x, entry)| *x = *entry);
            rows
        };
        match self {
            Self::Multiple(factor) => diagonal(&vec![*factor; size]),
            Self::Diagonal(entries) => diagonal(entries),
            Self::Rows(rows) => rows.concat(),
        }
    }
}
