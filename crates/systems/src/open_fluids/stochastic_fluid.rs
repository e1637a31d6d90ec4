//! A fluid on the sphere with transport noise, viscosity, and forces: [`StochasticFluid`].

use crate::error::SystemError;
use crate::matrix_hydrodynamics::zeitlin::Zeitlin;
use crate::open_fluids::harmonic_noise::HarmonicNoise;
use crate::open_fluids::viscous_forcing::ViscousForcing;
use collective_integrators::momentum_map::LiftError;
use collective_integrators::{
    BrownianPaths, Integrator, PathAndTime, RungeKutta, StageSolver, Start, Step, StepError,
    TorqueFlow,
};
use isospectral_flows::{LargeSkewHermitian, NoisyIsospectral, NoisyIsospectralWorkspace};
use lie_poisson::{Pair, State};

/// The integrator of a [fluid on the sphere](Zeitlin) with transport noise ξ_k, [viscosity, drag and a
/// force](ViscousForcing), and stirring η_k, a force that is white in time:
///
/// ```text
/// dW = [P, W]/ħ dt + Σ_k [ξ_k, W]/ħ ∘ dW_k + R dt + Σ_k η_k dB_k
/// ```
///
/// A step is half a step of R and η, a step of the stochastic isospectral midpoint rule ([`NoisyIsospectral`]), and
/// half a step of R and η. Each path keeps all Casimirs to round-off if R and η are zero, whatever the transport noise.
/// The stirred linear part has the law of its exact solution: a harmonic without flow has the variance σ²/2λ_l at every
/// step size. The strong order is that of the transport noise, ½, or 1 for noise that commutes or without it.
///
/// The Brownian motions are [functions of time](BrownianPaths): those of the transport noise are the first components
/// of a path, and those of the stirring the next. A momentum is (W, (number of the path, time)), and a state has the
/// time in intervals of the paths. Without viscosity a run backward in time retraces its path.
///
/// Sources: Ephrati, Cifani, Viviani & Geurts, Phys. Fluids 35 (2023), for the transport noise; Cifani, Viviani,
/// Luesink, Modin & Geurts, Phys. Rev. Fluids 7 (2022), for the splitting.
///
/// # Example
/// Transport noise alone keeps the Casimirs of a path, and changes its energy:
/// ```
/// use lie_poisson_systems::num_complex::Complex;
/// use lie_poisson_systems::prelude::*;
/// use lie_poisson_systems::lie_poisson::{PathNumber, Time};
/// let fluid = Zeitlin::new(12)?;
/// let noise = HarmonicNoise::none(&fluid).with_shell([3, 4], 0.05)?;
/// let paths = BrownianPaths::new(1, 0.02)?; // the seed, and the length of an interval
/// let method = StochasticFluid::new(ViscousForcing::new(fluid.clone()), paths).with_transport(noise)?;
/// let mut omega = VorticityCoefficients::zeros(12);
/// omega.set(2, 1, Complex::new(0.5, 0.0));
/// omega.set(5, 3, Complex::new(0.2, 0.1));
/// let start = Pair(fluid.vorticity(&omega), Pair(PathNumber(7.0), Time(0.0))); // path 7
/// let Pair(end, _) = method.after(&start, 0.02, 50)?.momentum;
/// for (before, after) in fluid.casimirs(&start.0, 12).iter().zip(fluid.casimirs(&end, 12)) {
///     assert!((after - before).abs() < 1e-13);
/// }
/// assert!((fluid.energy(&end) - fluid.energy(&start.0)).abs() > 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StochasticFluid {
    flow: NoisyIsospectral<RungeKutta, Zeitlin, HarmonicNoise>,
    forcing: ViscousForcing,
    stirring: HarmonicNoise,
}

impl StochasticFluid {
    /// Creates the integrator of a fluid with viscosity, drag and a force, without noise.
    #[must_use]
    pub fn new(forcing: ViscousForcing, paths: BrownianPaths) -> Self {
        let none = HarmonicNoise::none(forcing.fluid());
        let (midpoint, fluid) = (RungeKutta::implicit_midpoint(), forcing.fluid().clone());
        let flow = NoisyIsospectral::new(midpoint, fluid, none.clone(), paths);
        Self { flow, forcing, stirring: none }
    }

