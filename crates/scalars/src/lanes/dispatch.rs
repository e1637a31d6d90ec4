//! Runs a computation with the vector instructions that are detected at run time: [`dispatch`].

use super::packed::Packed;
use super::registers::register::Two;
use super::{Baseline, Lanes};
use core::fmt;
use thiserror::Error;

#[cfg(target_arch = "x86_64")]
use super::registers::{avx2::Avx2, avx512::Avx512};
#[cfg(target_arch = "x86_64")]
use super::single::FusedSingle;

/// A set of vector instructions that a processor may or may not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum InstructionSet {
    /// The instructions that every processor of the architecture has, without fused multiply-add.
    Portable,
    /// AVX2 and FMA of x86-64: registers of 4 SIMD lanes, with fused multiply-add.
    Avx2,
    /// AVX-512 F, DQ and VL of x86-64: registers of 8 SIMD lanes, with fused multiply-add.
    Avx512,
}

impl InstructionSet {
    /// All instruction sets, the widest last.
    pub const ALL: [Self; 3] = [Self::Portable, Self::Avx2, Self::Avx512];

    /// Returns whether this processor and its operating system support the instructions.
    #[must_use]
    pub fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        {
            let avx2 = || is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            match self {
                Self::Portable => true,
                Self::Avx2 => avx2(),
                Self::Avx512 => {
                    avx2()
                        && is_x86_feature_detected!("avx512f")
                        && is_x86_feature_detected!("avx512dq")
                        && is_x86_feature_detected!("avx512vl")
                }
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            self == Self::Portable
        }
    }

    /// Returns the instruction set itself if this processor has it, for constructors that take one.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks the instructions.
    ///
    /// # Example
    /// ```
    /// use generic_scalars::{InstructionSet, MissingInstructions};
    /// for set in InstructionSet::ALL {
    ///     let expected = if set.is_available() { Ok(set) } else { Err(MissingInstructions { set }) };
    ///     assert_eq!(set.if_available(), expected);
    /// }
    /// assert!(InstructionSet::Portable.if_available().is_ok());
    /// ```
    #[inline]
    pub fn if_available(self) -> Result<Self, MissingInstructions> {
        if self.is_available() { Ok(self) } else { Err(MissingInstructions { set: self }) }
    }

    /// Returns the instruction sets that this processor has, the widest last.
    pub fn available() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|set| set.is_available())
    }

    /// Returns the widest instruction set that this processor has.
    #[must_use]
    pub fn detected() -> Self {
        Self::available().last().unwrap_or(Self::Portable)
    }
}

impl fmt::Display for InstructionSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Portable => "portable",
            Self::Avx2 => "AVX2 with FMA",
            Self::Avx512 => "AVX-512 (F, DQ, VL)",
        })
    }
}

/// The number of SIMD lanes of a value (several numbers in one register).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Width {
    /// One lane: `f64` for [`InstructionSet::Portable`], a number with fused multiply-add for the other
    /// sets.
    Single,
    /// One register: 2, 4 or 8 lanes.
    Register,
    /// Two registers, used alternately: 4, 8 or 16 lanes. In a long chain of operations, each of which waits for the
    /// previous one, a single register leaves the processor idle, and two keep it busy.
    TwoRegisters,
}

impl Width {
    /// All widths, the widest last.
    pub const ALL: [Self; 3] = [Self::Single, Self::Register, Self::TwoRegisters];
}

/// The error returned if the processor lacks the requested instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("this processor lacks the instructions: {set}")]
pub struct MissingInstructions {
    /// The requested instruction set.
    pub set: InstructionSet,
}

/// A computation on SIMD lanes (several numbers in one register) of any type and width, to be run by
/// [`dispatch`].
///
/// # Speed
/// Mark `run`, and every function below it that takes or returns `T`, with `#[inline(always)]`. Code that is not
/// inlined into the function compiled for the processor's features is correct, but up to 25 times slower. A function
/// that is only `#[inline]` is not inlined across that boundary if it passes registers above 128 bits. Closures,
/// iterators and the operators of nalgebra and num-complex are only `#[inline]`. So compute with components, in plain
/// loops, or with [`cross`](crate::cross) and [`dot`](crate::dot). A closure that is passed as an argument can have the
/// mark. [`DefaultLanes`](super::DefaultLanes) has no such restriction.
pub trait LaneTask {
    /// The result of the computation.
    type Output;

