//! Macros for what the registers of x86-64 have in common, with the intrinsics as parameters.
//!
//! An intrinsic is safe where the processor has its instruction. The documentation of each type that uses
//! these macros says why the processor has the instructions wherever code of the type runs.

/// Defines functions that consist of one instruction each.
macro_rules! intrinsics {
    ($($name:ident($($argument:ident),*) = $intrinsic:ident;)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name($($argument: Self),*) -> Self {
            // SAFETY: the processor has the instruction, see the type.
            Self(unsafe { $intrinsic($($argument.0),*) })
        }
    )*};
}
pub(super) use intrinsics;

/// Defines functions of a register in code that is compiled for its instructions, and not where they are called.
macro_rules! compiled_for {
    ($feature:literal: $($name:ident = $function:path;)*) => {$(
        #[cfg_attr(optimised, inline(always))]
        fn $name(a: Self) -> Self {
            #[target_feature(enable = $feature)]
            #[inline(never)]
            fn compiled<R: Register>(a: R) -> R {
                $function(Packed(a)).0
            }
            // SAFETY: the processor has the instructions, see the type.
            unsafe { compiled(a) }
        }
    )*};
}
pub(super) use compiled_for;

/// Implements [`Register`](super::register::Register) for a type around one register with the given lanes;
/// `splat(x)` puts x into every lane, and the braces contain the remaining items.
macro_rules! register {
    (
        $register:ident($raw:ident), lanes [$($lane:literal),*],
        splat = $splat:ident, exclusive_or = $exclusive_or:ident, { $($own:tt)* }
    ) => {
        impl Register for $register {
            const COUNT: usize = [$($lane),*].len();
            $($own)*

            #[cfg_attr(optimised, inline(always))]
            fn splat(x: f64) -> Self {
                // SAFETY: the processor has the instruction, see the type.
                Self(unsafe { $splat(x) })
            }

            #[cfg_attr(optimised, inline(always))]
            fn from_lanes(f: &mut impl FnMut(usize) -> f64) -> Self {
                Self::from_array([$(f($lane)),*])
            }

            #[cfg_attr(optimised, inline(always))]
            fn load(values: &[f64]) -> Option<Self> {
                Some(Self::from_array(*values.first_chunk()?))
            }

            #[cfg_attr(optimised, inline(always))]
            fn store(a: Self, values: &mut [f64]) -> Option<()> {
                *values.first_chunk_mut()? = a.to_array();
                Some(())
            }

            #[cfg_attr(optimised, inline(always))]
            fn lane(a: Self, i: usize) -> f64 {
                if i < Self::COUNT { a.to_array()[i] } else { f64::NAN }
            }

            #[cfg_attr(optimised, inline(always))]
            fn negate(a: Self) -> Self {
                // SAFETY: the processor has the instruction, see the type.
                Self(unsafe { $exclusive_or(a.0, Self::splat(-0.0).0) })
            }
        }

        impl $register {
            #[cfg_attr(optimised, inline(always))]
            fn from_array(lanes: [f64; Self::COUNT]) -> Self {
                // SAFETY: both types are as many numbers of 64 bits, in the same order.
                Self(unsafe { core::mem::transmute::<[f64; Self::COUNT], $raw>(lanes) })
            }

            #[cfg_attr(optimised, inline(always))]
            fn to_array(self) -> [f64; Self::COUNT] {
                // SAFETY: both types are as many numbers of 64 bits, in the same order.
                unsafe { core::mem::transmute::<$raw, [f64; Self::COUNT]>(self.0) }
            }
        }
    };
}
pub(super) use register;

/// Implements [`Mask`](crate::Mask) for a type around a register in which all bits of a lane are set where
/// it is true; `signs` gathers one bit of each lane.
macro_rules! mask_of_bits {
    (
        $mask:ident of $register:ident,
        and = $and:ident, or = $or:ident, exclusive_or = $exclusive_or:ident, signs = $signs:ident
    ) => {
        impl Mask for $mask {
            const COUNT: usize = $register::COUNT;

            intrinsics! {
                and(self, other) = $and;
                or(self, other) = $or;
            }

            #[cfg_attr(optimised, inline(always))]
            fn from_bool(truth: bool) -> Self {
                Self($register::splat(f64::from_bits(if truth { u64::MAX } else { 0 })).0)
            }

            #[cfg_attr(optimised, inline(always))]
            fn not(self) -> Self {
                // SAFETY: the processor has the instruction, see the type.
                Self(unsafe { $exclusive_or(self.0, Self::from_bool(true).0) })
            }

            #[cfg_attr(optimised, inline(always))]
            fn all(self) -> bool {
                self.bits() == (1 << Self::COUNT) - 1
            }

            #[cfg_attr(optimised, inline(always))]
            fn lane(self, i: usize) -> bool {
                i < Self::COUNT && self.bits() >> i & 1 == 1
            }
        }

        impl $mask {
            /// Returns one bit for each lane.
            #[cfg_attr(optimised, inline(always))]
            fn bits(self) -> i32 {
                // SAFETY: the processor has the instruction, see the type.
                unsafe { $signs(self.0) }
            }
        }
    };
}
pub(super) use mask_of_bits;
