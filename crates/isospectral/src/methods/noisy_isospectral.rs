//! Isospectral equations with noise: [`NoisyIsospectral`].

use crate::fields::driven_isospectral_field::DrivenIsospectralField;
use crate::fields::isospectral_field::IsospectralField;
use crate::fields::isospectral_noise::IsospectralNoise;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::methods::isospectral_runge_kutta::{IsospectralWorkspace, step_of_multiplier};
use collective_integrators::momentum_map::LiftError;
use collective_integrators::{
    BrownianPaths, Equivariant, Integrator, NoisePart, NoiseRule, PathAndTime, Start, Step,
    StepError, StepParts,
};
use lie_poisson::{Pair, State, Time, Vector};

/// The integrator of an [isospectral equation](DrivenIsospectralField) with [noise](IsospectralNoise), in Stratonovich's
/// sense:
///
/// ```text
/// dW = [B(W, t), W] dt + Σ_k [Ξ_k, W] ∘ dW_k
/// ```
///
/// A step is one of [`IsospectralRungeKutta`](crate::IsospectralRungeKutta) with the generator B(W, tₘ) + Σ_k (ΔW_k/h) Ξ_k, and
/// with the time tₘ in the middle of the step, so that an equation with the time in it has the order 2 at most. Steps are divided
/// where it jumps.
/// So each path keeps the spectrum of W to round-off, with every symplectic scheme; the implicit midpoint rule gives
/// the stochastic isospectral midpoint rule. The strong order is ½, and 1 if the generators Ξ_k commute with each
/// other; the weak order is 1. With the rule [`NoiseRule::Alternating`] the generators act one after the other, by their
/// exponentials, and the weak order is 2.
///
/// [Isotropic noise](crate::IsotropicIsospectralNoise#one-exponential) that alternates is made by one exponential instead, between
/// two halves of a step of the drift, with the same increments and orders.
///
/// The increments ΔW_k are those of [`BrownianPaths`]: functions of the seed, the number of the path, k and the time,
/// and bounded, so that the stage equations of a step that is short enough always have a solution. A momentum is (W,
/// (number of the path, time)), as that of [`Noisy`](collective_integrators::Noisy); a state has the time in intervals
/// of the paths.
///
/// Sources: Ephrati, Cifani, Viviani & Geurts, *Data-driven stochastic spectral modeling for coarsening of the
/// two-dimensional Euler equations on the sphere*, Phys. Fluids 35 (2023); Luesink, Ephrati, Cifani & Geurts, *Casimir
/// preserving stochastic Lie–Poisson integrators*, Adv. Contin. Discrete Models (2024).
///
/// # Example
/// Without a drift, and with one generator Ξ, the path is W(t) = exp(Ξ W₁(t)) W(0) exp(−Ξ W₁(t)):
/// ```
/// use collective_integrators::{BrownianPaths, RungeKutta, Start};
/// use isospectral_flows::{IsospectralField, LargeSkewHermitian, NoisyIsospectral};
/// use lie_poisson::{Pair, PathNumber, State, Time};
/// use num_complex::Complex;
/// struct Still(usize);
/// impl IsospectralField for Still {
///     fn size(&self) -> usize {
///         self.0
///     }
///     fn generator_into(&self, _: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
///         b.set_zero();
///     }
/// }
/// let paths = BrownianPaths::new(1, 0.01)?; // the seed, and the length of an interval
/// let xi = LargeSkewHermitian::from_upper(2, |j, k| Complex::new(0.0, if j == k { 0.5 - j as f64 } else { 0.0 }));
/// let noisy = NoisyIsospectral::new(RungeKutta::gauss(2)?, Still(2), vec![xi], paths);
/// let w = LargeSkewHermitian::from_upper(2, |_, k| Complex::new(k as f64, 0.0));
/// let path = 7;
/// let start = Pair(w, Pair(PathNumber(path as f64), Time(0.0)));
/// let Pair(end, Pair(_, time)) = noisy.after(&start, 0.01, 100)?.momentum;
/// let mut motion = [0.0]; // W₁(1), the angle by which Ξ has turned the entry
/// paths.write_increments(path, 0.0, 100.0, &mut motion);
/// assert!((end.at(0, 1) - Complex::from_polar(1.0, motion[0])).norm() < 1e-6);
/// assert!((time.0 - 1.0).abs() < 1e-12 && (end.norm() - start.0.norm()).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NoisyIsospectral<S, F, N> {
    scheme: S,
    field: F,
    noise: N,
    paths: BrownianPaths,
    rule: NoiseRule,
}

