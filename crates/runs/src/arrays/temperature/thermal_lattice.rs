//! A lattice of spins with friction, also at a temperature, as a model: [`ThermalLattice`].

use super::lattice_paths::LatticePaths;
use super::lattice_quantities::LatticeQuantities;
use super::lattice_terms::LatticeTerms;
use crate::arrays::array_system::ArraySystem;
use crate::arrays::renewed::resumable_after;
use crate::arrays::sites::open_lattice::OpenLattice;
use crate::arrays::sites::sites_system::{momenta, numbers};
use crate::error::RunFailure;
use crate::models::conserved::Conserved;
use crate::models::model::Model;
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents, StageSolver};
use core::ops::Range;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson::{Sites, SitesHamiltonian, State, larger};
use lie_poisson_formula_systems::FormulaSystemError;
use lie_poisson_systems::{LangevinSpins, SpinDamping};
use nalgebra::Vector3;

/// A lattice of classical spins of an [`ArrayKind`](crate::ArrayKind) with friction, and at a temperature if its terms have
/// one, by the stochastic midpoint rule of [`LangevinSpins`]. The lengths of all spins are kept to round-off; h and the total
/// spin are not. After a while the spins have Boltzmann's weight exp(−h/kT), whatever the friction is.
///
/// # Example
/// A ring of a thousand spins at kT = J, whose energy per bond is −(coth 1 − 1) J:
/// ```
/// use lie_poisson_runs::{
///     Arguments, ArrayKind, Experiment, LatticeNoise, LatticeTerms, Pace, RunFailure, Schedule, SpinDamping, ThermalLattice,
/// };
/// let kind = ArrayKind::named("spin-lattice").ok_or("no such system")?;
/// let ring = kind.system(&Arguments::new().list("shape", vec![1000.0]).number("exchange", 1.0))?;
/// let start = ring.start_of(&Arguments::new().list("direction", vec![0.0, 0.0, 1.0]))?;
/// let noise = Some(LatticeNoise { temperature: 1.0, seed: 1, path: 0, interval: None, bound: None });
/// let terms = LatticeTerms { damping: Some(SpinDamping::LandauLifshitz(1.0)), noise };
/// let model = ThermalLattice::new(ring, terms, 0.05)?;
/// let (method, pace) = (model.method(None, None, 0.0)?, Pace { schedule: Schedule::new(0.05, 10.0)?, every: 200 });
/// let run = Experiment { model, start, method, pace, attitude: false };
/// assert_eq!(run.conserved(), ["h", "M1", "M2", "M3", "C"]);
/// assert_eq!(run.kept(), [false, false, false, false, true]);
/// let mut energy = 0.0;
/// run.follow(None, |moment| Ok::<_, RunFailure>(energy = moment.row[3001] / 1000.0))?;
/// assert!((energy + 1.0_f64.tanh().recip() - 1.0).abs() < 0.08); // four standard errors
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ThermalLattice {
    system: ArraySystem,
    terms: LatticeTerms,
    langevin: LangevinSpins<OpenLattice>,
    damping: SpinDamping,
}

impl ThermalLattice {
    /// The formulation of the midpoint rule, which goes on the spins themselves.
    pub const FORMULATION: Formulation = Formulation::Direct;

    /// The midpoint rule, the only scheme.
    pub const SCHEME: SchemeName = SchemeName::ImplicitMidpoint;

    /// Creates the model of runs with steps of a size, s.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Open`] if a number of the terms is not what it must be, or a temperature has no damping,
    /// and [`FormulaSystemError::KindValue`] if the system is no lattice of spins.
    pub fn new(
        system: ArraySystem,
        terms: LatticeTerms,
        step: f64,
    ) -> Result<Self, FormulaSystemError> {
        let refused =
            |name, needed| FormulaSystemError::KindValue { kind: system.name(), name, needed };
        let name = if terms.damping.is_some() { "damping" } else { "noise" };
        let Some(lattice) = system.lattice() else {
            return Err(refused(
                name,
                "left out: of the systems of arrays spin-lattice has it".into(),
            ));
        };
        let (damping, temperature, paths) = terms.checked(step)?;
        let langevin = LangevinSpins::new(lattice.clone(), damping, temperature, paths);
        let langevin = langevin.map_err(|error| refused(name, format!("possible: {error}")))?;
        Ok(Self { system, terms, langevin, damping })
    }

    /// Returns the lattice without friction and noise.
    #[must_use]
    pub const fn system(&self) -> &ArraySystem {
        &self.system
    }

    /// Returns the friction and the noise.
    #[must_use]
    pub const fn terms(&self) -> &LatticeTerms {
        &self.terms
    }

