//! The collective integrator of an orbit field with noise: [`Noisy`].

use crate::error::StepError;
use crate::integrators::collective::{Collective, SpaceOf};
use crate::integrators::trajectories::integrator::Integrator;
use crate::integrators::trajectories::start::Start;
use crate::open_systems::affine_flow::{affine_flow, has_affine_generators};
use crate::open_systems::noise_rule::{NoisePart, NoiseRule};
use crate::open_systems::paths::brownian_paths::BrownianPaths;
use crate::open_systems::smooth_pieces::Window;
use crate::open_systems::step_parts::StepParts;
use crate::schemes::scheme::{Equivariant, Scheme, Step};
use crate::vector_field::VectorField;
use lie_poisson::{
    Differential, InTime, Noise, OrbitField, Pair, PathAxis, PathNumber, ProductSpace, Real, Time,
    TimeAxis, Vector, nearest_break,
};
use momentum_map::{Identity, Lift, LiftError, PoissonMap, ProductMap, SourcePoint, TargetPoint};

/// The map (M, id): P × R² → 𝔤∗ × R² of states with the number of the path and the time.
type MapOfPaths<M> = ProductMap<M, Identity<InTime<PathAxis>>>;

/// The number of a path, and the time.
pub type PathAndTime<T> = Pair<PathNumber<T>, Time<T>>;

/// The collective integrator of an [orbit field](OrbitField) ξ with [noise](Noise) σ_k: a scheme for
///
/// ```text
/// dz = ξ(M(z), t)_P(z) dt + Σ_k σ_k(M(z), t)_P(z) ∘ dW_k,    with M: P → 𝔤∗ a realisation
/// ```
///
/// in Stratonovich's sense, so that dμ = Λξ dt + Σ_k Λσ_k ∘ dW_k. In a step the scheme sees one field, ξ + Σ_k (ΔW_k/h) σ_k,
/// or the fields one after the other: the [`NoiseRule`]. Both are generators, so that schemes that conserve quadratic
/// invariants keep the Casimirs of each path to round-off, as long as the stages of the steps are solved to it.
///
/// A momentum is (μ, (number of the path, time)). The number is a whole number, the same along the path: it and the time
/// determine the noise, as [`BrownianPaths`] says. So the members of an ensemble are starts with the numbers 0, 1, …, and
/// their results do not depend on threads, lanes or interruptions. The intervals of the paths are usually the steps of the
/// run; another step sees the same paths.
///
/// # Which step
/// The noise of a step h turns the state by about σ√h radians in each of its d directions. The stages are solved as long as
/// the turns of all directions together are below about three radians: a step fails with the probability that a χ² number
/// of d degrees is above (3.3/(σ√h))². For a heavy top at a temperature (d = 6) this is about once in a million steps for
/// σ√h = 0.53, where the first failure came after two million, and once in 10¹⁸ for σ√h = ⅓.
/// So take σ√h ≤ ⅓, and steps in which the motion itself turns by half a radian at most. Means have errors of a few per cent
/// there, which are proportional to h. To cut the increments at two or three standard deviations does not make longer steps
/// safe, since many directions add up. If constant fields act one after the other, their flows are exact for turns of any size, and only
/// the drift has stages.
///
/// Sources: Milstein, Repin & Tretyakov, SIAM J. Numer. Anal. 40 (2002); Luesink, Ephrati, Cifani & Geurts, *Casimir preserving
/// stochastic Lie–Poisson integrators*, Adv. Contin. Discrete Models (2024).
///
/// # Example
/// A spin in a field that fluctuates about e₃, ds/dt = s × (1 + ½ dW/dt) e₃: it turns by t + W(t)/2, and its mean goes down as
/// exp(−t/8).
/// ```
/// use collective_integrators::{BrownianPaths, NoiseRule, Noisy, RungeKutta, Start};
/// use lie_poisson::{Covector, LiePoisson, Noise, OrbitField, Pair, PathNumber, Real, So3, Time};
/// use momentum_map::HOPF;
/// use nalgebra::Vector3;
/// struct Field(f64);
/// impl<T: Real> OrbitField<LiePoisson<So3>, T> for Field {
///     fn element(&self, _: &Covector<Vector3<T>>, _: T) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), T::from_f64(self.0))
///     }
/// }
/// impl<T: Real> Noise<LiePoisson<So3>, T> for Field {
///     fn count(&self) -> usize {
///         1
///     }
///     fn element(&self, _: &Covector<Vector3<T>>, _: T, weights: &[T]) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), weights[0] * self.0)
///     }
/// }
/// let paths = BrownianPaths::new(1, 0.1)?;
/// let spin = Noisy::new(RungeKutta::gauss(3)?, HOPF, Field(1.0), Field(0.5), paths);
/// let mut mean = 0.0;
/// for path in 0..400 {
///     let start = Pair(Covector(Vector3::x()), Pair(PathNumber(path as f64), Time(0.0)));
///     let Pair(Covector(s), _) = spin.after(&start, 0.1, 20)?.momentum;
///     let mut noise = [0.0]; // W(2)
///     paths.write_increments(path, 0.0, 20.0, &mut noise);
///     let angle = 2.0 + 0.5 * noise[0];
///     assert!((s - Vector3::new(angle.cos(), -angle.sin(), 0.0)).norm() < 1e-4);
///     mean += s.x / 400.0;
/// }
/// assert!((mean - (-0.25_f64).exp() * 2.0_f64.cos()).abs() < 0.1); // three standard errors
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Noisy<S, M, X, N> {
    collective: Collective<S, MapOfPaths<M>, X>,
    noise: N,
    paths: BrownianPaths,
    rule: NoiseRule,
    /// Whether the flow of each field of the noise is that of an affine field on P.
    has_flows: bool,
}

