//! Every command that writes files, where writing fails: without room, in a folder that is read-only, after kills, and
//! beside another run on the same output.

mod damaged_checkpoints;
mod kills;
mod no_room;
mod read_only;
mod two_runs;
