//! Satellites whose attitude is turned by the gradient of gravity, on (so(3) ⋉ (R³)²)∗, and by reaction wheels, on
//! so(3)∗.

pub(crate) mod kepler_orbit;
pub(crate) mod gravity_gradient;
pub(crate) mod on_circle;
pub(crate) mod on_ellipse;
pub(crate) mod reaction_wheels;