    /// Returns this with another solver for the stages of the midpoint rule.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        let midpoint = RungeKutta::implicit_midpoint().with_solver(solver);
        Self { flow: self.flow.with_scheme(midpoint), ..self }
    }

    /// Returns this with the transport noise ξ, whose functions are stream functions.
    ///
    /// # Errors
    /// Returns [`SystemError::Count`] if the noise is that of a fluid of another size.
    pub fn with_transport(self, noise: HarmonicNoise) -> Result<Self, SystemError> {
        self.check_size(&noise)?;
        Ok(Self { flow: self.flow.with_noise(noise), ..self })
    }

    /// Returns this with the stirring η, whose functions are vorticities.
    ///
    /// # Errors
    /// Returns [`SystemError::Count`] if the noise is that of a fluid of another size.
    pub fn with_stirring(self, noise: HarmonicNoise) -> Result<Self, SystemError> {
        self.check_size(&noise)?;
        Ok(Self { stirring: noise, ..self })
    }

    fn check_size(&self, noise: &HarmonicNoise) -> Result<(), SystemError> {
        let (expected, found) = (self.forcing.fluid().laplacian().size(), noise.size());
        let name = "rows of the matrices of a noise";
        if expected == found { Ok(()) } else { Err(SystemError::Count { name, expected, found }) }
    }

    /// Returns the viscosity, the drag and the force, with the fluid.
    #[must_use]
    pub const fn forcing(&self) -> &ViscousForcing {
        &self.forcing
    }

    /// Returns the transport noise.
    #[must_use]
    pub const fn transport(&self) -> &HarmonicNoise {
        self.flow.noise()
    }

    /// Returns the stirring.
    #[must_use]
    pub const fn stirring(&self) -> &HarmonicNoise {
        &self.stirring
    }

    /// Replaces W by its value after the viscosity, the force and the stirring have acted for a time, with the stirring
    /// of a path between two times that are counted in intervals.
    fn force(
        &self,
        w: &mut LargeSkewHermitian,
        time: f64,
        (path, [from, to]): (f64, [f64; 2]),
        increments: &mut [f64],
    ) -> Result<(), StepError> {
        self.forcing.flow(w, time)?;
        if self.stirring.count() > 0 {
            self.flow.paths().write_increments(path as u64, from, to, increments);
            let stirring = increments.get(self.transport().count()..).unwrap_or_default();
            // The variance of ∫e^(−λ(t−s)) dB is (1 − e^(−2λt))/2λ, and that of the increment is t.
            let factor = |l: usize| {
                let twice = 2.0 * self.forcing.decay_rate(l) * time;
                if twice == 0.0 { 1.0 } else { (-(-twice).exp_m1() / twice).sqrt() }
            };
            self.stirring.add_functions(stirring, factor, w);
        }
        Ok(())
    }
}

/// The storage of a step of [`StochasticFluid`].
pub struct StochasticFluidWorkspace {
    flow: NoisyIsospectralWorkspace<RungeKutta>,
    increments: Vec<f64>,
}

impl Integrator for StochasticFluid {
    type State = Pair<LargeSkewHermitian, PathAndTime<f64>>;
    type Momentum = Self::State;
    type Workspace = StochasticFluidWorkspace;

    fn workspace(&self) -> StochasticFluidWorkspace {
        let components = self.transport().count() + self.stirring.count();
        let increments = vec![0.0; components];
        StochasticFluidWorkspace { flow: self.flow.workspace(), increments }
    }

    fn step(
        &self,
        state: &Self::State,
        step: f64,
        StochasticFluidWorkspace { flow, increments }: &mut StochasticFluidWorkspace,
    ) -> Result<Step<Self::State>, StepError> {
        let mut after = state.clone();
        StepError::check_start(&state.1, step)?;
        StepError::check_dimension(&state.0, self.forcing.fluid().laplacian().size().pow(2))?;
        let Pair(path, time) = state.1;
        let whole = step / self.flow.paths().interval();
        let [from, middle, to] = [0.0, 0.5, 1.0].map(|part| time.0 + part * whole);
        self.force(&mut after.0, 0.5 * step, (path.0, [from, middle]), increments)?;
        let iterations = self.flow.step_in_place(&mut after, step, flow)?;
        self.force(&mut after.0, 0.5 * step, (path.0, [middle, to]), increments)?;
        match after.0.is_finite() {
            true => Ok(Step { point: after, iterations }),
            false => Err(StepError::NotFinite),
        }
    }

    fn forget(&self, StochasticFluidWorkspace { flow, .. }: &mut StochasticFluidWorkspace) {
        self.flow.forget(flow);
    }

    fn momentum(&self, state: &Self::State) -> Self::Momentum {
        self.flow.momentum(state)
    }
}

impl Start for StochasticFluid {
    /// Returns W, the number of the path, and the time in intervals.
    fn start(&self, mu: &Self::Momentum) -> Result<Self::State, LiftError> {
        self.flow.start(mu)
    }
}
