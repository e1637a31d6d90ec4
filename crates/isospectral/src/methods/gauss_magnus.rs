//! Exponential Gauss methods on u(N)∗: [`GaussMagnus`].

use crate::fields::isospectral_field::IsospectralField;
use crate::matrices::products::Products;
use crate::matrices::skew_hermitian::LargeSkewHermitian;
use crate::methods::conjugation::Conjugation;
use crate::methods::generator_history::GeneratorHistory;
use crate::methods::generator_sweeps::Sweeps;
use collective_integrators::{Integrator, SchemeError, StateIsMomentum, Step, StepError, Tableau};
use lie_poisson::State;

/// The Gauss–Magnus method with s = 1, 2 or 3 stages for [isospectral equations](IsospectralField): order 2s,
/// isospectral, but neither symmetric nor a Poisson map.
///
/// The Gauss method with s stages gives the generators B_i = B(W_i) at its nodes, the Magnus expansion gives a
/// skew-Hermitian Ω, and the step is a conjugation:
///
/// ```text
/// W_i = W₀ + h Σ_j a_ij [B_j, W_j],    W₁ = exp(Ω) W₀ exp(−Ω)
///
/// s = 1:  Ω = h B₁
/// s = 2:  Ω = (h/2)(B₁ + B₂) + (√3/12) h² [B₂, B₁]
/// s = 3:  Ω = α₁ + α₃/12 + [−20α₁ − α₃ + C₁, α₂ + C₂]/240,    C₁ = [α₁, α₂],    C₂ = −[α₁, 2α₃ + C₁]/60,
///         α₁ = h B₂,    α₂ = (√15/3) h (B₃ − B₁),    α₃ = (10/3) h (B₃ − 2B₂ + B₁)
/// ```
///
/// The spectrum is conserved to round-off for every Ω, so that the generators need only be as accurate as the solution:
/// see [`with_tolerance`](Self::with_tolerance). A sweep costs one product per stage. The error follows the time scale
/// of the generators, not the spectral radius of h B. This is the method of choice if the spectrum matters and the
/// bracket does not.
///
/// Source: Iserles, Munthe-Kaas, Nørsett & Zanna, *Lie-group methods*, Acta Numerica 9 (2000), §§4–5; Blanes, Casas &
/// Ros, *Improved high order integrators based on the Magnus expansion*, BIT 40 (2000).
///
/// # Example
/// ```
/// use collective_integrators::{Direct, RungeKutta, Start};
/// use isospectral_flows::{CommutatorField, GaussMagnus, IsospectralField, LargeSkewHermitian};
/// use num_complex::Complex;
/// # struct Weighted(usize);
/// # impl IsospectralField for Weighted {
/// #     fn size(&self) -> usize { self.0 }
/// #     fn generator_into(&self, w: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
/// #         *b = LargeSkewHermitian::from_upper(self.0, |j, k| w.at(j, k) / (1 + j + k) as f64);
/// #     }
/// # }
/// // Weighted(N) is an equation with B_jk = W_jk/(1 + j + k)
/// let start = LargeSkewHermitian::from_upper(6, |j, k| Complex::new(0.1 * j as f64, 0.2 * k as f64));
/// let magnus = GaussMagnus::new(3, Weighted(6))?.after(&start, 0.1, 50)?.state;
/// let direct = Direct::new(RungeKutta::rk4(), CommutatorField::new(Weighted(6))).after(&start, 0.1, 50)?.state;
/// // both are near the solution; one conserves the norm, which is a Casimir
/// assert!((magnus.at(0, 3) - direct.at(0, 3)).norm() < 1e-5);
/// let change = |w: &LargeSkewHermitian| (w.norm() - start.norm()).abs();
/// assert!(change(&magnus) < 1e-14 && change(&direct) > 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GaussMagnus<F> {
    field: F,
    tableau: Tableau,
    tolerance: f64,
}

/// The largest number of stages for which the Magnus expansion is known here.
const MOST_STAGES: usize = 3;

impl<F: IsospectralField> GaussMagnus<F> {
    /// Creates the method with the given number of stages. It solves for the generators to round-off.
    ///
    /// # Errors
    /// Returns [`SchemeError::Family`] if the number of stages is not 1, 2 or 3.
    pub fn new(stages: usize, field: F) -> Result<Self, SchemeError> {
        if !(1..=MOST_STAGES).contains(&stages) {
            let (family, least, most) = ("the Gauss–Magnus method", 1, MOST_STAGES);
            return Err(SchemeError::Family { family, least, most, stages });
        }
        Ok(Self { field, tableau: Tableau::gauss(stages)?, tolerance: 0.0 })
    }

