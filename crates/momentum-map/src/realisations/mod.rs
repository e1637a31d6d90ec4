//! Realisations of duals of Lie algebras: Poisson maps from symplectic spaces, with lifts and fibre
//! symmetries.

mod hopf;
mod particle;
mod realisation;
mod sl2;
mod two_fields;
mod unitary;

pub use hopf::{HOPF, HopfRealisation};
pub use particle::{PARTICLE, ParticleRealisation};
pub use realisation::{Fibres, Realisation};
pub use sl2::{PlaneForm, Sl2Realisation};
pub use two_fields::{TWO_FIELDS, TwoFieldRealisation};
pub use unitary::{UnitaryRealisation, unitary_realisation};
