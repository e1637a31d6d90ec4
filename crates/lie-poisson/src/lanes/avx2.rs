//! Four lanes of 256 bits, with fused multiply-add.
#![allow(unsafe_code)] // the intrinsics

use super::register::{Register, intrinsics};
use crate::Mask;
use core::arch::x86_64::{
    __m256d, _CMP_LE_OQ, _mm256_add_pd, _mm256_and_pd, _mm256_andnot_pd, _mm256_blendv_pd,
    _mm256_cmp_pd, _mm256_div_pd, _mm256_fmadd_pd, _mm256_fmsub_pd, _mm256_fnmadd_pd,
    _mm256_max_pd, _mm256_movemask_pd, _mm256_mul_pd, _mm256_or_pd, _mm256_set1_pd, _mm256_sqrt_pd,
    _mm256_sub_pd, _mm256_xor_pd,
};
use core::mem::transmute;

/// One register of AVX2 with FMA.
///
/// What makes the `unsafe` blocks of this file sound: other crates cannot name this type, and this
/// crate hands it out in [`dispatch`](super::dispatch()) alone, once the processor was found to
/// have AVX2 and FMA. Where a function of this file runs, the instructions are there.
#[derive(Clone, Copy)]
pub struct Avx2(__m256d);

/// All bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
pub struct Avx2Mask(__m256d);

impl Register for Avx2 {
    const COUNT: usize = 4;
    const FUSED: bool = true;
    type Mask = Avx2Mask;

    intrinsics! {
        add(a, b) = _mm256_add_pd;
        subtract(a, b) = _mm256_sub_pd;
        multiply(a, b) = _mm256_mul_pd;
        divide(a, b) = _mm256_div_pd;
        maximum(a, b) = _mm256_max_pd;
        root(a) = _mm256_sqrt_pd;
        multiply_add(a, b, c) = _mm256_fmadd_pd;
        multiply_subtract(a, b, c) = _mm256_fmsub_pd;
        negative_multiply_add(a, b, c) = _mm256_fnmadd_pd;
    }

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_set1_pd(x) })
    }

    #[inline(always)]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        from_array([f(0), f(1), f(2), f(3)])
    }

    #[inline(always)]
    fn load(values: &[f64]) -> Option<Self> {
        Some(from_array(*values.first_chunk()?))
    }

    #[inline(always)]
    fn store(a: Self, values: &mut [f64]) -> Option<()> {
        *values.first_chunk_mut()? = to_array(a);
        Some(())
    }

    #[inline(always)]
    fn lane(a: Self, i: usize) -> f64 {
        if i < Self::COUNT { to_array(a)[i] } else { f64::NAN }
    }

    #[inline(always)]
    fn negate(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_xor_pd(a.0, Self::splat(-0.0).0) })
    }

    #[inline(always)]
    fn magnitude(a: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_andnot_pd(Self::splat(-0.0).0, a.0) })
    }

    #[inline(always)]
    fn at_most(a: Self, b: Self) -> Avx2Mask {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Avx2Mask(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(a.0, b.0) })
    }

    #[inline(always)]
    fn select(mask: Avx2Mask, yes: Self, no: Self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }
}

#[inline(always)]
fn from_array(lanes: [f64; 4]) -> Avx2 {
    // SAFETY: both types are four numbers of 64 bits, in the same order.
    Avx2(unsafe { transmute::<[f64; 4], __m256d>(lanes) })
}

#[inline(always)]
fn to_array(a: Avx2) -> [f64; 4] {
    // SAFETY: both types are four numbers of 64 bits, in the same order.
    unsafe { transmute::<__m256d, [f64; 4]>(a.0) }
}

/// One bit for each lane.
#[inline(always)]
fn bits(mask: Avx2Mask) -> i32 {
    // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
    unsafe { _mm256_movemask_pd(mask.0) }
}

impl Mask for Avx2Mask {
    const COUNT: usize = 4;

    intrinsics! {
        and(self, other) = _mm256_and_pd;
        or(self, other) = _mm256_or_pd;
    }

    #[inline(always)]
    fn from_bool(truth: bool) -> Self {
        Self(Avx2::splat(f64::from_bits(if truth { u64::MAX } else { 0 })).0)
    }

    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: the processor has AVX2 where the type is in use, see `Avx2`.
        Self(unsafe { _mm256_xor_pd(self.0, Self::from_bool(true).0) })
    }

    #[inline(always)]
    fn all(self) -> bool {
        bits(self) == 0b1111
    }

    #[inline(always)]
    fn lane(self, i: usize) -> bool {
        i < Self::COUNT && bits(self) >> i & 1 == 1
    }
}
