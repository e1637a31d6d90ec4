//! Momenta that the library knows or finds.

mod cocycles;
mod clebsch;
mod spinors;