    /// Returns the method with another tolerance for the generators: the largest accepted h |δB| in the last sweep,
    /// where
    /// |·| is the largest magnitude of a coordinate.
    ///
    /// The tolerance has no unit. A hundredth of the error of a step is small enough.
    #[must_use]
    pub fn with_tolerance(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Returns the equation that is integrated.
    pub fn field(&self) -> &F {
        &self.field
    }

    /// Returns the order 2s.
    #[must_use]
    pub fn order(&self) -> usize {
        self.tableau.order()
    }

    /// Solves for the generators at the nodes. Returns the number of sweeps.
    fn solve(
        &self,
        w: &LargeSkewHermitian,
        step: f64,
        space: &mut MagnusWorkspace,
    ) -> Result<usize, StepError> {
        let MagnusWorkspace { products, generators, fresh, stages, rates, history, .. } = space;
        if !history.predict(w, step, generators) {
            self.field.generator_into(w, &mut generators[0]);
            let (first, others) = generators.split_at_mut(1);
            others.iter_mut().for_each(|other| other.assign(&first[0]));
        }
        stages.iter_mut().for_each(|stage| stage.assign(w));
        let mut sweeps = Sweeps::new(self.tolerance, step);
        loop {
            for ((rate, generator), stage) in rates.iter_mut().zip(&*generators).zip(&*stages) {
                products.commutator(generator, stage, rate);
            }
            for (i, stage) in stages.iter_mut().enumerate() {
                stage.set_zero();
                stage.add_combination(self.tableau.row(i), rates);
                stage.scale_in_place(step);
                stage.add_in_place(w);
                self.field.generator_into(stage, &mut fresh[i]);
            }
            let last = sweeps.converged(fresh, generators)?;
            core::mem::swap(generators, fresh);
            if last {
                return Ok(sweeps.made);
            }
        }
    }
}

/// The storage of a step of [`GaussMagnus`].
#[derive(Clone, Debug)]
pub struct MagnusWorkspace {
    products: Products,
    generators: Vec<LargeSkewHermitian>,
    /// The generators of the next sweep.
    fresh: Vec<LargeSkewHermitian>,
    stages: Vec<LargeSkewHermitian>,
    rates: Vec<LargeSkewHermitian>,
    omega: LargeSkewHermitian,
    conjugation: Conjugation,
    history: GeneratorHistory,
}

impl MagnusWorkspace {
    /// Writes the Magnus series Ω. The stages and their rates are overwritten.
    fn set_magnus(&mut self, h: f64) {
        let Self { products, generators, fresh, stages, rates, omega, .. } = self;
        match (&generators[..], &mut stages[..], &mut rates[..], &mut fresh[..]) {
            ([b1, b2], ..) => {
                products.commutator(b2, b1, omega);
                omega.scale_in_place(3.0_f64.sqrt() / 12.0 * h * h);
                omega.add_multiple(0.5 * h, b1);
                omega.add_multiple(0.5 * h, b2);
            }
            ([b1, b2, b3], [a1, a2, a3], [c1, c2, inner], [left, right, _]) => {
                let factor = 15.0_f64.sqrt() / 3.0 * h;
                set_combination(a1, &[(h, b2)]);
                set_combination(a2, &[(factor, b3), (-factor, b1)]);
                let factor = 10.0 / 3.0 * h;
                set_combination(a3, &[(factor, b3), (-2.0 * factor, b2), (factor, b1)]);
                products.commutator(a1, a2, c1);
                set_combination(inner, &[(2.0, a3), (1.0, c1)]);
                products.commutator(a1, inner, c2);
                set_combination(left, &[(-20.0, a1), (-1.0, a3), (1.0, c1)]);
                set_combination(right, &[(1.0, a2), (-1.0 / 60.0, c2)]);
                products.commutator(left, right, omega);
                omega.scale_in_place(1.0 / 240.0);
                omega.add_multiple(1.0, a1);
                omega.add_multiple(1.0 / 12.0, a3);
            }
            (others, ..) => {
                omega.set_zero();
                others.iter().for_each(|b| omega.add_multiple(h, b));
            }
        }
    }
}

/// Writes a linear combination.
fn set_combination(sum: &mut LargeSkewHermitian, terms: &[(f64, &LargeSkewHermitian)]) {
    sum.set_zero();
    terms.iter().for_each(|(factor, term)| sum.add_multiple(*factor, term));
}

impl<F: IsospectralField> Integrator for GaussMagnus<F> {
    type State = LargeSkewHermitian;
    type Momentum = LargeSkewHermitian;
    type Workspace = MagnusWorkspace;

    fn workspace(&self) -> MagnusWorkspace {
        let (stages, size) = (self.tableau.stages(), self.field.size());
        let zero = LargeSkewHermitian::zeros(size);
        let several = || vec![zero.clone(); stages];
        // With more steps, the error of the generators would be enlarged by more than the prediction gains.
        let steps = if stages > 2 { 1 } else { 2 };
        MagnusWorkspace {
            products: Products::default(),
            generators: several(),
            fresh: several(),
            stages: several(),
            rates: several(),
            omega: zero.clone(),
            conjugation: Conjugation::new(size),
            history: GeneratorHistory::new(self.tableau.nodes(), steps),
        }
    }

    fn forget(&self, workspace: &mut MagnusWorkspace) {
        workspace.history.forget();
    }

    fn step(
        &self,
        w: &LargeSkewHermitian,
        step: f64,
        workspace: &mut MagnusWorkspace,
    ) -> Result<Step<LargeSkewHermitian>, StepError> {
        Step::of_copy(w, |w| self.step_in_place(w, step, workspace))
    }

    fn step_in_place(
        &self,
        w: &mut LargeSkewHermitian,
        step: f64,
        space: &mut MagnusWorkspace,
    ) -> Result<usize, StepError> {
        StepError::check_dimension(w, self.field.size().saturating_pow(2))?;
        let sweeps = self.solve(w, step, space)?;
        space.set_magnus(step);
        let MagnusWorkspace { products, generators, omega, conjugation, history, .. } = space;
        conjugation.by_exponential(products, omega, w)?;
        history.remember(generators, step, w);
        Ok(sweeps)
    }

    fn momentum(&self, w: &LargeSkewHermitian) -> LargeSkewHermitian {
        w.clone()
    }
}

impl<F> StateIsMomentum for GaussMagnus<F> {}
