//! Spins in any number at a temperature: [`LangevinSpins`].

use crate::error::{SystemError, require_finite};
use crate::spins_at_temperature::field_in_time::FieldInTime;
use crate::spins_at_temperature::site_rotation::{SiteConstants, SpinDamping, turned_middle};
use collective_integrators::{
    BrownianPaths, Integrator, PathAndTime, StageSolver, Start, Step, StepError, StepParts,
};
use lie_poisson::{Covector, Pair, Sites, SitesHamiltonian, State, Time, Vector, larger};
use momentum_map::LiftError;
use nalgebra::Vector3;

/// Classical spins at a temperature, and in a field B(t), whose number is known only when the program runs: the stochastic
/// midpoint rule for
///
/// ```text
/// ds_i = s_i × (a_i H_i + b_i H_i × s_i) dt + √(2 b_i kT) s_i × ∘dW_i,    H_i = −∂h/∂s_i + B(t)
/// ```
///
/// in Stratonovich's sense, with three independent Brownian motions W_i for each spin. With the [`SpinDamping`] of Landau and
/// Lifshitz a = 1 and b = θ; with Gilbert's a = 1/(1 + α²) and b = α/((1 + α²)|s_i|). The invariant measure on the product
/// of the spheres is exp(−h/kT), whatever the damping is.
///
/// A step solves s′ = s + m × hω, m = (s + s′)/2, where hω = ha H + hb H × m + √(2bkT) ΔW at the midpoints m. This is a
/// rotation of each spin by the angle 2 arctan(h|ω|/2) or less, whatever ω is, so that every length |s_i| stays constant to
/// round-off, and a spin of length 0 stays where it is: it is a site without a spin. Sweeps alternate between the fields at
/// the midpoints and the midpoints of these rotations, which are known in closed form. So they converge for steps that are
/// short for h and the friction, however strong the noise is. The strong order is ½ and the weak order 1
/// (the energy of a bond of a chain at kT = 2J is too low by 0.0055 J with 2bkTh = 0.2); without noise the order is 2. The
/// field B(t) of [`with_field`](Self::with_field) is taken at the middle of a step, which is divided where B jumps.
///
/// A momentum is (s, (number of the path, time)), as that of [`Noisy`](collective_integrators::Noisy): the number and the
/// time determine the noise. After the first step nothing is allocated. The bracket is the plus bracket, as that of
/// [`HeisenbergLattice`](crate::HeisenbergLattice), h is any function of the spins, and kT has the unit of h.
///
/// Sources: Brown, Phys. Rev. 130 (1963), for the strength of the noise; d'Aquino, Serpico, Coppola, Mayergoyz &
/// Bertotti, *Midpoint numerical technique for stochastic Landau–Lifshitz–Gilbert dynamics*, J. Appl. Phys. 99 (2006).
///
/// # Example
/// A ring of four hundred spins, whose energy per bond is −J (coth K − 1/K) with K = J/kT:
/// ```
/// use collective_integrators::{BrownianPaths, Integrator, Start};
/// use lie_poisson::{Covector, Pair, PathNumber, SitesHamiltonian, Time};
/// use lie_poisson_systems::{HeisenbergLattice, LangevinSpins, SpinDamping};
/// use nalgebra::Vector3;
/// let ring = HeisenbergLattice::new([400, 1, 1])?.with_exchange([1, 0, 0], 1.0)?;
/// let spins = ring.state(|_| Vector3::z());
/// let paths = BrownianPaths::new(1, 0.05)?;
/// let langevin = LangevinSpins::new(ring.clone(), SpinDamping::LandauLifshitz(1.0), 1.0, paths)?;
/// let start = Pair(spins, Pair(PathNumber(0.0), Time(0.0)));
/// let Pair(spins, _) = langevin.after(&start, 0.05, 200)?.momentum;
/// let energy: f64 = ring.value(&spins) / 400.0;
/// assert!((energy + 1.0_f64.tanh().recip() - 1.0).abs() < 0.13); // four standard errors
/// assert!(spins.0.iter().all(|s| (s.norm() - 1.0).abs() < 1e-13));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LangevinSpins<H, F = ()> {
    hamiltonian: H,
    field: F,
    damping: SpinDamping,
    temperature: f64,
    paths: BrownianPaths,
    solver: StageSolver,
}

