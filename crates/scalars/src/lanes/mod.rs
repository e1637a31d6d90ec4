//! SIMD lanes: several `f64` numbers in one register.
//!
//! [`Lanes`] is the trait of all such types. [`DefaultLanes`] needs no knowledge of the processor,
//! [`dispatch`] runs code on wider types, and [`FourLanes`] hold one vector of R³.

mod lane_scalar;
mod registers;
mod packed;
mod four;
#[cfg(target_arch = "x86_64")]
mod single;
mod dispatch;
mod dispatch_four;
mod dispatch_unfused;

pub use dispatch::{InstructionSet, LaneTask, MissingInstructions, Width, dispatch};
pub use dispatch_four::{FourLanesTask, dispatch_four};
pub use dispatch_unfused::{
    StorageOver, TaskOver, UnfusedStorage, UnfusedTask, UnfusedWorkspace, dispatch_unfused,
};
pub use four::FourLanes;
pub use lane_scalar::Lanes;

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
use registers::plain::Plain as Baseline;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use registers::sse2::Sse2 as Baseline;

/// Four SIMD lanes (four trajectories at once) in two registers, available on every processor without
/// detection.
///
/// The registers are those of SSE2 on x86-64. Elsewhere the compiler chooses registers for two pairs of `f64`.
///
/// Each operation is bit-identical in each lane to the operation on `f64`. The compiler treats all code over
/// [`Real`](crate::Real), including that of nalgebra and num-complex, for these lanes as it does for `f64`.
///
/// # Example
/// ```
/// use generic_scalars::{DefaultLanes, Lanes, Real};
/// let x = DefaultLanes::load(&[1.0, 4.0, 9.0, 16.0]);
/// assert_eq!(Real::sqrt(x).lane(2), 3.0);
/// let hidden = DefaultLanes::load(&[0.0, f64::NAN, 0.0, 0.0]);
/// assert!(!hidden.all_below(1.0) && hidden.max_abs().is_nan());
/// ```
pub type DefaultLanes = packed::Packed<registers::register::Two<Baseline>>;
