//! Every command that writes files, where writing fails: without room, in a folder that is read-only, after kills, and
//! beside another run on the same output; where what an interrupted run has left is damaged; and where it would destroy
//! files of the user.

mod damaged_checkpoints;
mod damaged_tiles;
mod files_of_the_user;
mod full_disks;
mod kills;
mod no_room;
mod private_mounts;
mod read_only;
mod two_runs;