impl<S: Equivariant, M: PoissonMap, X, N> Noisy<S, M, X, N> {
    /// Creates an integrator from a scheme that commutes with affine maps, with all noise [together](NoiseRule::Together).
    pub fn new(scheme: S, map: M, field: X, noise: N, paths: BrownianPaths) -> Self
    where
        X: OrbitField<M::Target>,
        N: Noise<M::Target>,
    {
        let has_flows = noise.is_constant() && has_affine_generators(&map);
        let map = ProductMap(map, Identity(ProductSpace(PathAxis, TimeAxis)));
        let collective = Collective::of_field(scheme, map, field);
        Self { collective, noise, paths, rule: NoiseRule::Together, has_flows }
    }

    /// Returns the integrator with another rule for the noise.
    #[must_use]
    pub fn with_rule(self, rule: NoiseRule) -> Self {
        Self { rule, ..self }
    }
}

impl<S, M, X, N> Noisy<S, M, X, N> {
    /// Returns the map M.
    pub fn map(&self) -> &M {
        &self.collective.system().map.0
    }

    /// Returns the noise.
    pub const fn noise(&self) -> &N {
        &self.noise
    }

    /// Returns the Brownian motions.
    pub const fn paths(&self) -> &BrownianPaths {
        &self.paths
    }

    /// Returns whether the steps descend to 𝔤∗: whether M(Φ(z)) depends on M(z) alone.
    pub const fn descends(&self) -> bool {
        self.collective.descends()
    }

    /// Moves a state by a part of a step without drift, in which the noise is constant.
    #[cfg_attr(optimised, inline(always))]
    fn turn<T: Real>(
        &self,
        Pair(z, Pair(_, clock)): &mut SourcePoint<MapOfPaths<M>, T>,
        window: Window<T>,
        NoisePart { weights, step, .. }: NoisePart<'_, T>,
    ) -> Result<usize, StepError>
    where
        M: PoissonMap,
        N: Noise<M::Target, T>,
    {
        let map = self.map();
        let time = window.nearest(clock.0 * self.paths.interval());
        let sigma = self.noise.element(&map.apply::<T>(z), time, weights);
        affine_flow(
            #[cfg_attr(optimised, inline(always))]
            |v, rate: &mut SourcePoint<M, T>| *rate = map.generator::<T>(&sigma, v),
            step,
            z,
        )
    }

