//! What makes a system an open one: [`OpenTerms`].

use super::named_inputs::NamedInputs;
use crate::open_system_error::OpenSystemError;
use collective_integrators::NoiseRule;
use lie_poisson::{DissipationError, InnerProduct, IsotropicNoise};
use lie_poisson_formulas::Formula;

/// What drives, damps, shakes or forces a system, all of it optional:
///
/// ```text
/// dμ = Λ(μ) (dh(μ, t) + u(μ, t) + θ (Λ dh)♯) dt + Σ_k Λ(μ) σ_k(μ, t) ∘ dW_k + F(μ, t) dt
/// ```
///
/// Formulas are in the names that [`NamedInputs::vocabulary`] has: coordinates, the time `t`, inputs and parameters.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OpenTerms {
    /// The inputs that formulas name.
    pub inputs: NamedInputs,
    /// The Hamiltonian, if it depends on the time or on inputs.
    pub hamiltonian: Option<Formula>,
    /// The control u, an element of the algebra, with a formula for each coordinate.
    pub drive: Option<Vec<Formula>>,
    /// The friction θ and the inner product ♯ of the double bracket, which damps dh + u.
    pub damping: Option<Damping>,
    /// The noise σ_k.
    pub noise: Option<NoiseTerms>,
    /// The torque F, with a formula for each coordinate of the momentum. It takes the motion off its coadjoint orbit. Beside noise that
    /// enters a step together it has a half step before and a half step after that of the rest, Strang's splitting of order 2.
    pub torque: Option<Vec<Formula>>,
}

/// Dissipation by a [double bracket](lie_poisson::DoubleBracket).
#[derive(Clone, Debug, PartialEq)]
pub struct Damping {
    /// The friction θ.
    pub friction: f64,
    /// The inner product ♯.
    pub inner_product: InnerProduct,
}

/// Noise, and which of its paths a run has.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseTerms {
    /// The fields σ_k.
    pub fields: NoiseFields,
    /// The seed of all paths.
    pub seed: u64,
    /// The number of the path.
    pub path: u64,
    /// How noise enters a step.
    pub rule: NoiseRule,
    /// The length of the intervals of the paths; the step of the run, if none is given. With one that is given, runs with shorter steps
    /// see the same paths.
    pub interval: Option<f64>,
    /// The bound of the increments, in standard deviations; that of [`BrownianPaths`](collective_integrators::BrownianPaths) if
    /// none is given.
    pub bound: Option<f64>,
}

/// The fields of a noise.
#[derive(Clone, Debug, PartialEq)]
pub enum NoiseFields {
    /// The same in all directions of an inner product.
    Isotropic(IsotropicNoise),
    /// Elements of the algebra, with a formula for each coordinate.
    Formulas(Vec<Vec<Formula>>),
}

impl NoiseFields {
    /// Returns the noise of a temperature, for a damping with its inner product: σ² = 2θkT.
    ///
    /// # Errors
    /// Returns [`OpenSystemError`] without damping, or for a negative temperature.
    pub fn thermal(damping: Option<&Damping>, temperature: f64) -> Result<Self, OpenSystemError> {
        let Damping { friction, inner_product } =
            damping.ok_or(OpenSystemError::TemperatureAlone)?.clone();
        Ok(Self::Isotropic(IsotropicNoise::thermal(inner_product, (friction, temperature))?))
    }

    /// Returns the number of Brownian motions on an algebra of a dimension.
    #[must_use]
    pub fn count(&self, dimension: usize) -> usize {
        match self {
            Self::Isotropic(_) => dimension,
            Self::Formulas(fields) => fields.len(),
        }
    }

    /// Returns whether no field depends on the momentum of an algebra of a dimension; fields may depend on the time and on inputs.
    #[must_use]
    pub fn are_constant(&self, dimension: usize) -> bool {
        let is_constant = |formula: &Formula| !(0..dimension).any(|i| formula.depends_on(i));
        match self {
            Self::Isotropic(_) => true,
            Self::Formulas(fields) => fields.iter().flatten().all(is_constant),
        }
    }
}

impl OpenTerms {
    /// Checks what is not a formula.
    pub(super) fn require_sane(&self, dimension: usize) -> Result<(), OpenSystemError> {
        let products = [
            self.damping.as_ref().map(|damping| &damping.inner_product),
            self.noise.as_ref().and_then(|noise| match &noise.fields {
                NoiseFields::Isotropic(noise) => Some(&noise.inner_product),
                NoiseFields::Formulas(_) => None,
            }),
        ];
        for found in products.into_iter().flatten().filter_map(InnerProduct::dimension) {
            if found != dimension {
                return Err(OpenSystemError::InnerProductSize { expected: dimension, found });
            }
        }
        if let Some(Damping { friction, .. }) = self.damping
            && !(friction >= 0.0 && friction.is_finite())
        {
            return Err(DissipationError::Friction { friction }.into());
        }
        if let Some(NoiseTerms { fields: NoiseFields::Isotropic(noise), .. }) = &self.noise
            && !(noise.strength >= 0.0 && noise.strength.is_finite())
        {
            return Err(OpenSystemError::Strength { strength: noise.strength });
        }
        let elements = [("the drive", &self.drive), ("the torque", &self.torque)];
        for (what, formulas) in elements {
            let found = formulas.as_ref().map_or(dimension, Vec::len);
            require_count(what, dimension, found)?;
        }
        if let Some(NoiseTerms { fields: NoiseFields::Formulas(fields), .. }) = &self.noise {
            for (k, field) in (1..).zip(fields) {
                require_count(&format!("field {k} of the noise"), dimension, field.len())?;
            }
        }
        Ok(())
    }
}

fn require_count(what: &str, expected: usize, found: usize) -> Result<(), OpenSystemError> {
    match expected == found {
        true => Ok(()),
        false => Err(OpenSystemError::Count { what: what.into(), expected, found }),
    }
}