    /// Runs the computation on lanes of type `T`. Mark it with `#[inline(always)]`.
    fn run<T: Lanes>(self) -> Self::Output;
}

/// Runs a task on SIMD lanes (several numbers in one register) of the given instructions and width.
///
/// | | `Single` | `Register` | `TwoRegisters` | fused |
/// |---|---|---|---|---|
/// | `Portable` | `f64` | 2 lanes | [`DefaultLanes`](super::DefaultLanes), 4 lanes | no |
/// | `Avx2` | 1 lane | 4 lanes | 8 lanes | yes |
/// | `Avx512` | 1 lane | 8 lanes | 16 lanes | yes |
///
/// # Soundness
/// Code outside of this crate cannot name the types of the last two rows, and no function, conversion or trait of a
/// type that it can name mentions them. Safe code can reach them in one way only: as the `T` of [`LaneTask::run`] or
/// [`FourLanesTask::run`](super::FourLanesTask::run). This function and [`dispatch_four`](super::dispatch_four())
/// call these methods only after the instructions have been detected, and a processor keeps its instructions in every
/// thread for as long as the program runs.
///
/// # Errors
/// Returns [`MissingInstructions`] if the processor lacks the instructions.
///
/// # Example
/// ```
/// use generic_scalars::{InstructionSet, LaneTask, Lanes, Width, dispatch};
///
/// /// Replaces each number x by x² + x.
/// struct SquareAndAdd<'a>(&'a mut [f64]);
///
/// impl LaneTask for SquareAndAdd<'_> {
///     type Output = ();
///
///     #[inline(always)]
///     fn run<T: Lanes>(self) {
///         for chunk in self.0.chunks_mut(T::COUNT) {
///             let x = T::load(chunk);
///             x.multiply_add(x, x).store(chunk);
///         }
///     }
/// }
///
/// for set in InstructionSet::available() {
///     let mut values: Vec<f64> = (0..19).map(f64::from).collect();
///     dispatch(SquareAndAdd(&mut values), set, Width::TwoRegisters)?;
///     assert_eq!(values[18], 342.0);
/// }
/// # Ok::<(), generic_scalars::MissingInstructions>(())
/// ```
#[allow(unsafe_code)] // calls into functions compiled for more than the baseline
#[inline]
pub fn dispatch<K: LaneTask>(
    task: K,
    set: InstructionSet,
    width: Width,
) -> Result<K::Output, MissingInstructions> {
    match (set.if_available()?, width) {
        (InstructionSet::Portable, Width::Single) => Ok(task.run::<f64>()),
        (InstructionSet::Portable, Width::Register) => Ok(task.run::<Packed<Baseline>>()),
        (InstructionSet::Portable, Width::TwoRegisters) => Ok(task.run::<Packed<Two<Baseline>>>()),
        // SAFETY: the processor has AVX2 and FMA, as was checked above.
        #[cfg(target_arch = "x86_64")]
        (InstructionSet::Avx2, width) => Ok(unsafe { with_avx2(task, width) }),
        // SAFETY: the processor has AVX-512 F, DQ and VL, AVX2 and FMA, as was checked above.
        #[cfg(target_arch = "x86_64")]
        (InstructionSet::Avx512, width) => Ok(unsafe { with_avx512(task, width) }),
        #[cfg(not(target_arch = "x86_64"))]
        (set, _) => Err(MissingInstructions { set }),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn with_avx2<K: LaneTask>(task: K, width: Width) -> K::Output {
    #[target_feature(enable = "avx2,fma")]
    fn run<K: LaneTask, T: Lanes>(task: K) -> K::Output {
        task.run::<T>()
    }
    match width {
        Width::Single => run::<K, Packed<FusedSingle>>(task),
        Width::Register => run::<K, Packed<Avx2>>(task),
        Width::TwoRegisters => run::<K, Packed<Two<Avx2>>>(task),
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn with_avx512<K: LaneTask>(task: K, width: Width) -> K::Output {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
    fn run<K: LaneTask, T: Lanes>(task: K) -> K::Output {
        task.run::<T>()
    }
    match width {
        Width::Single => run::<K, Packed<FusedSingle>>(task),
        Width::Register => run::<K, Packed<Avx512>>(task),
        Width::TwoRegisters => run::<K, Packed<Two<Avx512>>>(task),
    }
}
