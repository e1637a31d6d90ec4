//! A system of arrays with friction, forces, noise or a field in time, as a model: [`OpenArrays`].

use super::array_terms::{ArrayTerms, LatticeTerms};
use super::opened::Opened;
use crate::arrays::array_system::{ArraySystem, without_value};
use crate::error::RunFailure;
use crate::models::conserved::Conserved;
use crate::models::model::Model;
use collective_integrators::diagnostics::SystemScales;
use collective_integrators::{AnyIntegrator, AnyTangents};
use core::ops::Range;
use heavytop::methods::{Formulation, Method, SchemeName};
use lie_poisson_formula_systems::{FormulaSystemError, NamedInputs};
use std::sync::Arc;

/// A system of an [`ArrayKind`](crate::ArrayKind) with friction, forces, noise or a field in time, by a stochastic midpoint
/// rule.
///
/// A lattice of classical spins has friction, the noise of a temperature, and a uniform field B(t), by [`LangevinSpins`]. The
/// lengths of all spins are kept to round-off; h and the total spin are not. After a while the spins have Boltzmann's weight
/// exp(−h/kT), whatever the friction is, unless the field depends on the time. The value of h has the field of its time:
/// dh/dt = −Ḃ·Σ s_i without friction and noise.
///
/// A fluid on the sphere has viscosity, drag, a force, transport noise and stirring, by [`StochasticFluid`]. Transport
/// noise alone keeps the enstrophy, as all Casimirs, to round-off; the other terms change it.
///
/// [`LangevinSpins`]: lie_poisson_systems::LangevinSpins
/// [`StochasticFluid`]: lie_poisson_systems::StochasticFluid
///
/// # Example
/// A ring of four hundred spins at kT = J, whose energy per bond is −(coth 1 − 1) J:
/// ```
/// use lie_poisson_runs::{
///     Arguments, ArrayKind, Experiment, LatticeNoise, LatticeTerms, NoisePaths, OpenArrays, Pace, RunFailure, Schedule,
///     SpinDamping,
/// };
/// let kind = ArrayKind::named("spin-lattice").ok_or("no such system")?;
/// let ring = kind.system(&Arguments::new().list("shape", vec![400.0]).number("exchange", 1.0))?;
/// let start = ring.start_of(&Arguments::new().list("direction", vec![0.0, 0.0, 1.0]))?;
/// let noise = Some(LatticeNoise { temperature: 1.0, paths: NoisePaths::default() });
/// let terms = LatticeTerms { damping: Some(SpinDamping::LandauLifshitz(1.0)), noise, field: None };
/// let model = OpenArrays::new(ring, terms, 0.05)?;
/// let (method, pace) = (model.method(None, None, 0.0)?, Pace { schedule: Schedule::new(0.05, 10.0)?, every: 200 });
/// let run = Experiment { model, start, method, pace, attitude: false };
/// assert_eq!(run.conserved(), ["h", "M1", "M2", "M3", "C"]);
/// assert_eq!(run.kept(), [false, false, false, false, true]);
/// let mut energy = 0.0;
/// run.follow(None, |moment| Ok::<_, RunFailure>(energy = moment.row[1201] / 400.0))?;
/// assert!((energy + 1.0_f64.tanh().recip() - 1.0).abs() < 0.13); // four standard errors
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct OpenArrays {
    system: ArraySystem,
    terms: ArrayTerms,
    opened: Arc<dyn Opened>,
}

impl OpenArrays {
    /// The midpoint rule, the only scheme.
    pub const SCHEME: SchemeName = SchemeName::ImplicitMidpoint;

    /// Creates the model of runs with steps of a size, s, negative backward in time.
    ///
    /// # Errors
    /// Returns [`FormulaSystemError::Open`] if a number of the noise is not what it must be, or a temperature has no
    /// damping; and
    /// [`FormulaSystemError::KindValue`] if another number is not, if viscosity would act backward in time, or if the system has no such
    /// terms.
    pub fn new(
        system: ArraySystem,
        terms: impl Into<ArrayTerms>,
        step: f64,
    ) -> Result<Self, FormulaSystemError> {
        let terms = terms.into();
        let Some(opened) = system.opened(&terms, step) else {
            let needed = match &terms {
                ArrayTerms::Lattice(_) => {
                    "spin-lattice has friction, a temperature and a field in time"
                }
                ArrayTerms::Fluid(_) => "sphere-fluid has viscosity, a force and stirring",
            };
            let (kind, name) = (system.name(), terms.name());
            let needed = format!("left out: of the systems of arrays {needed}");
            return Err(FormulaSystemError::KindValue { kind, name, needed });
        };
        Ok(Self { opened: opened?.into(), system, terms })
    }

    /// Returns the system without friction, forces and noise.
    #[must_use]
    pub const fn system(&self) -> &ArraySystem {
        &self.system
    }

