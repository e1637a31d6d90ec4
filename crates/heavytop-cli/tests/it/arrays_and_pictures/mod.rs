//! Systems whose states are arrays, the files of their runs, and the pictures and films of all runs.

mod array_sweeps;
mod chosen_columns;
mod drawn_marks;
mod files_of_arrays;
mod films;
mod plots;
mod sweep_curves;
mod systems_of_arrays;
