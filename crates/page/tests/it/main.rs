//! Tests of what the page promises.

mod exports;
mod failures;
mod friction;
mod records;
mod trajectories;