    /// Returns the formulation of the midpoint rule: that of the [kind of system](crate::ArrayKind::opened).
    #[must_use]
    pub fn formulation(&self) -> Formulation {
        self.system.kind().opened.unwrap_or_default()
    }

    /// Returns the method: the midpoint rule, whatever is left out. Its stages are solved to the tolerance, relative to
    /// the motion of a step; 0 iterates to the round-off floor.
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
        let own = self.formulation();
        let (formulation, scheme) = (formulation.unwrap_or(own), scheme.unwrap_or(Self::SCHEME));
        let has = if formulation != own {
            format!("it has {own} {}", Self::SCHEME)
        } else if scheme != Self::SCHEME {
            format!("{own} has {}", Self::SCHEME)
        } else {
            return Ok(Method::of_system(formulation, scheme, tolerance)?);
        };
        let algebra = format!("{} with friction, forces or noise", self.system.name());
        Err(FormulaSystemError::NoMethod { algebra, formulation, scheme, has })
    }

    /// Returns the inputs by tables, which must reach to the end of a run, if there is a field that depends on the time.
    #[must_use]
    pub fn inputs(&self) -> Option<&NamedInputs> {
        self.terms.inputs()
    }

    /// Returns the rate dμ/dt of a state at a time without noise, both in the arrays of the users; with noise it is the drift
    /// in Stratonovich's sense.
    ///
    /// # Errors
    /// If the state has another number of coordinates.
    pub fn rate(&self, given: &[f64], time: f64) -> Result<Vec<f64>, RunFailure> {
        let mut rate = self.opened.rate(time, &Model::start(self, given)?);
        self.system.present(&mut rate);
        Ok(rate)
    }

    /// Returns the number of the path of a run.
    fn path(&self) -> u64 {
        self.terms.paths().map_or(0, |paths| paths.path)
    }
}

impl SystemScales for OpenArrays {
    fn blocks(&self) -> Vec<Range<usize>> {
        self.system.blocks()
    }

    fn differential(&self, mu: &[f64]) -> Vec<f64> {
        self.system.differential(mu)
    }

    /// At most: the rate without a field in time, and the largest such field at the time 0 and at those of the tables.
    fn fastest_rate(&self, mu: &[f64]) -> f64 {
        self.system.fastest_rate(mu) + self.opened.rate_of_drive()
    }
}

impl Model for OpenArrays {
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
        Box::new(Quantities(self))
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
        Ok(self.opened.integrator(tolerance, self.path()))
    }

    /// With noise, paths converge with the strong order, which is 1 at best.
    fn order(&self, method: &Method) -> u16 {
        match self.terms.paths() {
            Some(_) => 1,
            None => method.scheme().order(),
        }
    }

    fn noise(&self) -> Option<(u64, u64)> {
        self.terms.paths().map(|paths| (paths.seed, paths.path))
    }

    fn noise_angle(&self, start: &[f64], step: f64) -> Option<f64> {
        self.terms.paths().map(|_| self.opened.noise_angle(start, step))
    }

    fn move_path(&self, state: &mut [f64], on: u64) {
        if let Some([number, _]) = state.last_chunk_mut() {
            *number = self.path().saturating_add(on) as f64;
        }
    }

    /// No step knows of those before.
    fn resumable_after(&self) -> u64 {
        self.system.resumable_after()
    }

    fn require_dimension(&self, momentum: &[f64]) -> Result<(), RunFailure> {
        self.system.require_dimension(momentum)
    }

    fn start(&self, given: &[f64]) -> Result<Vec<f64>, RunFailure> {
        Model::start(&self.system, given)
    }

    fn present(&self, momentum: &mut [f64]) {
        self.system.present(momentum);
    }

    fn formula(&self, conserved: &str) -> Option<String> {
        let without = self.system.formula(conserved)?;
        Some(match &self.terms {
            ArrayTerms::Lattice(LatticeTerms { field: Some(field), .. }) => {
                format!("{without} - {field}·sum(S[i])")
            }
            _ => without,
        })
    }
}

/// The quantities that the system without its terms would conserve.
struct Quantities<'a>(&'a OpenArrays);

impl Conserved for Quantities<'_> {
    fn names(&self) -> Vec<String> {
        self.0.opened.quantities()
    }

    fn is_kept(&self, name: &str) -> bool {
        self.0.opened.keeps(name)
    }

    fn append(&self, time: f64, momentum: &[f64], values: &mut Vec<f64>) {
        match self.0.require_dimension(momentum) {
            Ok(()) => self.0.opened.append(time, momentum, values),
            Err(_) => values.extend(self.names().iter().map(|_| f64::NAN)),
        }
    }

    fn without_value(&self, time: f64, momentum: &[f64]) -> String {
        without_value(self, time, momentum)
    }
}
