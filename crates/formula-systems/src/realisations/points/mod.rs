//! Points with given momenta.

mod parts;
mod lift;
mod recentring;
