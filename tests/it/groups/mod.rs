//! §2 of the paper: the groups, their algebras, brackets and actions, and the momentum map L.

mod actions;
mod algebras;
mod brackets;
mod momentum_map_l;
mod semidirect_group;