impl<H: SitesHamiltonian<Vector3<f64>>> LangevinSpins<H> {
    /// Creates the dynamics of a Hamiltonian with a damping, at the energy kT, with the noise of Brownian motions whose
    /// intervals are usually the steps of the run.
    ///
    /// # Errors
    /// Returns [`SystemError`] if the friction, the damping or kT is negative, infinite or NaN.
    pub fn new(
        hamiltonian: H,
        damping: SpinDamping,
        temperature: f64,
        paths: BrownianPaths,
    ) -> Result<Self, SystemError> {
        let (name, number) = damping.named();
        for (name, number) in [(name, number), ("the temperature kT", temperature)] {
            require_finite(name, number)?;
            if number < 0.0 {
                return Err(SystemError::Negative { name, value: number });
            }
        }
        let solver = StageSolver::default();
        Ok(Self { hamiltonian, field: (), damping, temperature, paths, solver })
    }
}

impl<H: SitesHamiltonian<Vector3<f64>>, F: FieldInTime> LangevinSpins<H, F> {
    /// Returns the dynamics in another field B(t), which has the unit of h over that of a spin.
    pub fn with_field<G: FieldInTime>(self, field: G) -> LangevinSpins<H, G> {
        let Self { hamiltonian, damping, temperature, paths, solver, .. } = self;
        LangevinSpins { hamiltonian, field, damping, temperature, paths, solver }
    }

    /// Returns the dynamics with another solver for its implicit equation, whose unknowns are the ω. Newton's iteration is
    /// not used. The lengths of the spins do not depend on the solver.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Returns the Hamiltonian without the field B(t).
    pub const fn hamiltonian(&self) -> &H {
        &self.hamiltonian
    }

    /// Returns the field B(t).
    pub const fn field(&self) -> &F {
        &self.field
    }

    /// Returns the Brownian motions.
    pub const fn paths(&self) -> &BrownianPaths {
        &self.paths
    }

    /// Prepares a part of a step: the field in its middle, the noise, and the constants of the sites.
    fn prepare(&self, state: &SpinsOnPath, step: f64, space: &mut LangevinWorkspace) {
        let Pair(Covector(spins), Pair(path, clock)) = state;
        space.uniform = self.field.at(clock.0 * self.paths.interval() + 0.5 * step);
        let count = spins.len();
        if space.fields.len() != count {
            space.fields = Sites::new(vec![Vector3::zeros(); count]);
            space.middles = Covector(space.fields.clone());
            space.sites.resize(count, SiteConstants::default());
            space.increments.resize(3 * count, 0.0);
        }
        // At the temperature 0 there is no noise: the increments stay 0.
        if self.temperature > 0.0 {
            let until = clock.0 + step / self.paths.interval();
            self.paths.write_increments(path.0 as u64, clock.0, until, &mut space.increments);
        }
        let noise = space.increments.as_chunks::<3>().0;
        for ((site, spin), noise) in space.sites.iter_mut().zip(spins.iter()).zip(noise) {
            *site =
                SiteConstants::new(self.damping, self.temperature, spin, &(*noise).into(), step);
        }
        space.middles.0.clone_from(spins);
    }

    /// Replaces the ω by those at the midpoints, and the midpoints by those of the rotations. Returns the largest change of
    /// a component of ω, and the largest component.
    fn sweep(
        &self,
        spins: &Sites<Vector3<f64>>,
        step: f64,
        space: &mut LangevinWorkspace,
    ) -> [f64; 2] {
        let LangevinWorkspace { fields, middles, sites, uniform, .. } = space;
        self.hamiltonian.differential_into(middles, fields);
        let mut progress = [0.0; 2];
        let all = sites.iter_mut().zip(spins.iter()).zip(fields.iter().zip(middles.0.iter_mut()));
        for ((site, spin), (dh, middle)) in all {
            let omega = site.rate(&(dh - *uniform), middle);
            progress[0] = larger(progress[0], (omega - site.omega).amax());
            progress[1] = larger(progress[1], omega.amax());
            site.omega = omega;
            *middle = turned_middle(spin, &(omega * (0.5 * step)));
        }
        progress
    }