impl<S: Equivariant, F: DrivenIsospectralField, N: IsospectralNoise> NoisyIsospectral<S, F, N> {
    /// Creates an integrator that applies the scheme to the unitary matrices which move W, with all noise
    /// [together](NoiseRule::Together).
    pub const fn new(scheme: S, field: F, noise: N, paths: BrownianPaths) -> Self {
        Self { scheme, field, noise, paths, rule: NoiseRule::Together }
    }

    /// Returns this with another rule for the noise.
    #[must_use]
    pub fn with_rule(self, rule: NoiseRule) -> Self {
        Self { rule, ..self }
    }

    /// Returns this with another scheme.
    #[must_use]
    pub fn with_scheme(self, scheme: S) -> Self {
        Self { scheme, ..self }
    }

    /// Returns this with another noise.
    #[must_use]
    pub fn with_noise(self, noise: N) -> Self {
        Self { noise, ..self }
    }

    /// Returns the equation without noise.
    pub const fn field(&self) -> &F {
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
}

/// The storage of a step of [`NoisyIsospectral`].
pub struct NoisyIsospectralWorkspace<S: Equivariant> {
    stages: IsospectralWorkspace<S>,
    /// The constant part of a generator, or what turns W.
    noise: LargeSkewHermitian,
    weights: Vec<f64>,
    /// W at the beginning of a step, for one that fails.
    start: LargeSkewHermitian,
}

/// How noise enters a piece of a step.
#[derive(Clone, Copy)]
enum Entry {
    /// In the generator of the step.
    Together,
    /// Between halves of a step of the drift, by one exponential. It has the number λ.
    Isotropic(f64),
    /// As the weights of a part say.
    Alternating,
}

/// Where a piece of a step is in time.
struct Piece {
    /// The times in the middle of its first half, of it, and of its second half.
    times: [f64; 3],
    /// The number of the path.
    path: f64,
    /// The beginning and the end, in intervals of the paths.
    between: [f64; 2],
}

/// The generator B(W, t) + Ξ of a step, in which the time and the noise Ξ are constant.
struct WithNoise<'a, F> {
    field: &'a F,
    time: f64,
    noise: &'a LargeSkewHermitian,
}

impl<F: DrivenIsospectralField> IsospectralField for WithNoise<'_, F> {
    fn size(&self) -> usize {
        self.field.size()
    }

    fn generator_into(&self, w: &LargeSkewHermitian, generator: &mut LargeSkewHermitian) {
        self.field.generator_at_into(w, self.time, generator);
        generator.add_in_place(self.noise);
    }
}

