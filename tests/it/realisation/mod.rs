//! §3–4 of the paper: the momentum map M as a Poisson map, its lifts, and the symmetries of its fibres.

mod exact;
mod involution;
mod lifts;
mod poisson_maps;
mod spinor_realisation;
mod symmetries;
mod varpi;
