//! Runs a computation on four lanes with detected vector instructions: [`dispatch_four`].

use super::packed::Packed;
use super::registers::register::Two;
use super::{Baseline, FourLanes, InstructionSet, MissingInstructions};

#[cfg(target_arch = "x86_64")]
use super::registers::avx2::Avx2;

/// A computation on [`FourLanes`], to be run by [`dispatch_four`].
///
/// The rules for speed of [`LaneTask`](super::LaneTask) also apply here.
pub trait FourLanesTask {
    /// The result of the computation.
    type Output;

    /// Runs the computation on four lanes of type `T`. Mark it with `#[inline(always)]`.
    fn run<T: FourLanes>(self) -> Self::Output;
}

/// Runs a task on four SIMD lanes (four numbers in one register) with the given instructions.
///
/// The lanes are [`DefaultLanes`](super::DefaultLanes) for `Portable`, and one register with fused multiply-add for the
/// other sets. Each lane returns the same bits as [`Width::Single`](super::Width::Single).
///
/// # Soundness
/// As for [`dispatch`](super::dispatch()): code outside of this crate cannot name the type of the register,
/// which is used only after its instructions have been detected.
///
/// # Errors
/// Returns [`MissingInstructions`] if the processor lacks the instructions.
#[allow(unsafe_code)] // calls into functions compiled for more than the baseline
#[inline]
pub fn dispatch_four<K: FourLanesTask>(
    task: K,
    set: InstructionSet,
) -> Result<K::Output, MissingInstructions> {
    match set.if_available()? {
        InstructionSet::Portable => Ok(four_portable(task)),
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

fn four_portable<K: FourLanesTask>(task: K) -> K::Output {
    task.run::<Packed<Two<Baseline>>>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn four_with_avx2<K: FourLanesTask>(task: K) -> K::Output {
    task.run::<Packed<Avx2>>()
}

/// Runs a task on four lanes of AVX2, compiled for AVX-512, which has more registers.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn four_with_avx512<K: FourLanesTask>(task: K) -> K::Output {
    task.run::<Packed<Avx2>>()
}
