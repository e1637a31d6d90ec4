//! From a set of instructions to four lanes: [`dispatch_four`].

use super::packed::Packed;
use super::registers::register::Two;
use super::{Baseline, FourLanes, InstructionSet, MissingInstructions};

#[cfg(target_arch = "x86_64")]
use super::registers::avx2::Avx2;

/// A computation on [`FourLanes`], to be run by [`dispatch_four`]. What [`LaneTask`](super::LaneTask) says of speed
/// holds here.
pub trait FourLanesTask {
    /// What comes out.
    type Output;

    /// The computation. Mark it `#[inline(always)]`.
    fn run<T: FourLanes>(self) -> Self::Output;
}

/// Runs the task on four lanes by the given instructions: [`DefaultLanes`](super::DefaultLanes) by
/// `Portable`, one register, fused, by the others. A lane has the bits of
/// [`Width::Single`](super::Width::Single).
///
/// # Soundness
/// That of [`dispatch`](super::dispatch()): the register has no name outside of this crate, and is
/// handed out where the processor is known to have its instructions.
///
/// # Errors
/// If the processor lacks the instructions.
#[allow(unsafe_code)] // calls into functions compiled for more than the baseline
#[inline]
pub fn dispatch_four<K: FourLanesTask>(
    task: K,
    set: InstructionSet,
) -> Result<K::Output, MissingInstructions> {
    if !set.is_available() {
        return Err(MissingInstructions { set });
    }
    match set {
        InstructionSet::Portable => Ok(task.run::<Packed<Two<Baseline>>>()),
        // SAFETY: the processor has AVX2 and FMA, as was checked above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx2 => Ok(unsafe { four_with_avx2(task) }),
        // SAFETY: the processor has AVX-512 F, DQ and VL, AVX2 and FMA, as was checked above.
        #[cfg(target_arch = "x86_64")]
        InstructionSet::Avx512 => Ok(unsafe { four_with_avx512(task) }),
        #[cfg(not(target_arch = "x86_64"))]
        set => Err(MissingInstructions { set }),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn four_with_avx2<K: FourLanesTask>(task: K) -> K::Output {
    task.run::<Packed<Avx2>>()
}

/// The same type with more registers to keep it in.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn four_with_avx512<K: FourLanesTask>(task: K) -> K::Output {
    task.run::<Packed<Avx2>>()
}
