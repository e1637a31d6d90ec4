//! The registers of known processors, and a type without intrinsics for all others.

pub(crate) mod register;
#[cfg(any(test, not(all(target_arch = "x86_64", target_feature = "sse2"))))]
pub(crate) mod plain;
#[cfg(target_arch = "x86_64")]
pub(crate) mod intrinsics;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(crate) mod sse2;
#[cfg(target_arch = "x86_64")]
pub(crate) mod unfused;
#[cfg(target_arch = "x86_64")]
pub(crate) mod avx2;
#[cfg(target_arch = "x86_64")]
pub(crate) mod avx512;
