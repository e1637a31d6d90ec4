//! Collective Gauss methods of many tops at once.

use crate::kernels::gauss_many::spinor_field::FieldParameters;
use crate::kernels::gauss_many::spinor_step::{ExtendedTableau, SpinorLanes};
use crate::tops::top::HeavyTop;
use collective_integrators::{
    BatchIntegrator, IntegrationError, Integrator, LaneKernel, LaneResults, LiftFree, Registers,
    RungeKutta, SchemeError, Tableau, lagrange_polynomial,
};
use core::ops::Range;
use lie_poisson::{InstructionSet, Lanes, Mask, MissingInstructions, Se3Dual, State, Width};
use momentum_map::DualQuaternions;

/// The collective Gauss method with S stages, of order 2S, for many tops with separate parameters.
///
/// The tops are advanced in the SIMD lanes of the processor's registers. Each lane holds one top, so a register
/// advances several trajectories.
///
/// One step is that of [`LiftFree`] with [`RungeKutta::gauss`], to round-off. The stage equations are solved by sweeps,
/// which compute each stage from the newest derivatives of the others. The sweeps begin with the polynomial through the
/// stages of the last step. The iteration of a top stops where its own stages have converged. A top whose stages do not
/// converge, whose Γ is 0, or that is not finite is advanced by [`LiftFree`] instead, and fails if that integrator
/// fails.
///
/// The result for a top depends neither on the others nor on the number of lanes. It is bit-identical at every
/// [`Width`], and on all instruction sets that fuse products with sums. [`InstructionSet::Portable`] does not fuse
/// them, and its results differ by rounding.
///
/// Source: the method of Ohsawa 2019, §4–5, in the lift-free form of [`LiftFree`].
///
/// # Example
/// ```
/// use collective_integrators::Ensemble;
/// use heavytop::{Body, GaussBatch, HeavyTop, Invariant};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let body = Body {
///     inertia: Vector3::new(1.0, 1.4, 0.8),
///     mass: 1.0,
///     gravity: 1.0,
///     length: 1.0,
///     center_of_mass: Vector3::new(0.6, 0.48, 0.64),
/// };
/// let top = HeavyTop::new(&body)?;
/// let start = |i: u32| {
///     Se3Dual::new(Vector3::new(1.0, 0.5, f64::from(i) / 50.0), Vector3::new(0.6, 0.0, 0.8))
/// };
/// let mut tops: Vec<_> = (0..100).map(|i| (top, start(i))).collect();
/// let ensemble = Ensemble::new(GaussBatch::<8>::new()?);
/// assert!(ensemble.advance(&mut tops, 0.25, 0..40).is_empty());
/// let energy = |mu: &Se3Dual| Invariant::Energy.value(&top, mu);
/// for (i, (_, mu)) in (0..).zip(&tops) {
///     assert!((energy(mu) - energy(&start(i))).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GaussBatch<const S: usize> {
    scheme: RungeKutta,
    coefficients: ExtendedTableau<S>,
    registers: Registers,
}

impl<const S: usize> GaussBatch<S> {
    /// Creates the method on the widest registers that the processor has.
    ///
    /// # Errors
    /// Returns [`SchemeError`] if S = 0.
    pub fn new() -> Result<Self, SchemeError> {
        let scheme = RungeKutta::gauss(S)?;
        Ok(Self {
            coefficients: coefficients(scheme.tableau()),
            scheme,
            registers: Registers::widest(),
        })
    }

    /// Replaces the instruction set and the width of the registers.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks the instructions.
    pub fn on(
        self,
        instructions: InstructionSet,
        width: Width,
    ) -> Result<Self, MissingInstructions> {
        Ok(Self { registers: Registers::new(instructions, width)?, ..self })
    }
}

/// A run in several calls that meet at multiples of [`CHECKPOINT`](collective_integrators::CHECKPOINT) is bit-identical
/// to a run in one call. If the calls meet elsewhere, the results differ by rounding.
impl<const S: usize> BatchIntegrator for GaussBatch<S> {
    type Member = (HeavyTop, Se3Dual);
    type Workspace = ();

