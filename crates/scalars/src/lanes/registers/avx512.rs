//! Eight lanes of 512 bits, with fused multiply-add and masks in registers of their own.
#![allow(unsafe_code)] // the intrinsics

use super::super::packed::{Packed, cosine, sine};
use super::intrinsics::{compiled_for, intrinsics, register};
use super::register::Register;
use crate::numbers::mask::Mask;
use core::arch::x86_64::{
    __m512d, __mmask8, _CMP_LE_OQ, _mm512_abs_pd, _mm512_add_pd, _mm512_cmp_pd_mask, _mm512_div_pd,
    _mm512_fmadd_pd, _mm512_fmsub_pd, _mm512_fnmadd_pd, _mm512_mask_blend_pd, _mm512_max_pd,
    _mm512_mul_pd, _mm512_set1_pd, _mm512_sqrt_pd, _mm512_sub_pd, _mm512_xor_pd,
};

/// One register of AVX-512 (F and DQ).
///
/// The `unsafe` blocks of this type are sound for this reason: other crates cannot name the type, and this
/// crate uses it only in [`dispatch`](super::dispatch()), after AVX-512 has been detected. So the processor
/// has the instructions wherever a function of this type runs.
#[derive(Clone, Copy)]
pub struct Avx512(__m512d);

/// The mask of [`Avx512`], with one bit for each lane.
#[derive(Clone, Copy, Debug)]
pub struct Avx512Mask(__mmask8);

register! {
    Avx512(__m512d), lanes [0, 1, 2, 3, 4, 5, 6, 7],
    splat = _mm512_set1_pd, exclusive_or = _mm512_xor_pd,
    {
        const FUSED: bool = true;
        type Mask = Avx512Mask;

        intrinsics! {
            add(a, b) = _mm512_add_pd;
            subtract(a, b) = _mm512_sub_pd;
            multiply(a, b) = _mm512_mul_pd;
            divide(a, b) = _mm512_div_pd;
            root(a) = _mm512_sqrt_pd;
            maximum(a, b) = _mm512_max_pd;
            magnitude(a) = _mm512_abs_pd;
            multiply_add(a, b, c) = _mm512_fmadd_pd;
            multiply_subtract(a, b, c) = _mm512_fmsub_pd;
            negative_multiply_add(a, b, c) = _mm512_fnmadd_pd;
        }

        compiled_for! {
            "avx512f,avx512dq,avx512vl,avx2":
            sine = sine;
            cosine = cosine;
        }

        #[cfg_attr(optimised, inline(always))]
        fn at_most(a: Self, b: Self) -> Avx512Mask {
            // SAFETY: the processor has AVX-512 where the type is in use, see `Avx512`.
            Avx512Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a.0, b.0) })
        }

        #[cfg_attr(optimised, inline(always))]
        fn select(mask: Avx512Mask, yes: Self, no: Self) -> Self {
            // SAFETY: the processor has AVX-512 where the type is in use, see `Avx512`.
            Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
        }
    }
}

impl Mask for Avx512Mask {
    const COUNT: usize = 8;

    #[cfg_attr(optimised, inline(always))]
    fn from_bool(truth: bool) -> Self {
        Self(if truth { u8::MAX } else { 0 })
    }

    #[cfg_attr(optimised, inline(always))]
    fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn not(self) -> Self {
        Self(!self.0)
    }

    #[cfg_attr(optimised, inline(always))]
    fn all(self) -> bool {
        self.0 == u8::MAX
    }

    #[cfg_attr(optimised, inline(always))]
    fn lane(self, i: usize) -> bool {
        i < Self::COUNT && self.0 >> i & 1 == 1
    }
}
