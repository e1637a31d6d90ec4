//! Motions of tops, also backward: splittings, attitudes, sections, and methods that descend to 𝔰𝔢(3)∗.

mod estimated_errors;
mod attitude;
mod descent;
mod euler_angles;
mod langevin;
mod poincare;
mod published_bodies;
mod splittings;
mod there_and_back;