    /// Makes the parts of a step.
    #[cfg_attr(optimised, inline(always))]
    fn parts<T: Real>(
        &self,
        Pair(path, clock): &PathAndTime<T>,
        step: f64,
        part: impl FnMut(Window<T>, NoisePart<'_, T>) -> Result<usize, StepError>,
    ) -> Result<usize, StepError>
    where
        M: PoissonMap,
        X: OrbitField<M::Target, T>,
        N: Noise<M::Target, T>,
    {
        let field = &self.collective.system().hamiltonian;
        let next_break = |time, forward| {
            let [drift, noise] =
                [field.next_break(time, forward), self.noise.next_break(time, forward)];
            nearest_break(drift, noise, forward)
        };
        let noise = Some((&self.paths, self.rule, self.noise.count()));
        StepParts { interval: self.paths.interval(), noise }.make(
            (path.0, clock.0),
            step,
            next_break,
            part,
        )
    }
}

/// The vector field (ξ_P(z), 0, drift/interval) at (z, path, time) with ξ = a ξ₀ + Σ_k w_k σ_k.
struct NoisyGenerator<'a, M, X, N, T> {
    map: &'a M,
    field: &'a X,
    noise: &'a N,
    part: NoisePart<'a, T>,
    window: Window<T>,
    interval: f64,
}

impl<M, X, N, T> VectorField<T> for NoisyGenerator<'_, M, X, N, T>
where
    M: PoissonMap,
    X: OrbitField<M::Target, T>,
    N: Noise<M::Target, T>,
    T: Real,
{
    type Point = SourcePoint<MapOfPaths<M>, T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, Pair(z, Pair(_, clock)): &Self::Point) -> Self::Point {
        let NoisePart { drift, weights, .. } = self.part;
        let time = self.window.nearest(clock.0 * self.interval);
        let mu = self.map.apply::<T>(z);
        let mut xi: Differential<M::Target, T> = Vector::zero();
        if drift != 0.0 {
            xi = self.field.element(&mu, time);
        }
        if !weights.is_empty() {
            xi += self.noise.element(&mu, time, weights);
        }
        let rate = Time(T::from_f64(drift / self.interval));
        Pair(self.map.generator::<T>(&xi, z), Pair(PathNumber(T::zero()), rate))
    }
}

impl<S, M, X, N, T> Integrator<T> for Noisy<S, M, X, N>
where
    S: Scheme,
    M: PoissonMap,
    X: OrbitField<M::Target, T>,
    N: Noise<M::Target, T>,
    T: Real,
{
    type State = SourcePoint<MapOfPaths<M>, T>;
    type Momentum = TargetPoint<MapOfPaths<M>, T>;
    type Workspace = SpaceOf<S, MapOfPaths<M>, T>;

    fn workspace(&self) -> Self::Workspace {
        self.collective.workspace_of::<T>()
    }

    #[cfg_attr(optimised, inline(always))]
    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        let (map, field, noise) = (self.map(), &self.collective.system().hamiltonian, &self.noise);
        let interval = self.paths.interval();
        Step::of_copy(
            state,
            #[cfg_attr(optimised, inline(always))]
            |point| {
                self.parts::<T>(
                    &state.1,
                    step,
                    #[cfg_attr(optimised, inline(always))]
                    |window, part| {
                        if part.drift == 0.0 && self.has_flows {
                            return self.turn::<T>(point, window, part);
                        }
                        // The noise before says nothing about that of this part.
                        self.collective.forget_stages_of::<T>(workspace);
                        let (collective, step) = (&self.collective, part.step);
                        let generator =
                            NoisyGenerator { map, field, noise, part, window, interval };
                        let made =
                            collective.step_of::<T, _>(&generator, point, step, workspace)?;
                        *point = made.point;
                        Ok(made.iterations)
                    },
                )
            },
        )
    }

    #[cfg_attr(optimised, inline(always))]
    fn forget(&self, workspace: &mut Self::Workspace) {
        self.collective.forget_of::<T>(workspace);
    }

    fn pin(&self, workspace: &mut Self::Workspace) {
        workspace.pin();
    }

    #[cfg_attr(optimised, inline(always))]
    fn momentum(&self, Pair(z, Pair(path, clock)): &Self::State) -> Self::Momentum {
        Pair(
            self.map().apply::<T>(z),
            Pair(*path, clock.scaled(T::from_f64(self.paths.interval()))),
        )
    }
}

impl<S, M, X, N, T> Start<T> for Noisy<S, M, X, N>
where
    S: Scheme,
    M: Lift,
    X: OrbitField<M::Target, T>,
    N: Noise<M::Target, T>,
    T: Real,
{
    /// Returns the lift of μ, the number of the path, and the time in intervals.
    fn start(&self, Pair(mu, Pair(path, time)): &Self::Momentum) -> Result<Self::State, LiftError> {
        let clock = Time(time.0 / T::from_f64(self.paths.interval()));
        Ok(Pair(self.map().lift::<T>(mu)?, Pair(*path, clock)))
    }
}
