//! Four lanes of 256 bits, with fused multiply-add.
#![allow(unsafe_code)] // the intrinsics

use super::super::four::Permuted;
use super::super::packed::{Packed, cosine, sine};
use super::intrinsics::{compiled_for, intrinsics, mask_of_bits, register};
use super::register::Register;
use crate::numbers::mask::Mask;
use core::arch::x86_64::{
    __m256d, _CMP_LE_OQ, _mm256_add_pd, _mm256_and_pd, _mm256_andnot_pd, _mm256_blendv_pd,
    _mm256_broadcastsd_pd, _mm256_castpd256_pd128, _mm256_cmp_pd, _mm256_div_pd, _mm256_fmadd_pd,
    _mm256_fmsub_pd, _mm256_fnmadd_pd, _mm256_max_pd, _mm256_movemask_pd, _mm256_mul_pd,
    _mm256_or_pd, _mm256_permute_pd, _mm256_permute2f128_pd, _mm256_permute4x64_pd, _mm256_set1_pd,
    _mm256_sqrt_pd, _mm256_sub_pd, _mm256_xor_pd,
};

/// One register of AVX2 with FMA.
///
/// The `unsafe` blocks of this type are sound for this reason: other crates cannot name the type, and this
/// crate uses it only in [`dispatch`](super::dispatch()) and [`dispatch_four`](super::dispatch_four()),
/// after AVX2 and FMA have been detected. So the processor has the instructions wherever a function of this
/// type runs.
#[derive(Clone, Copy)]
pub struct Avx2(__m256d);

/// The mask of [`Avx2`]: all bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
pub struct Avx2Mask(__m256d);

register! {
    Avx2(__m256d), lanes [0, 1, 2, 3],
    splat = _mm256_set1_pd, exclusive_or = _mm256_xor_pd,
    {
        const FUSED: bool = true;
        type Mask = Avx2Mask;

        intrinsics! {
            add(a, b) = _mm256_add_pd;
            subtract(a, b) = _mm256_sub_pd;
            multiply(a, b) = _mm256_mul_pd;
            divide(a, b) = _mm256_div_pd;
            root(a) = _mm256_sqrt_pd;
            maximum(a, b) = _mm256_max_pd;
            multiply_add(a, b, c) = _mm256_fmadd_pd;
            multiply_subtract(a, b, c) = _mm256_fmsub_pd;
            negative_multiply_add(a, b, c) = _mm256_fnmadd_pd;
        }

        #[cfg_attr(optimised, inline(always))]
        fn magnitude(a: Self) -> Self {
            // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
            Self(unsafe { _mm256_andnot_pd(Self::splat(-0.0).0, a.0) })
        }

        compiled_for! {
            "avx2":
            sine = sine;
            cosine = cosine;
        }

        #[cfg_attr(optimised, inline(always))]
        fn at_most(a: Self, b: Self) -> Avx2Mask {
            // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
            Avx2Mask(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(a.0, b.0) })
        }

        #[cfg_attr(optimised, inline(always))]
        fn select(mask: Avx2Mask, yes: Self, no: Self) -> Self {
            // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
            Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
        }
    }
}

mask_of_bits! {
    Avx2Mask of Avx2,
    and = _mm256_and_pd, or = _mm256_or_pd, exclusive_or = _mm256_xor_pd, signs = _mm256_movemask_pd
}

impl Permuted for Avx2 {
    #[cfg_attr(optimised, inline(always))]
    fn next(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_permute4x64_pd::<0b11_00_10_01>(a.0) })
    }

    #[cfg_attr(optimised, inline(always))]
    fn previous(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_permute4x64_pd::<0b11_01_00_10>(a.0) })
    }

    #[cfg_attr(optimised, inline(always))]
    fn first(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_broadcastsd_pd(_mm256_castpd256_pd128(a.0)) })
    }

    #[cfg_attr(optimised, inline(always))]
    fn neighbours(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_permute_pd::<0b0101>(a.0) })
    }

    #[cfg_attr(optimised, inline(always))]
    fn halves(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_permute2f128_pd::<1>(a.0, a.0) })
    }
}
