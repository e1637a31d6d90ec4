//! What makes a system an open one: [`OpenTerms`].

use super::named_inputs::NamedInputs;
use super::spin_terms::require_spins;
use crate::algebras::family::Family;
use crate::algebras::system_algebra::SystemAlgebra;
use crate::open_system_error::OpenSystemError;
use collective_integrators::NoiseRule;
use heavytop::methods::Formulation;
use lie_poisson::{InnerProduct, IsotropicNoise};
use lie_poisson_formulas::Formula;

/// What drives, damps, shakes or forces a system, all of it optional:
///
/// ```text
/// dμ = Λ(μ) (dh(μ, t) + u(μ, t) + θ (Λ dh)♯) dt + Σ_k Λ(μ) σ_k(μ, t) ∘ dW_k + F(μ, t) dt
/// ```
///
/// Gilbert's damping takes the place of the double bracket, if it is chosen.
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
    /// The friction, which damps dh + u.
    pub damping: Option<Damping>,
    /// The noise σ_k.
    pub noise: Option<NoiseTerms>,
    /// The torque F, with a formula for each coordinate of the momentum. It takes the motion off its coadjoint orbit. Beside noise that
    /// enters a step together it has a half step before and a half step after that of the rest, Strang's splitting of order 2.
    pub torque: Option<Vec<Formula>>,
}

/// Dissipation that stays on the coadjoint orbits.
#[derive(Clone, Debug, PartialEq)]
pub enum Damping {
    /// A [double bracket](lie_poisson::DoubleBracket), on the dual of any algebra.
    DoubleBracket {
        /// The friction θ.
        friction: f64,
        /// The inner product ♯.
        inner_product: InnerProduct,
    },
    /// [Gilbert's damping](lie_poisson::GilbertDamping) α of each spin, on sums of so(3)∗ alone.
    Gilbert(f64),
}

impl Damping {
    /// Returns the friction θ, or Gilbert's α.
    #[must_use]
    pub const fn friction(&self) -> f64 {
        match self {
            Self::DoubleBracket { friction, .. } | Self::Gilbert(friction) => *friction,
        }
    }
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
    /// That of Gilbert's damping α at the energy kT: √(2bkT) in all directions of a spin, b = α/((1 + α²)|s|).
    OfSpins {
        /// The damping α.
        damping: f64,
        /// The energy kT, in the unit of the Hamiltonian.
        temperature: f64,
    },
    /// Elements of the algebra, with a formula for each coordinate.
    Formulas(Vec<Vec<Formula>>),
}

impl NoiseFields {
    /// Returns the noise of a temperature, for a damping with its inner product: σ² = 2θkT; and for Gilbert's damping.
    ///
    /// # Errors
    /// Returns [`OpenSystemError`] without damping, with a damping of 0, which would make a temperature void, or for a
    /// negative temperature.
    pub fn thermal(damping: Option<&Damping>, temperature: f64) -> Result<Self, OpenSystemError> {
        let damping = damping.ok_or(OpenSystemError::TemperatureAlone)?.clone();
        OpenSystemError::require_thermal(damping.friction(), temperature)?;
        Ok(match damping {
            Damping::DoubleBracket { friction, inner_product } => {
                Self::Isotropic(IsotropicNoise::thermal(inner_product, (friction, temperature))?)
            }
            Damping::Gilbert(damping) => Self::OfSpins { damping, temperature },
        })
    }

    /// Returns the number of Brownian motions on an algebra of a dimension.
    #[must_use]
    pub fn count(&self, dimension: usize) -> usize {
        match self {
            Self::Isotropic(_) | Self::OfSpins { .. } => dimension,
            Self::Formulas(fields) => fields.len(),
        }
    }

