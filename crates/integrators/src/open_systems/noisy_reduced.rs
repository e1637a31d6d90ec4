//! The stochastic midpoint rule in closed form on 𝔤∗: [`NoisyReduced`].

use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::iteration::stage_solver::StageSolver;
use crate::open_systems::affine_flow::{affine_flow, has_affine_generators};
use crate::open_systems::noise_rule::{NoisePart, NoiseRule};
use crate::open_systems::noisy::PathAndTime;
use crate::open_systems::paths::brownian_paths::BrownianPaths;
use crate::open_systems::smooth_pieces::Window;
use crate::open_systems::step_parts::StepParts;
use crate::schemes::scheme::Step;
use lie_poisson::{
    Differential, Noise, OrbitField, Pair, Point, PoissonSpace, Real, Time, Vector, nearest_break,
};
use momentum_map::{Identity, InvertibleMultipliers, LiftError, Multiplier, Multipliers};

/// The collective midpoint rule of an [orbit field](OrbitField) ξ with [noise](Noise) σ_k, without a lift: the map of
/// [`Noisy`](crate::Noisy) with [`RungeKutta::implicit_midpoint`](crate::RungeKutta::implicit_midpoint) and all noise
/// [together](NoiseRule::Together), with fewer unknowns; or that with [another rule](Self::with_rule). The benchmark `open_systems` of `heavytop` times both.
///
/// With the motion ζ of a step, and the inverse of [multipliers](momentum_map::Multipliers), it reads
///
/// ```text
/// ζ = h ξ(μₘ, tₘ) + Σ_k ΔW_k σ_k(μₘ, tₘ),    Qₘ = (1 − ζ/2)⁻¹,    μₘ = transport(Qₘ, μ₀)
/// Q₁ = 2Qₘ − 1,    μ₁ = transport(Q₁, μ₀)
/// ```
///
/// and is solved for ζ by a fixed-point iteration to the round-off floor. The rotation is exact for every ζ, so that noise that
/// does not depend on μ takes no part in the iteration: it converges where h ∂ξ/∂μ is small, however large the noise is, also
/// where steps of [`Noisy`](crate::Noisy), on the space of the lift, fail. Each path keeps all Casimirs to round-off, also if the
/// iteration stops at a [tolerance](Self::with_solver). A step does not depend on the steps before it.
///
/// The sign is that of the multipliers: dμ = Λξ dt + Σ_k Λσ_k ∘ dW_k, with dμ = Π × ξ dt on so(3)∗ with the minus bracket.
/// A momentum is (μ, (number of the path, time)), as that of [`Noisy`](crate::Noisy); all of 𝔤∗ is allowed.
///
/// Sources: Milstein, Repin & Tretyakov, SIAM J. Numer. Anal. 40 (2002); Ohsawa 2019, §5.1, for the midpoint rule without a lift.
///
/// # Example
/// The steps are those of [`Noisy`](crate::Noisy):
/// ```
/// use collective_integrators::{BrownianPaths, Noisy, NoisyReduced, RungeKutta, Start};
/// use lie_poisson::{Autonomous, Covector, InnerProduct, IsotropicNoise, LiePoisson, Pair, PathNumber, So3, Time, from_closure};
/// use momentum_map::{HOPF, Quaternions};
/// use nalgebra::Vector3;
/// let body = Autonomous(from_closure::<LiePoisson<So3>, _>(|Covector(pi)| pi.x * pi.x * 0.5 + pi.y * pi.y));
/// let noise = || IsotropicNoise::thermal(InnerProduct::euclidean(), (0.1, 0.5));
/// let paths = BrownianPaths::new(1, 0.1)?;
/// let reduced = NoisyReduced::new(Quaternions, body.clone(), noise()?, paths);
/// let lifted = Noisy::new(RungeKutta::implicit_midpoint(), HOPF, body, noise()?, paths);
/// let start = Pair(Covector(Vector3::new(0.6, 0.0, 0.8)), Pair(PathNumber(7.0), Time(0.0)));
/// let (one, other) = (reduced.after(&start, 0.1, 100)?.momentum, lifted.after(&start, 0.1, 100)?.momentum);
/// assert!((one.0 - other.0).0.norm() < 1e-12);
/// assert!((one.0.0.norm() - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NoisyReduced<M, X, N> {
    multipliers: M,
    field: X,
    noise: N,
    paths: BrownianPaths,
    rule: NoiseRule,
    solver: StageSolver,
    /// Whether the fields of the noise are constant: a step finds their sum once.
    is_constant: bool,
    /// Whether the flow of each field of the noise is that of an affine field on 𝔤∗.
    has_flows: bool,
}