    /// Returns the method: the midpoint rule, whatever is left out. Its stages are solved to the tolerance, relative to the
    /// rotations of a step; 0 iterates to the round-off floor.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::NoMethod`] if another formulation or scheme is asked for, and
    /// [`FormulaSystemError::Method`] for a tolerance that is negative or not finite.
    pub fn method(
        &self,
        formulation: Option<Formulation>,
        scheme: Option<SchemeName>,
        tolerance: f64,
    ) -> Result<Method, FormulaSystemError> {
        let (formulation, scheme) =
            (formulation.unwrap_or(Self::FORMULATION), scheme.unwrap_or(Self::SCHEME));
        let has = if formulation != Self::FORMULATION {
            format!("it has {} {}", Self::FORMULATION, Self::SCHEME)
        } else if scheme != Self::SCHEME {
            format!("{} has {}", Self::FORMULATION, Self::SCHEME)
        } else {
            return Ok(Method::of_system(formulation, scheme, tolerance)?);
        };
        let algebra = format!("{} with friction or noise", self.system.name());
        Err(FormulaSystemError::NoMethod { algebra, formulation, scheme, has })
    }

    /// Returns the rate ds/dt of all spins without noise; with noise it is the drift in Stratonovich's sense.
    ///
    /// # Errors
    /// If the state has another number of coordinates.
    pub fn rate(&self, state: &[f64]) -> Result<Vec<f64>, RunFailure> {
        self.require_dimension(state)?;
        let spins = momenta(state);
        let mut dh: Sites<Vector3<f64>> = State::zeros_of(&spins.0.len());
        self.langevin.hamiltonian().differential_into(&spins, &mut dh);
        let rates = spins.0.iter().zip(dh.iter()).map(|(spin, dh)| self.damping.rate(spin, &-dh));
        Ok(numbers(&rates.collect::<Vec<_>>()))
    }
}

impl SystemScales for ThermalLattice {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.system.blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.system.differential(mu)
    }

    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.system.fastest_rate(mu)
    }
}

/// h, the total spin and Σ |s_i|² have columns, and the motion keeps the last.
impl Model for ThermalLattice {
    fn algebra_name(&self) -> String {
        self.system.algebra_name()
    }

    fn coordinates(&self) -> Vec<(String, Vec<String>)> {
        self.system.coordinates()
    }

    fn shape(&self, coordinate: &str) -> Option<Vec<usize>> {
        self.system.shape(coordinate)
    }

    fn conserved(&self, _start: &[f64]) -> Box<dyn Conserved + '_> {
        Box::new(LatticeQuantities(self.langevin.hamiltonian()))
    }

    /// There are no tangent maps.
    fn tangent_integrator(
        &self,
        _method: &Method,
        _start: &[f64],
    ) -> Result<AnyIntegrator<dyn AnyTangents>, RunFailure> {
        Err(RunFailure::NoTangentsOfForces { kind: self.system.name() })
    }

    fn integrator(&self, method: &Method, _start: &[f64]) -> Result<AnyIntegrator, RunFailure> {
        let tolerance = method.tolerance();
        self.method(Some(method.formulation()), Some(method.scheme()), tolerance)?;
        let solver = StageSolver { tolerance, ..StageSolver::default() };
        let langevin = self.langevin.clone().with_solver(solver);
        let path = self.terms.noise.map_or(0, |noise| noise.path);
        Ok(LatticePaths { langevin, path }.erased(self.system.dimension() / 3))
    }

    /// With noise, paths converge with the strong order, which is 1 at best.
    fn order(&self, method: &Method) -> u16 {
        match self.terms.noise {
            Some(_) => 1,
            None => method.scheme().order(),
        }
    }

    fn noise(&self) -> Option<(u64, u64)> {
        self.terms.noise.map(|noise| (noise.seed, noise.path))
    }

    /// The largest of all spins: with Gilbert's damping short spins turn more.
    fn noise_angle(&self, start: &[f64], step: f64) -> Option<f64> {
        let temperature = self.terms.noise?.temperature;
        let friction = |spin: &Vector3<f64>| self.damping.friction(spin.norm());
        let friction = momenta(start).0.iter().map(friction).fold(0.0, larger);
        Some(2.0_f64.sqrt() * friction.sqrt() * temperature.sqrt() * step.abs().sqrt())
    }

    fn move_path(&self, state: &mut [f64], on: u64) {
        let path = self.terms.noise.map_or(0, |noise| noise.path);
        if let Some([number, _]) = state.last_chunk_mut() {
            *number = path.saturating_add(on) as f64;
        }
    }

    /// No step knows of those before.
    fn resumable_after(&self) -> u64 {
        resumable_after(self.system.dimension())
    }

    fn require_dimension(&self, momentum: &[f64]) -> Result<(), RunFailure> {
        self.system.require_dimension(momentum)
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        self.system.formula(conserved)
    }
}