    /// Returns whether no field changes along the motion that it makes on an algebra of a dimension: it depends on the time and on
    /// inputs alone, or on the lengths of spins.
    #[must_use]
    pub fn are_constant(&self, dimension: usize) -> bool {
        let is_constant = |formula: &Formula| !(0..dimension).any(|i| formula.depends_on(i));
        match self {
            Self::Isotropic(_) | Self::OfSpins { .. } => true,
            Self::Formulas(fields) => fields.iter().flatten().all(is_constant),
        }
    }
}

impl OpenTerms {
    /// Returns the formulations of an algebra that take the terms, the default one first: with a torque, which takes a motion off its
    /// coadjoint orbit, direct alone; otherwise direct and, where the algebra has it, collective; and with noise reduced, too, on so(3),
    /// su(2) and se(3).
    #[must_use]
    pub fn formulations(&self, algebra: &SystemAlgebra) -> Vec<Formulation> {
        if self.torque.is_some() {
            return vec![Formulation::Direct];
        }
        let first = algebra.default_formulation();
        let has_multipliers = matches!(algebra.family, Family::Rotations | Family::Motions);
        let others = algebra.formulations().filter(|other| match other {
            Formulation::Collective | Formulation::Direct => *other != first,
            Formulation::Reduced => self.noise.is_some() && has_multipliers,
            Formulation::Splitting => false,
        });
        core::iter::once(first).chain(others).collect()
    }

    /// Returns the friction of a system at a temperature: noise is in the inner product of the friction, σ² = 2θkT, or that of
    /// Gilbert's damping. Noise of a strength beside friction is at one, too.
    pub(super) fn thermal_friction(&self) -> Option<f64> {
        let damping = self.damping.as_ref()?;
        let is_thermal = match (damping, &self.noise.as_ref()?.fields) {
            (Damping::DoubleBracket { inner_product, .. }, NoiseFields::Isotropic(noise)) => {
                noise.strength > 0.0 && noise.inner_product == *inner_product
            }
            (Damping::Gilbert(_), NoiseFields::OfSpins { temperature, .. }) => *temperature > 0.0,
            _ => false,
        };
        Some(damping.friction()).filter(|friction| is_thermal && *friction > 0.0)
    }

    /// Checks what is not a formula.
    pub(super) fn require_sane(&self, algebra: &SystemAlgebra) -> Result<(), OpenSystemError> {
        let dimension = algebra.dimension();
        let noise = self.noise.as_ref().map(|noise| &noise.fields);
        let (of_damping, is_of_spins) = match &self.damping {
            Some(Damping::DoubleBracket { inner_product, .. }) => (Some(inner_product), false),
            damping => (None, damping.is_some()),
        };
        let of_noise = match noise {
            Some(NoiseFields::Isotropic(noise)) => Some(&noise.inner_product),
            _ => None,
        };
        let products = [of_damping, of_noise];
        if is_of_spins || matches!(noise, Some(NoiseFields::OfSpins { .. })) {
            require_spins(algebra)?;
        }
        for found in products.into_iter().flatten().filter_map(InnerProduct::dimension) {
            if found != dimension {
                return Err(OpenSystemError::InnerProductSize { expected: dimension, found });
            }
        }
        if let Some(damping) = &self.damping {
            OpenSystemError::require_thermal(damping.friction(), 0.0)?;
        }
        match noise {
            Some(NoiseFields::Isotropic(noise))
                if !(noise.strength >= 0.0 && noise.strength.is_finite()) =>
            {
                return Err(OpenSystemError::Strength { strength: noise.strength });
            }
            Some(NoiseFields::OfSpins { damping, temperature }) => {
                OpenSystemError::require_thermal(*damping, *temperature)?;
            }
            _ => {}
        }
        let elements = [("the drive", &self.drive), ("the torque", &self.torque)];
        for (what, formulas) in elements {
            let found = formulas.as_ref().map_or(dimension, Vec::len);
            require_count(what, dimension, found)?;
        }
        if let Some(NoiseFields::Formulas(fields)) = noise {
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
