//! Satellites in the gradient of gravity, on circles and ellipses, and bodies with reaction wheels.

mod attitudes;
mod kepler_orbits;
mod librations;
mod on_ellipses;
mod wheels;
