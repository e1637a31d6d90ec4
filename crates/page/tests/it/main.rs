//! Tests of what the page promises.

mod exports;
mod failures;
mod records;
mod trajectories;
