//! Two lanes of 128 bits, which every x86-64 processor has.
#![allow(unsafe_code)] // the intrinsics

use super::register::{Register, intrinsics};
use crate::Mask;
use core::arch::x86_64::{
    __m128d, _mm_add_pd, _mm_and_pd, _mm_andnot_pd, _mm_cmple_pd, _mm_div_pd, _mm_max_pd,
    _mm_movemask_pd, _mm_mul_pd, _mm_or_pd, _mm_set1_pd, _mm_sqrt_pd, _mm_sub_pd, _mm_xor_pd,
};
use core::mem::transmute;

/// One register of SSE2. Products and sums are rounded each on its own, as those of `f64`.
///
/// What makes the `unsafe` blocks of this file sound: it is compiled only where SSE2 is among the
/// features of every function.
#[derive(Clone, Copy)]
pub struct Sse2(__m128d);

/// All bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
pub struct Sse2Mask(__m128d);

impl Register for Sse2 {
    const COUNT: usize = 2;
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

    #[inline(always)]
    fn splat(x: f64) -> Self {
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Self(unsafe { _mm_set1_pd(x) })
    }

    #[inline(always)]
    fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
        from_array([f(0), f(1)])
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
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Self(unsafe { _mm_xor_pd(a.0, Self::splat(-0.0).0) })
    }

    #[inline(always)]
    fn magnitude(a: Self) -> Self {
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Self(unsafe { _mm_andnot_pd(Self::splat(-0.0).0, a.0) })
    }

    #[inline(always)]
    fn multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::add(Self::multiply(a, b), c)
    }

    #[inline(always)]
    fn multiply_subtract(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(Self::multiply(a, b), c)
    }

    #[inline(always)]
    fn negative_multiply_add(a: Self, b: Self, c: Self) -> Self {
        Self::subtract(c, Self::multiply(a, b))
    }

    #[inline(always)]
    fn at_most(a: Self, b: Self) -> Sse2Mask {
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Sse2Mask(unsafe { _mm_cmple_pd(a.0, b.0) })
    }

    #[inline(always)]
    fn select(mask: Sse2Mask, yes: Self, no: Self) -> Self {
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Self(unsafe { _mm_or_pd(_mm_and_pd(mask.0, yes.0), _mm_andnot_pd(mask.0, no.0)) })
    }
}

#[inline(always)]
fn from_array(lanes: [f64; 2]) -> Sse2 {
    // SAFETY: both types are two numbers of 64 bits, in the same order.
    Sse2(unsafe { transmute::<[f64; 2], __m128d>(lanes) })
}

#[inline(always)]
fn to_array(a: Sse2) -> [f64; 2] {
    // SAFETY: both types are two numbers of 64 bits, in the same order.
    unsafe { transmute::<__m128d, [f64; 2]>(a.0) }
}

/// One bit for each lane.
#[inline(always)]
fn bits(mask: Sse2Mask) -> i32 {
    // SAFETY: every processor of this target has SSE2, see `Sse2`.
    unsafe { _mm_movemask_pd(mask.0) }
}

impl Mask for Sse2Mask {
    const COUNT: usize = 2;

    intrinsics! {
        and(self, other) = _mm_and_pd;
        or(self, other) = _mm_or_pd;
    }

    #[inline(always)]
    fn from_bool(truth: bool) -> Self {
        Self(Sse2::splat(f64::from_bits(if truth { u64::MAX } else { 0 })).0)
    }

    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: every processor of this target has SSE2, see `Sse2`.
        Self(unsafe { _mm_xor_pd(self.0, Self::from_bool(true).0) })
    }

    #[inline(always)]
    fn all(self) -> bool {
        bits(self) == 0b11
    }

    #[inline(always)]
    fn lane(self, i: usize) -> bool {
        i < Self::COUNT && bits(self) >> i & 1 == 1
    }
}
