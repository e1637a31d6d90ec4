//! The collective midpoint rule for many tops at once.

use crate::midpoint_kernel::{ManyTops, Member, Top};
use crate::reduced_midpoint::{NewtonSpace, top_of};
use crate::{HeavyTopSpace, ReducedMidpoint};
use collective_integrators::{IntegrationError, Integrator};
use core::ops::Range;
use lie_poisson::{Hamiltonian, InstructionSet, MissingInstructions, Se3Dual, Width, dispatch};

impl<H: Hamiltonian<HeavyTopSpace>> ReducedMidpoint<H> {
    /// Advances many states, from where `steps.start` steps have led them to where `steps.end`
    /// will, with steps of size `step`; tops of this system in the lanes of the processor's
    /// registers, two registers at a time.
    ///
    /// What becomes of a state depends on itself alone. For tops it has the bits of its own
    /// [`trajectory`](collective_integrators::Start::trajectory) on the same instructions, of
    /// AVX2 and of AVX-512 alike; on [`InstructionSet::Portable`] it has others, since nothing is
    /// fused there.
    ///
    /// `failed` is called with the index of each state that cannot go on, and why: that state is
    /// the one before the step that failed. Steps of a top that do not settle in its lane, for
    /// large steps, are made by the iterations for any system from then on.
    ///
    /// # Example
    /// Tops with different angular momenta:
    /// ```
    /// use heavytop::{HeavyTop, ReducedMidpoint};
    /// use lie_poisson::Se3Dual;
    /// use nalgebra::Vector3;
    /// let start = |i: usize| Se3Dual::new(Vector3::new(1.0, 0.1 * i as f64, 2.0), Vector3::z());
    /// let mut tops: Vec<_> = (0..20).map(start).collect();
    /// tops[7].0.0.x = f64::NAN;
    /// let midpoint = ReducedMidpoint::new(HeavyTop::kovalevskaya(1.0, 1.0)?);
    /// let mut failed = Vec::new();
    /// midpoint.advance(&mut tops, 0.01, 0..1000, &mut |i, error| failed.push((i, error.step)));
    /// assert_eq!(failed, [(7, 1)]);
    /// for (i, mu) in tops.iter().enumerate().filter(|&(i, _)| i != 7) {
    ///     assert!((mu.0.0.dot(&mu.0.1) - start(i).0.0.z).abs() < 1e-13, "{i}");
    /// }
    /// # Ok::<(), heavytop::TopError>(())
    /// ```
    pub fn advance(
        &self,
        states: &mut [Se3Dual],
        step: f64,
        steps: Range<u64>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let top = self.top::<f64>().unwrap_or(Top::NONE);
        let mut newton = Integrator::<f64>::workspace(self).newton;
        let until = steps.end;
        let left = &mut |i: usize, made: u64, state: &mut Se3Dual| {
            if let Err(failure) = self.go_on(state, step, made..until, &mut newton) {
                failed(i, failure);
            }
        };
        let task = ManyTops { top: |_: &_| top, members: states, step, steps, left };
        run(task, self.instructions());
    }

    /// Steps as of any system.
    fn go_on(
        &self,
        state: &mut Se3Dual,
        step: f64,
        steps: Range<u64>,
        newton: &mut NewtonSpace<H, f64>,
    ) -> Result<(), IntegrationError> {
        for made in steps {
            let next = self.step_of_any(state, step, newton);
            let failure =
                |source| IntegrationError { step: made + 1, time: made as f64 * step, source };
            *state = next.map_err(failure)?.0.point;
        }
        Ok(())
    }
}

/// [`ReducedMidpoint`] for many tops, each with its own parameters and start: (h, μ).
///
/// As [`ReducedMidpoint::advance`] in everything else.
///
/// # Example
/// Lagrange tops of different moments, with Π₃ conserved:
/// ```
/// use heavytop::{HeavyTop, MidpointSweep};
/// use lie_poisson::Se3Dual;
/// use nalgebra::Vector3;
/// let start = Se3Dual::new(Vector3::new(0.3, 0.0, 2.0), Vector3::z());
/// let tops = (1..10).map(|i| HeavyTop::lagrange(1.0, 0.1 * f64::from(i), 1.0));
/// let mut members: Vec<_> = tops.map(|top| Ok((top?, start))).collect::<Result<_, heavytop::TopError>>()?;
/// MidpointSweep::new().advance(&mut members, 0.01, 0..1000, &mut |i, error| panic!("{i}: {error}"));
/// assert!(members.iter().all(|(_, mu)| (mu.0.0.z - 2.0).abs() < 1e-12));
/// assert!((members[0].1.0.0.x - members[1].1.0.0.x).abs() > 1e-3);
/// # Ok::<(), heavytop::TopError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MidpointSweep {
    instructions: InstructionSet,
}

impl Default for MidpointSweep {
    fn default() -> Self {
        Self::new()
    }
}

impl MidpointSweep {
    /// On the widest instructions that the processor has.
    #[must_use]
    pub fn new() -> Self {
        Self { instructions: InstructionSet::detected() }
    }

    /// On other instructions.
    ///
    /// # Errors
    /// If the processor lacks them.
    pub fn with_instructions(set: InstructionSet) -> Result<Self, MissingInstructions> {
        if set.is_available() {
            Ok(Self { instructions: set })
        } else {
            Err(MissingInstructions { set })
        }
    }

    /// As [`ReducedMidpoint::advance`], for members (h, μ).
    pub fn advance<H: Hamiltonian<HeavyTopSpace> + Copy>(
        &self,
        members: &mut [(H, Se3Dual)],
        step: f64,
        steps: Range<u64>,
        failed: &mut dyn FnMut(usize, IntegrationError),
    ) {
        let until = steps.end;
        let left = &mut |i: usize, made: u64, (top, state): &mut (H, Se3Dual)| {
            let midpoint = ReducedMidpoint::new(*top);
            let mut newton = Integrator::<f64>::workspace(&midpoint).newton;
            if let Err(failure) = midpoint.go_on(state, step, made..until, &mut newton) {
                failed(i, failure);
            }
        };
        let top = |member: &(H, Se3Dual)| top_of::<H, f64>(&member.0).unwrap_or(Top::NONE);
        run(ManyTops { top, members, step, steps, left }, self.instructions);
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

impl<H> Member for (H, Se3Dual) {
    fn state(&self) -> &Se3Dual {
        &self.1
    }
    fn state_mut(&mut self) -> &mut Se3Dual {
        &mut self.1
    }
}

/// Runs the steps, on instructions that the processor has, as whoever chose them has made sure.
fn run<M: Member, F: Fn(&M) -> Top>(task: ManyTops<'_, M, F>, set: InstructionSet) {
    match dispatch(task, set, Width::TwoRegisters) {
        Ok(()) | Err(MissingInstructions { .. }) => {}
    }
}