    fn workspace(&self) {}

    fn advance(
        &self,
        members: &mut [(HeavyTop, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        (): &mut (),
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let coefficients = self.coefficients.scaled(step);
        let kernel = ScaledGauss { scheme: &self.scheme, coefficients };
        self.registers.advance(&kernel, members, step, steps, failed);
    }
}

/// Returns a, b and a W, where W extends the polynomial through the derivatives of one step to the nodes of
/// the next.
///
/// Its entry W_jl is the product over m ≠ l of (1 + c_j − c_m)/(c_l − c_m).
pub(super) fn coefficients<const S: usize>(gauss: &Tableau) -> ExtendedTableau<S> {
    let c = gauss.nodes();
    let extension = |j: usize, l: usize| lagrange_polynomial(c, l, 1.0 + c[j]);
    let a = |i: usize, j: usize| gauss.row(i)[j];
    let extended = |i, l| (0..S).map(|j| a(i, j) * extension(j, l)).sum();
    ExtendedTableau {
        a: core::array::from_fn(|i| core::array::from_fn(|j| a(i, j))),
        b: core::array::from_fn(|i| gauss.weights()[i]),
        extended: core::array::from_fn(|i| core::array::from_fn(|l| extended(i, l))),
    }
}

/// A Gauss method with its coefficients times the step.
struct ScaledGauss<'a, const S: usize> {
    scheme: &'a RungeKutta,
    coefficients: ExtendedTableau<S>,
}

impl<const S: usize> LaneKernel for ScaledGauss<'_, S> {
    type Member = (HeavyTop, Se3Dual);

    #[cfg_attr(optimised, inline(always))]
    fn together<T: Lanes>(
        &self,
        group: &mut [(HeavyTop, Se3Dual)],
        step: f64,
        count: u64,
    ) -> LaneResults {
        let last = group.len() - 1;
        let top = FieldParameters::<T>::from_lanes(|i| &group[i.min(last)].0);
        let mut motion = SpinorLanes::<T, S>::lift(|i| &group[i.min(last)].1);
        for n in 0..count {
            motion.step(&top, &self.coefficients, step, n == 0);
        }
        let mut results = LaneResults::default();
        for (i, (_, state)) in group.iter_mut().enumerate() {
            if motion.alive.lane(i) {
                *state = motion.momentum(i);
                results[i] = state.is_finite();
            }
        }
        results
    }

    fn alone(
        &self,
        (top, state): &mut (HeavyTop, Se3Dual),
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let integrator = LiftFree::new(self.scheme.clone(), DualQuaternions, *top);
        let workspace = &mut Integrator::<f64>::workspace(&integrator);
        integrator.advance(state, step, steps, workspace).map(drop)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// The integral of a polynomial of degree 3 up to each node of the next step is exact.
    #[test]
    fn the_extension_integrates_polynomials() {
        let gauss = Tableau::gauss(4).unwrap();
        let found = coefficients::<4>(&gauss);
        for power in 0..4 {
            for i in 0..4 {
                let value = |time: f64| time.powi(power);
                let extended: f64 =
                    (0..4).map(|l| found.extended[i][l] * value(gauss.nodes()[l])).sum();
                let exact: f64 =
                    (0..4).map(|j| found.a[i][j] * value(1.0 + gauss.nodes()[j])).sum();
                // The weights of the extension are up to 30.
                assert!((extended - exact).abs() < 1e-13, "{power} {i}: {extended} {exact}");
            }
        }
        // Control: no polynomial of degree 3 is τ⁴.
        let quartic = |j: usize| gauss.nodes()[j].powi(4);
        let extended: f64 = (0..4).map(|l| found.extended[3][l] * quartic(l)).sum();
        let exact: f64 = (0..4).map(|j| found.a[3][j] * (1.0 + gauss.nodes()[j]).powi(4)).sum();
        assert!((extended - exact).abs() > 1e-3);
    }
}
