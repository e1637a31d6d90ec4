//! The tables `[body]` and `[initial]`: a top and the state from which it starts.

mod directions;
mod angle;
mod inertia;
mod body_config;
mod initial_config;
mod left_out;

pub use angle::Quantity;
pub(super) use angle::{AZIMUTH, AngleRange, INCLINATION};
pub use body_config::BodyConfig;
pub(super) use directions::{angles, normalised, unit_vector};
pub use inertia::{About, Inertia};
pub use initial_config::InitialConfig;
pub use left_out::LeftOut;
