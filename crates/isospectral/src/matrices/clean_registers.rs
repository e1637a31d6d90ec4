//! The registers after products of matrices: [`clean_registers`].

use core::hint::black_box;
use lie_poisson::InstructionSet;
use lie_poisson::generic_scalars::{LaneTask, Lanes, Width, dispatch};

/// Empties the upper halves of the wide registers.
///
/// The kernels that multiply matrices leave numbers there. On many x86 processors every narrow operation after that waits
/// for the upper half of its register, so that all code of the thread is up to twenty times as slow, until some function
/// that was compiled for wide registers returns: the compiler has it empty them.
pub(super) fn clean_registers() {
    // Without wide instructions there is nothing to empty.
    let _ = dispatch(Touch, InstructionSet::detected(), Width::Register);
}

/// An operation on wide registers.
struct Touch;

impl LaneTask for Touch {
    type Output = f64;

    #[inline(always)]
    fn run<T: Lanes>(self) -> f64 {
        let x = T::load(black_box(&[1.0; 8]));
        let mut sum = [0.0; 8];
        (x + x).store(&mut sum);
        black_box(sum)[0]
    }
}
