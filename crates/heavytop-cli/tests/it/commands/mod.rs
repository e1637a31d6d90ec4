//! Each command of the program, except `simulate`.

mod animate;
mod bench;
mod compare;
mod completions;
mod init_and_man;
#[cfg(feature = "mpi")]
mod mpi;
mod reproduce;
mod section;
pub mod sweep;
