//! Every command that writes files, where writing fails: without room, in a folder that is read-only, after kills, and
//! beside another run on the same output; and where what an interrupted run has left is damaged.

mod damaged_checkpoints;
mod damaged_tiles;
mod full_disks;
mod kills;
mod no_room;
mod private_mounts;
mod read_only;
mod two_runs;
