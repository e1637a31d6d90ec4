//! Two lanes in a register of 128 bits, which every x86-64 processor has.
#![allow(unsafe_code)] // the intrinsics

use super::super::packed::{Packed, cosine, sine};
use super::intrinsics::{compiled_for, intrinsics, mask_of_bits, register};
use super::register::Register;
use crate::numbers::mask::Mask;
use core::arch::x86_64::{
    __m128d, _mm_add_pd, _mm_and_pd, _mm_andnot_pd, _mm_cmple_pd, _mm_div_pd, _mm_max_pd,
    _mm_movemask_pd, _mm_mul_pd, _mm_or_pd, _mm_set1_pd, _mm_sqrt_pd, _mm_sub_pd, _mm_xor_pd,
};

/// One register of SSE2; products and sums are rounded separately, as for `f64`.
///
/// The `unsafe` blocks of this type are sound because it is compiled only where SSE2 is among the features of every
/// function.
#[derive(Clone, Copy)]
pub struct Sse2(__m128d);

/// The mask of [`Sse2`]: all bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
pub struct Sse2Mask(__m128d);

register! {
    Sse2(__m128d), lanes [0, 1],
    splat = _mm_set1_pd, exclusive_or = _mm_xor_pd,
    {
        const FUSED: bool = false;
        type Mask = Sse2Mask;

        intrinsics! {
            add(a, b) = _mm_add_pd;
            subtract(a, b) = _mm_sub_pd;
            multiply(a, b) = _mm_mul_pd;
            divide(a, b) = _mm_div_pd;
            root(a) = _mm_sqrt_pd;
            maximum(a, b) = _mm_max_pd;
        }

        #[cfg_attr(optimised, inline(always))]
        fn magnitude(a: Self) -> Self {
            // SAFETY: every processor of this target has SSE2, see `Sse2`.
            Self(unsafe { _mm_andnot_pd(Self::splat(-0.0).0, a.0) })
        }

        compiled_for! {
            "sse2":
            sine = sine;
            cosine = cosine;
        }

        #[cfg_attr(optimised, inline(always))]
        fn at_most(a: Self, b: Self) -> Sse2Mask {
            // SAFETY: every processor of this target has SSE2, see `Sse2`.
            Sse2Mask(unsafe { _mm_cmple_pd(a.0, b.0) })
        }

        #[cfg_attr(optimised, inline(always))]
        fn select(mask: Sse2Mask, yes: Self, no: Self) -> Self {
            // SAFETY: every processor of this target has SSE2, see `Sse2`.
            Self(unsafe { _mm_or_pd(_mm_and_pd(mask.0, yes.0), _mm_andnot_pd(mask.0, no.0)) })
        }
    }
}

mask_of_bits! {
    Sse2Mask of Sse2,
    and = _mm_and_pd, or = _mm_or_pd, exclusive_or = _mm_xor_pd, signs = _mm_movemask_pd
}
