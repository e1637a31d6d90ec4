//! Systems by name with orbits, wheels and motors.

mod motors_of_wheels;
mod satellites_on_ellipses;