impl<S: Equivariant, F: DrivenIsospectralField, N: IsospectralNoise> Integrator
    for NoisyIsospectral<S, F, N>
{
    type State = Pair<LargeSkewHermitian, PathAndTime<f64>>;
    type Momentum = Self::State;
    type Workspace = NoisyIsospectralWorkspace<S>;

    fn workspace(&self) -> Self::Workspace {
        NoisyIsospectralWorkspace {
            stages: IsospectralWorkspace::new(&self.scheme, self.field.size()),
            noise: LargeSkewHermitian::zeros(self.field.size()),
            weights: vec![0.0; self.noise.count()],
            start: LargeSkewHermitian::zeros(self.field.size()),
        }
    }

    fn step(
        &self,
        state: &Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<Step<Self::State>, StepError> {
        Step::of_copy(state, |state| self.step_in_place(state, step, workspace))
    }

    fn step_in_place(
        &self,
        Pair(w, clock): &mut Self::State,
        step: f64,
        workspace: &mut Self::Workspace,
    ) -> Result<usize, StepError> {
        StepError::check_start(clock, step)?;
        let Pair(path, time) = clock;
        let (interval, begin) = (self.paths.interval(), time.0);
        let entry = self.entry();
        // The other noise is divided as the pieces are.
        let alternates = matches!(entry, Entry::Alternating);
        let noise = alternates.then(|| (&self.paths, self.rule, self.noise.count()));
        workspace.start.assign(w);
        let mut elapsed = 0.0;
        let made = StepParts { interval, noise }.make(
            (path.0, begin),
            step,
            |time, forward| self.field.next_break(time, forward),
            |window, part| {
                let (from, to) = (elapsed, elapsed + part.step);
                elapsed += part.drift * part.step;
                let at = |fraction| window.nearest(begin * interval + from + fraction * part.step);
                let piece = Piece {
                    times: [0.25, 0.5, 0.75].map(at),
                    path: path.0,
                    between: [from, to].map(|elapsed| begin + elapsed / interval),
                };
                self.make_part((entry, &piece), part, w, workspace)
            },
        );
        if made.is_err() {
            w.assign(&workspace.start);
        }
        let iterations = made?;
        time.0 = begin + step / interval;
        Ok(iterations)
    }

    /// Every step forgets the stages of the one before.
    fn forget(&self, _: &mut Self::Workspace) {}

    fn momentum(&self, Pair(w, Pair(path, clock)): &Self::State) -> Self::Momentum {
        Pair(w.clone(), Pair(*path, clock.scaled(self.paths.interval())))
    }
}

impl<S: Equivariant, F: DrivenIsospectralField, N: IsospectralNoise> NoisyIsospectral<S, F, N> {
    fn entry(&self) -> Entry {
        match (self.rule, self.noise.isotropic_casimir()) {
            (NoiseRule::Together, _) => Entry::Together,
            (NoiseRule::Alternating, Some(casimir)) => Entry::Isotropic(casimir),
            (NoiseRule::Alternating, None) => Entry::Alternating,
        }
    }

    /// Replaces W by its value after a part of a step, which noise that alternates divides further.
    fn make_part(
        &self,
        (entry, piece): (Entry, &Piece),
        NoisePart { drift, weights, step }: NoisePart<'_, f64>,
        w: &mut LargeSkewHermitian,
        workspace: &mut NoisyIsospectralWorkspace<S>,
    ) -> Result<usize, StepError> {
        workspace.noise.set_zero();
        let [early, middle, late] = piece.times;
        match entry {
            Entry::Together => {
                // In a step of size 0 there is no noise.
                let divisor = if step == 0.0 { 1.0 } else { step };
                self.add_increments(piece, divisor, workspace);
                self.drift(middle, step, w, workspace)
            }
            Entry::Isotropic(casimir) => {
                let before = self.drift(early, 0.5 * step, w, workspace)?;
                let divisor = (1.0 + casimir * step.abs() / 24.0).sqrt();
                self.add_increments(piece, divisor, workspace);
                workspace.stages.turn(&workspace.noise, w)?;
                workspace.noise.set_zero();
                let after = self.drift(late, 0.5 * step, w, workspace)?;
                Ok(before + 1 + after)
            }
            Entry::Alternating if drift == 0.0 => {
                self.noise.add_to(weights, &mut workspace.noise);
                workspace.noise.scale_in_place(step);
                workspace.stages.turn(&workspace.noise, w).map(|()| 1)
            }
            Entry::Alternating => self.drift(middle, step, w, workspace),
        }
    }

    /// Adds Σ_k (ΔW_k/d) Ξ_k to the noise that is written, with the increments of a piece and a divisor d.
    fn add_increments(
        &self,
        Piece { path, between: [from, to], .. }: &Piece,
        divisor: f64,
        NoisyIsospectralWorkspace { noise, weights, .. }: &mut NoisyIsospectralWorkspace<S>,
    ) {
        self.paths.write_increments(*path as u64, *from, *to, weights);
        weights.iter_mut().for_each(|weight| *weight /= divisor);
        self.noise.add_to(weights, noise);
    }

    /// Replaces W by its value after a step with the generator at a time and the noise that is written.
    fn drift(
        &self,
        time: f64,
        step: f64,
        w: &mut LargeSkewHermitian,
        NoisyIsospectralWorkspace { stages, noise, .. }: &mut NoisyIsospectralWorkspace<S>,
    ) -> Result<usize, StepError> {
        let field = WithNoise { field: &self.field, time, noise };
        step_of_multiplier((&self.scheme, &field), w, step, stages)
    }
}

impl<S: Equivariant, F: DrivenIsospectralField, N: IsospectralNoise> Start
    for NoisyIsospectral<S, F, N>
{
    /// Returns W, the number of the path, and the time in intervals.
    fn start(&self, Pair(w, Pair(path, time)): &Self::Momentum) -> Result<Self::State, LiftError> {
        Ok(Pair(w.clone(), Pair(*path, Time(time.0 / self.paths.interval()))))
    }
}