    /// Makes a part of a step, in which the field is smooth.
    ///
    /// # Errors
    /// If its equation is not solved, or a number is not finite; the state is then not changed.
    fn make_part(
        &self,
        state: &mut SpinsOnPath,
        step: f64,
        space: &mut LangevinWorkspace,
    ) -> Result<usize, StepError> {
        self.prepare(state, step, space);
        if !space.uniform.is_finite() {
            return Err(StepError::NotFinite);
        }
        let spins = &state.0.0;
        let iterations = self.solver.solve_by_sweeps(|| self.sweep(spins, step, space))?;
        if !space.middles.is_finite() {
            return Err(StepError::NotFinite);
        }
        let Pair(Covector(spins), Pair(_, clock)) = state;
        for (spin, middle) in spins.iter_mut().zip(space.middles.0.iter()) {
            *spin = middle * 2.0 - *spin;
        }
        clock.0 += step / self.paths.interval();
        Ok(iterations)
    }
}

/// Spins, the number of their path, and the time.
type SpinsOnPath = Pair<Covector<Sites<Vector3<f64>>>, PathAndTime<f64>>;

/// The storage of a step of [`LangevinSpins`].
#[derive(Clone, Debug)]
pub struct LangevinWorkspace {
    middles: Covector<Sites<Vector3<f64>>>,
    fields: Sites<Vector3<f64>>,
    sites: Vec<SiteConstants>,
    increments: Vec<f64>,
    /// The field B in the middle of a part of a step.
    uniform: Vector3<f64>,
}

impl<H: SitesHamiltonian<Vector3<f64>>, F: FieldInTime> Integrator for LangevinSpins<H, F> {
    /// The spins, with the number of the path and the time in intervals of the Brownian motions.
    type State = SpinsOnPath;
    type Momentum = SpinsOnPath;
    type Workspace = LangevinWorkspace;

    fn workspace(&self) -> LangevinWorkspace {
        let none = || Sites::new(Vec::new());
        let (sites, increments) = (Vec::new(), Vec::new());
        let (middles, uniform) = (Covector(none()), Vector3::zeros());
        LangevinWorkspace { middles, fields: none(), sites, increments, uniform }
    }

    /// # Errors
    /// See [`step_in_place`](Self::step_in_place).
    fn step(
        &self,
        state: &SpinsOnPath,
        step: f64,
        space: &mut LangevinWorkspace,
    ) -> Result<Step<SpinsOnPath>, StepError> {
        Step::of_copy(state, |state| self.step_in_place(state, step, space))
    }

    /// Replaces the spins by those after one step.
    ///
    /// # Errors
    /// Returns [`StepError::NotConverged`] if the implicit equation is not solved, as with a step that is too long, or a
    /// state with another number of spins than the Hamiltonian has; those of [`StepError::check_start`] for the step, the path
    /// and the time; and [`StepError::NotFinite`], also where the field B(t) has no value. In these cases the state is not
    /// changed.
    fn step_in_place(
        &self,
        state: &mut SpinsOnPath,
        step: f64,
        space: &mut LangevinWorkspace,
    ) -> Result<usize, StepError> {
        StepError::check_start(&state.1, step)?;
        let (interval, clock) = (self.paths.interval(), state.1.1.0);
        let next_break = |time: f64, forward: bool| self.field.next_break(time, forward);
        let mut before = None;
        let made = StepParts { interval, noise: None }.make(
            (state.1.0.0, clock),
            step,
            next_break,
            |_, part| {
                if part.step != step && before.is_none() {
                    before = Some(state.clone());
                }
                self.make_part(state, part.step, space)
            },
        );
        match (made, before) {
            (Err(error), before) => {
                before.into_iter().for_each(|before| *state = before);
                Err(error)
            }
            (Ok(iterations), _) => {
                // Parts add up to the step but for rounding, which would make the time drift.
                state.1.1.0 = clock + step / interval;
                Ok(iterations)
            }
        }
    }

    /// Nothing is remembered from step to step.
    fn forget(&self, _: &mut LangevinWorkspace) {}

    fn momentum(&self, Pair(spins, Pair(path, clock)): &SpinsOnPath) -> SpinsOnPath {
        Pair(spins.clone(), Pair(*path, clock.scaled(self.paths.interval())))
    }
}

impl<H: SitesHamiltonian<Vector3<f64>>, F: FieldInTime> Start for LangevinSpins<H, F> {
    /// Returns the spins, the number of the path, and the time in intervals.
    fn start(&self, Pair(spins, Pair(path, time)): &SpinsOnPath) -> Result<SpinsOnPath, LiftError> {
        let clock = Time(time.0 / self.paths.interval());
        Ok(Pair(spins.clone(), Pair(*path, clock)))
    }
}
