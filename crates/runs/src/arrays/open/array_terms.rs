//! What damps, forces and shakes a system of arrays: [`ArrayTerms`].

use super::lattice_field::LatticeField;
use super::noise_paths::NoisePaths;
use lie_poisson_formula_systems::NamedInputs;
use lie_poisson_systems::SpinDamping;

/// The friction, the force and the noise of a system of arrays.
#[derive(Clone, Debug, PartialEq)]
pub enum ArrayTerms {
    /// Those of a lattice of spins.
    Lattice(LatticeTerms),
    /// Those of a fluid on the sphere.
    Fluid(FluidTerms),
}

/// The friction of spins on a lattice, the noise that goes with it at a temperature, and a field that depends on the time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LatticeTerms {
    /// The uniform field B(t), which is damped, too.
    pub field: Option<LatticeField>,
    /// The damping of Landau and Lifshitz, or of Gilbert.
    pub damping: Option<SpinDamping>,
    /// The noise of a temperature, which needs a damping.
    pub noise: Option<LatticeNoise>,
}

/// The noise of a temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LatticeNoise {
    /// The energy kT, in the unit of the Hamiltonian.
    pub temperature: f64,
    /// The paths.
    pub paths: NoisePaths,
}

/// The viscosity, the drag, the force and the noise of a fluid on the sphere of radius 1, whose harmonics change at the
/// rate R_lm = F_lm − (α + ν (l(l + 1))ᵖ)(ω_lm − f_lm) besides their flow, where f is the vorticity of a sphere that
/// rotates.
#[derive(Clone, Debug, PartialEq)]
pub struct FluidTerms {
    /// The viscosity ν, in inverse units of time.
    pub viscosity: f64,
    /// The power p of the Laplace operator, 1 to 32; above 1 the viscosity is a hyperviscosity.
    pub power: u32,
    /// The linear drag α, in inverse units of time.
    pub drag: f64,
    /// The constant force F as rows l, m, Re F_lm, Im F_lm: the rate of the vorticity.
    pub force: Vec<[f64; 4]>,
    /// The noise.
    pub noise: Option<FluidNoise>,
}

impl Default for FluidTerms {
    fn default() -> Self {
        Self { viscosity: 0.0, power: 1, drag: 0.0, force: Vec::new(), noise: None }
    }
}

/// The noise of a fluid on the sphere.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FluidNoise {
    /// Transport noise, which carries the vorticity along and keeps its Casimirs: shells of random stream functions,
    /// whose strengths have the unit 1/√t.
    pub transport: Vec<HarmonicShell>,
    /// Stirring, a force that is white in time: shells of random vorticities, whose strengths have the unit 1/(t√t).
    pub stirring: Vec<HarmonicShell>,
    /// The paths.
    pub paths: NoisePaths,
}

/// Noise of one strength σ in all real orthonormal harmonics of some degrees, with a Brownian motion for each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicShell {
    /// The least and the largest degree.
    pub degrees: [usize; 2],
    /// The strength σ.
    pub strength: f64,
}

impl LatticeTerms {
    /// The kind of system that has these terms.
    pub const KIND: &str = "spin-lattice";
}

impl FluidTerms {
    /// The kind of system that has these terms.
    pub const KIND: &str = "sphere-fluid";
}

impl From<LatticeTerms> for ArrayTerms {
    fn from(terms: LatticeTerms) -> Self {
        Self::Lattice(terms)
    }
}

impl From<FluidTerms> for ArrayTerms {
    fn from(terms: FluidTerms) -> Self {
        Self::Fluid(terms)
    }
}

impl ArrayTerms {
    /// Returns the paths of the noise, if there is one.
    #[must_use]
    pub fn paths(&self) -> Option<&NoisePaths> {
        match self {
            Self::Lattice(terms) => terms.noise.as_ref().map(|noise| &noise.paths),
            Self::Fluid(terms) => terms.noise.as_ref().map(|noise| &noise.paths),
        }
    }

    /// Returns the inputs by tables, if there is a field that depends on the time.
    #[must_use]
    pub fn inputs(&self) -> Option<&NamedInputs> {
        match self {
            Self::Lattice(terms) => terms.field.as_ref().map(LatticeField::inputs),
            Self::Fluid(_) => None,
        }
    }

    /// Returns the name of one of the terms.
    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Lattice(LatticeTerms { field: Some(_), .. }) => "drive",
            Self::Lattice(LatticeTerms { damping: None, .. }) => "noise",
            Self::Fluid(terms) if !terms.force.is_empty() => "torque",
            _ => "damping",
        }
    }
}
