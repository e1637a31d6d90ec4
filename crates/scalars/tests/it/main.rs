//! The promises of the crate: scalars, and their SIMD lanes (several numbers in one register).
#![allow(clippy::unwrap_used, clippy::panic)]

mod differentials;
mod four_lanes;
mod functions;
mod lanes;
mod operators;
mod states;
mod unfused_lanes;
