//! Motions of tops: splittings, attitudes, sections, and methods that descend to 𝔰𝔢(3)∗.

mod attitude;
mod backward;
mod descent;
mod poincare;
mod splittings;
