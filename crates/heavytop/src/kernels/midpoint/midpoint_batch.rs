//! The collective midpoint rule for many tops at once.

use crate::kernels::midpoint::formulas::{Member, together};
use crate::kernels::midpoint::top_midpoint::TopMidpoint;
use crate::tops::top::HeavyTop;
use collective_integrators::{
    BatchIntegrator, IntegrationError, Integrator, LaneKernel, LaneResults, Registers,
};
use core::ops::Range;
use lie_poisson::{InstructionSet, Lanes, MissingInstructions, Se3Dual, Width};

/// Advances many states of one top at once, in the SIMD lanes of the processor's registers, two registers at
/// a time.
///
/// Each state is bit-identical to its own [`trajectory`](collective_integrators::Start::trajectory) on the same
/// instructions. AVX2 and AVX-512 give bit-identical results. [`InstructionSet::Portable`] does not fuse products with
/// sums, and its results differ by rounding.
///
/// # Example
/// The tops have different angular momenta, and one of them fails:
/// ```
/// use collective_integrators::Ensemble;
/// use heavytop::{HeavyTop, TopMidpoint};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let start = |i: usize| Se3Dual::new(Vector3::new(1.0, 0.1 * i as f64, 2.0), Vector3::z());
/// let mut tops: Vec<_> = (0..20).map(start).collect();
/// tops[7].0.0.x = f64::NAN;
/// let midpoint = Ensemble::new(TopMidpoint::new(HeavyTop::kovalevskaya(1.0, 1.0)?));
/// let failures = midpoint.advance(&mut tops, 0.01, 0..1000);
/// assert!(failures.len() == 1 && failures[0].index == 7 && failures[0].source.step == 1);
/// for (i, mu) in tops.iter().enumerate().filter(|&(i, _)| i != 7) {
///     assert!((mu.0.0.dot(&mu.0.1) - start(i).0.0.z).abs() < 1e-13, "{i}");
/// }
/// # Ok::<(), heavytop::TopError>(())
/// ```
impl BatchIntegrator for TopMidpoint {
    type Member = Se3Dual;

    type Workspace = ();

    fn workspace(&self) {}

    fn advance(
        &self,
        states: &mut [Se3Dual],
        step: f64,
        steps: Range<u64>,
        (): &mut (),
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        self.registers().advance(self, states, step, steps, failed);
    }
}

impl LaneKernel for TopMidpoint {
    type Member = Se3Dual;

    #[cfg_attr(optimised, inline(always))]
    fn together<T: Lanes>(&self, group: &mut [Se3Dual], step: f64, count: u64) -> LaneResults {
        let top = *self.top();
        together::<T, _>(|_| top, group, step, count)
    }

    fn alone(
        &self,
        state: &mut Se3Dual,
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let space = &mut Integrator::workspace(self);
        Integrator::advance(self, state, step, steps, space).map(drop)
    }
}

/// The collective midpoint rule for many tops with separate parameters: the members are pairs (top, μ).
///
/// The steps are those of [`TopMidpoint`], whose documentation has the formula.
///
/// Source: the collective midpoint rule of Ohsawa 2019, §5.2.
///
/// # Example
/// Lagrange tops with different moments conserve Π₃:
/// ```
/// use collective_integrators::Ensemble;
/// use heavytop::{HeavyTop, MidpointBatch};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let start = Se3Dual::new(Vector3::new(0.3, 0.0, 2.0), Vector3::z());
/// let tops = (1..10).map(|i| HeavyTop::lagrange(1.0, 0.1 * f64::from(i), 1.0));
/// let mut members: Vec<_> = tops.map(|top| Ok((top?, start))).collect::<Result<_, heavytop::TopError>>()?;
/// let ensemble = Ensemble::new(MidpointBatch::new());
/// assert!(ensemble.advance(&mut members, 0.01, 0..1000).is_empty());
/// assert!(members.iter().all(|(_, mu)| (mu.0.0.z - 2.0).abs() < 1e-12));
/// assert!((members[0].1.0.0.x - members[1].1.0.0.x).abs() > 1e-3);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MidpointBatch {
    registers: Registers,
}

impl Default for MidpointBatch {
    fn default() -> Self {
        Self::new()
    }
}

impl MidpointBatch {
    /// Creates the method on the widest registers that the processor has.
    #[must_use]
    pub fn new() -> Self {
        Self { registers: Registers::widest() }
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
        Ok(Self { registers: Registers::new(instructions, width)? })
    }
}

/// A member without a result in its lane is advanced alone, with a workspace that is created for it.
impl BatchIntegrator for MidpointBatch {
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
        self.registers.advance(self, members, step, steps, failed);
    }
}

impl LaneKernel for MidpointBatch {
    type Member = (HeavyTop, Se3Dual);

    #[cfg_attr(optimised, inline(always))]
    fn together<T: Lanes>(
        &self,
        group: &mut [(HeavyTop, Se3Dual)],
        step: f64,
        count: u64,
    ) -> LaneResults {
        together::<T, _>(|member: &(HeavyTop, Se3Dual)| member.0, group, step, count)
    }

    fn alone(
        &self,
        (top, state): &mut (HeavyTop, Se3Dual),
        step: f64,
        steps: Range<u64>,
    ) -> Result<(), IntegrationError> {
        let midpoint = TopMidpoint::on(*top, self.registers);
        let space = &mut Integrator::workspace(&midpoint);
        Integrator::advance(&midpoint, state, step, steps, space).map(drop)
    }
}

impl Member for Se3Dual {
    fn state(&self) -> &Se3Dual {
        self
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        self
    }
}

impl Member for (HeavyTop, Se3Dual) {
    fn state(&self) -> &Se3Dual {
        &self.1
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        &mut self.1
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use lie_poisson::{Covector, Vector};
    use nalgebra::Vector3;

    /// The ensemble would advance members without a result alone, to the same end in more time.
    #[test]
    fn lanes_have_results() {
        let top = HeavyTop::kovalevskaya(1.0, 1.0).unwrap();
        let start = Se3Dual::new(Vector3::new(2.0, 3.0, 4.0), Vector3::new(0.6, 0.0, 0.8));
        let one = TopMidpoint::new(top);
        let mut states = [start; 1];
        assert!(LaneKernel::together::<f64>(&one, &mut states, 0.02, 7)[0]);
        let mut members = [(top, start); 1];
        assert!(MidpointBatch::new().together::<f64>(&mut members, 0.02, 7)[0]);
        let mut end = start;
        Integrator::advance(&one, &mut end, 0.02, 0..7, &mut Integrator::workspace(&one)).unwrap();
        for Covector(moved) in [states[0] - end, members[0].1 - end] {
            // Without fused operations the last bits differ.
            assert!(moved.max_abs() < 1e-13);
        }
        assert!((end - start).0.max_abs() > 0.1);
        // Control: no step from a state that is no number has a result.
        let mut states = [Se3Dual::new(Vector3::repeat(f64::NAN), Vector3::z()); 1];
        assert!(!LaneKernel::together::<f64>(&one, &mut states, 0.02, 7)[0]);
    }
}