/// A momentum, the number of its path, and the time.
type StateOf<M, T> = Pair<Point<<M as Multipliers>::Space, T>, PathAndTime<T>>;

/// The iteration on ζ has no derivative, and each of its sweeps costs little.
const FIXED_POINT: StageSolver = StageSolver { tolerance: 0.0, max_iterations: 200, newton: false };

impl<M: InvertibleMultipliers, X, N> NoisyReduced<M, X, N> {
    /// Creates the integrator, with all noise together and an iteration that goes on to the round-off floor.
    pub fn new(multipliers: M, field: X, noise: N, paths: BrownianPaths) -> Self
    where
        X: OrbitField<M::Space>,
        N: Noise<M::Space>,
    {
        let is_constant = noise.is_constant();
        let has_flows = is_constant && has_affine_generators(&Identity(multipliers.space()));
        let rule = NoiseRule::Together;
        Self { multipliers, field, noise, paths, rule, solver: FIXED_POINT, is_constant, has_flows }
    }

    /// Returns the integrator with another rule for the noise. [`NoiseRule::Alternating`] has the weak order 2 if the noise is
    /// [constant](Noise::is_constant): the steps of the drift are those of the midpoint rule, and those of the noise the coadjoint
    /// action of exp(ΔW_k σ_k), to round-off.
    #[must_use]
    pub fn with_rule(self, rule: NoiseRule) -> Self {
        Self { rule, ..self }
    }

    /// Replaces the solver of the fixed-point iteration. Its tolerance is a part of ζ: the relative error of the motion of a step.
    /// Each step moves along the orbit by an element of the group all the same. The tolerance 1e-6 about halves the number of
    /// sweeps, and is far below the errors of a few per cent that means have at the largest steps that are
    /// [safe](crate::Noisy#which-step).
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }
}

impl<M, X, N> NoisyReduced<M, X, N> {
    /// Returns the field ξ.
    pub const fn field(&self) -> &X {
        &self.field
    }

    /// Returns the noise.
    pub const fn noise(&self) -> &N {
        &self.noise
    }

    /// Returns the Brownian motions.
    pub const fn paths(&self) -> &BrownianPaths {
        &self.paths
    }

    /// Returns the solver of the fixed-point iteration: by default one to the round-off floor, with at most 200 sweeps.
    pub const fn solver(&self) -> &StageSolver {
        &self.solver
    }
}

/// The rate ζ = a ξ + Σ_k w_k σ_k at a time, with a = 0 or 1.
struct Rate<'a, P: PoissonSpace, X, N, T: Real> {
    field: &'a X,
    noise: &'a N,
    time: T,
    drift: f64,
    weights: &'a [T],
    /// Σ_k w_k σ_k, if it does not depend on the momentum.
    constant: Option<Differential<P, T>>,
}

impl<P, X, N, T: Real> Rate<'_, P, X, N, T>
where
    P: PoissonSpace,
    X: OrbitField<P, T>,
    N: Noise<P, T>,
{
    #[cfg_attr(optimised, inline(always))]
    fn at(&self, mu: &Point<P, T>) -> Differential<P, T> {
        let mut zeta = Vector::zero();
        if self.drift != 0.0 {
            zeta = self.field.element(mu, self.time);
        }
        if let Some(constant) = self.constant {
            zeta += constant;
        } else if !self.weights.is_empty() {
            zeta += self.noise.element(mu, self.time, self.weights);
        }
        zeta
    }
}

impl<M: InvertibleMultipliers, X, N> NoisyReduced<M, X, N> {
    /// Returns Qₘ = (1 − hζ/2)⁻¹ for a rate ζ.
    #[cfg_attr(optimised, inline(always))]
    fn middle<T: Real>(&self, zeta: &Differential<M::Space, T>, step: f64) -> Multiplier<M, T> {
        let one = self.multipliers.one::<T>();
        let generator = self.multipliers.generate::<T>(zeta, &one);
        self.multipliers.inverse::<T>(&(one - generator.scaled(T::from_f64(0.5 * step))))
    }

