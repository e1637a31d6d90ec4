//! Many tops at once, by collective Gauss methods.

use crate::HeavyTop;
use crate::ensemble_path::advance_one;
use crate::spinor_kernel::{Coefficients, Motion, Parameters};
use collective_integrators::{IntegrationError, LiftFree, RungeKutta, SchemeError, Tableau};
use lie_poisson::{
    InstructionSet, LaneTask, Lanes, Mask, MissingInstructions, Se3Dual, Vector, Width, dispatch,
};
use momentum_map::DualQuaternions;

/// Many tops, advanced side by side in the lanes of the processor's registers by the collective
/// Gauss method with S stages, of order 2S.
///
/// One step is that of [`LiftFree`] with [`RungeKutta::gauss`], to round-off. Stage equations are
/// solved by sweeps, each stage from the newest derivatives of the others, beginning with the
/// polynomial through the stages of the step before; a top stops where its own stages have settled.
/// A top whose stages do not settle, whose Γ is 0, or that is not finite goes through that
/// integrator instead, and fails where it fails.
///
/// What becomes of a top does not depend on the others, nor on the number of lanes: it has the same
/// bits at every [`Width`], and on all instruction sets that fuse products with sums; those of
/// [`InstructionSet::Portable`], which does not, differ by rounding. The first step of each call has
/// no step before it, so that n steps in one call and n calls differ by rounding.
///
/// # Example
/// ```
/// use heavytop::{Body, GaussEnsemble, HeavyTop, Invariant};
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
/// let mut tops: Vec<Se3Dual> = (0..100).map(start).collect();
/// let ensemble = GaussEnsemble::<8>::new(&[top])?;
/// ensemble.advance(&mut tops, 0.25, 40, &mut |index, error| panic!("{index}: {error}"));
/// for (i, mu) in (0..).zip(&tops) {
///     let change = Invariant::Energy.value(&top, mu) - Invariant::Energy.value(&top, &start(i));
///     assert!(change.abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GaussEnsemble<const S: usize> {
    tops: Vec<HeavyTop>,
    scheme: RungeKutta,
    coefficients: Coefficients<S>,
    instructions: InstructionSet,
    width: Width,
}

impl<const S: usize> GaussEnsemble<S> {
    /// The tops, repeated as often as there are states: one for all of them, or one for each.
    /// Without any, nothing is advanced.
    ///
    /// # Errors
    /// If S = 0.
    pub fn new(tops: &[HeavyTop]) -> Result<Self, SchemeError> {
        let scheme = RungeKutta::gauss(S)?;
        Ok(Self {
            tops: tops.to_vec(),
            coefficients: coefficients(scheme.tableau()),
            scheme,
            instructions: InstructionSet::detected(),
            width: Width::TwoRegisters,
        })
    }

    /// The same on the given instructions and width; without this call, on the widest there are.
    ///
    /// # Errors
    /// If the processor lacks the instructions.
    pub fn on(
        self,
        instructions: InstructionSet,
        width: Width,
    ) -> Result<Self, MissingInstructions> {
        if instructions.is_available() {
            Ok(Self { instructions, width, ..self })
        } else {
            Err(MissingInstructions { set: instructions })
        }
    }

    /// Every state by `steps` steps of length `step`. `failure` is told the index of each state that
    /// has no result; the state is left where its last good step ended.
    pub fn advance(
        &self,
        states: &mut [Se3Dual],
        step: f64,
        steps: u64,
        failure: &mut impl FnMut(usize, IntegrationError),
    ) {
        if self.tops.is_empty() || steps == 0 {
            return;
        }
        let mut one = |index: usize, state: &mut Se3Dual| {
            let top = self.tops[index % self.tops.len()];
            let integrator = LiftFree::new(self.scheme.clone(), DualQuaternions, top);
            if let Err(error) = advance_one(&integrator, state, step, steps) {
                failure(index, error);
            }
        };
        let (tops, coefficients) = (&self.tops, &self.coefficients.scaled(step));
        let task = Advance { tops, coefficients, states, step, steps, one: &mut one };
        if let Err(MissingInstructions { .. }) = dispatch(task, self.instructions, self.width) {
            // `on` has asked the processor; it has not changed.
        }
    }
}

/// a, b, and a W with W_jl = Π_{m≠l} (1 + c_j − c_m)/(c_l − c_m), which extends the polynomial
/// through the derivatives of one step to the nodes of the next.
fn coefficients<const S: usize>(gauss: &Tableau) -> Coefficients<S> {
    let c = gauss.nodes();
    let extension = |j: usize, l: usize| -> f64 {
        (0..S).filter(|&m| m != l).map(|m| (1.0 + c[j] - c[m]) / (c[l] - c[m])).product()
    };
    let a = |i: usize, j: usize| gauss.row(i)[j];
    let extended = |i, l| (0..S).map(|j| a(i, j) * extension(j, l)).sum();
    Coefficients {
        a: core::array::from_fn(|i| core::array::from_fn(|j| a(i, j))),
        b: core::array::from_fn(|i| gauss.weights()[i]),
        extended: core::array::from_fn(|i| core::array::from_fn(|l| extended(i, l))),
    }
}

/// All states on lanes; `one` advances what the lanes cannot.
struct Advance<'a, F, const S: usize> {
    tops: &'a [HeavyTop],
    coefficients: &'a Coefficients<S>,
    states: &'a mut [Se3Dual],
    step: f64,
    steps: u64,
    one: &'a mut F,
}

impl<F: FnMut(usize, &mut Se3Dual), const S: usize> LaneTask for Advance<'_, F, S> {
    type Output = ();

    #[inline(always)]
    fn run<T: Lanes>(self) {
        let Self { tops, coefficients, states, step, steps, one } = self;
        for (n, group) in states.chunks_mut(T::COUNT).enumerate() {
            let first = n * T::COUNT;
            let last = group.len() - 1;
            let top = Parameters::<T>::from_lanes(|i| &tops[(first + i.min(last)) % tops.len()]);
            let mut motion = Motion::<T, S>::lift(|i| &group[i.min(last)]);
            for n in 0..steps {
                motion.step(&top, coefficients, step, n == 0);
            }
            for (i, state) in group.iter_mut().enumerate() {
                let end = motion.momentum(i);
                if motion.alive.lane(i) && end.is_finite() {
                    *state = end;
                } else {
                    one(first + i, state);
                }
            }
        }
    }
}
