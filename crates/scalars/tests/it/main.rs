//! What the scalars and their SIMD lanes promise.
#![allow(clippy::unwrap_used, clippy::panic)]

mod four_lanes;
mod lanes;