    /// Moves a state by a part of a step. Returns the number of sweeps.
    #[cfg_attr(optimised, inline(always))]
    fn move_by<T: Real>(
        &self,
        Pair(mu, Pair(_, clock)): &mut StateOf<M, T>,
        window: Window<T>,
        NoisePart { drift, weights, step }: NoisePart<'_, T>,
    ) -> Result<usize, StepError>
    where
        X: OrbitField<M::Space, T>,
        N: Noise<M::Space, T>,
    {
        let interval = self.paths.interval();
        let elapsed = T::from_f64(drift * step / interval);
        let time = window.nearest((clock.0 + elapsed * 0.5) * interval);
        if drift == 0.0 && self.has_flows {
            let (sigma, space) = (self.noise.element(mu, time, weights), self.multipliers.space());
            return affine_flow(
                #[cfg_attr(optimised, inline(always))]
                |mu, rate| *rate = space.hamiltonian_vector::<T>(mu, &sigma),
                step,
                mu,
            );
        }
        let is_constant = self.is_constant && !weights.is_empty();
        let constant = is_constant.then(|| self.noise.element(mu, time, weights));
        let (field, noise) = (&self.field, &self.noise);
        let rate = Rate { field, noise, time, drift, weights, constant };
        let mut zeta = [Vector::zero()];
        let sweeps = self.solver.solve(
            rate.at(mu),
            &mut zeta,
            #[cfg_attr(optimised, inline(always))]
            |_: usize, zeta: &[Differential<M::Space, T>]| {
                let middle = self.middle::<T>(&zeta[0], step);
                rate.at(&self.multipliers.transport::<T>(&middle, mu))
            },
        )?;
        let [zeta] = zeta;
        let middle = self.middle::<T>(&zeta, step);
        let whole = middle + (middle - self.multipliers.one::<T>());
        *mu += self.multipliers.coadjoint_change::<T>(&whole, mu);
        clock.0 += elapsed;
        Ok(sweeps)
    }
}

impl<M, X, N, T> Integrator<T> for NoisyReduced<M, X, N>
where
    M: InvertibleMultipliers,
    X: OrbitField<M::Space, T>,
    N: Noise<M::Space, T>,
    T: Real,
{
    type State = StateOf<M, T>;
    type Momentum = Self::State;
    type Workspace = ();

    fn workspace(&self) {}

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        (): &mut (),
    ) -> Result<Step<Self::State>, StepError> {
        let noise = Some((&self.paths, self.rule, self.noise.count()));
        let parts = StepParts { interval: self.paths.interval(), noise };
        let Pair(path, clock) = state.1;
        Step::of_copy(
            state,
            #[cfg_attr(optimised, inline(always))]
            |state| {
                parts.make(
                    (path.0, clock.0),
                    step,
                    |time, forward| {
                        let [drift, noise] = [
                            self.field.next_break(time, forward),
                            self.noise.next_break(time, forward),
                        ];
                        nearest_break(drift, noise, forward)
                    },
                    #[cfg_attr(optimised, inline(always))]
                    |window, part| self.move_by::<T>(state, window, part),
                )
            },
        )?
        .finite()
    }

    fn forget(&self, (): &mut ()) {}

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, Pair(mu, Pair(path, clock)): &Self::State) -> Self::Momentum {
        Pair(*mu, Pair(*path, clock.scaled(T::from_f64(self.paths.interval()))))
    }
}

impl<M, X, N, T> Start<T> for NoisyReduced<M, X, N>
where
    M: InvertibleMultipliers,
    X: OrbitField<M::Space, T>,
    N: Noise<M::Space, T>,
    T: Real,
{
    /// Returns μ, the number of the path, and the time in intervals.
    fn start(&self, Pair(mu, Pair(path, time)): &Self::Momentum) -> Result<Self::State, LiftError> {
        let clock = Time(time.0 / T::from_f64(self.paths.interval()));
        Ok(Pair(*mu, Pair(*path, clock)))
    }
}
