//! The long texts of `--help`, and their layout.

pub(crate) mod blocks;
pub(crate) mod layout;
mod program_help;
mod run_help;
mod comparison_help;
mod map_help;
mod array_help;

pub(crate) use array_help::{EXPORT, EXPORT_EXAMPLES, PLOT, PLOT_EXAMPLES};
pub(crate) use comparison_help::{
    BENCH, BENCH_EXAMPLES, COMPARE, COMPARE_EXAMPLES, REPORT, REPORT_EXAMPLES,
};
pub(crate) use map_help::{
    ENSEMBLE, ENSEMBLE_EXAMPLES, EVENTS, EVENTS_EXAMPLES, SECTION, SECTION_EXAMPLES, SWEEP,
    SWEEP_EXAMPLES,
};
pub(crate) use program_help::{COMPLETIONS_EXAMPLES, EXIT_CODES, INIT_EXAMPLES, MAN_EXAMPLES};
pub(crate) use run_help::{
    ANIMATE, ANIMATE_EXAMPLES, REPRODUCE, REPRODUCE_EXAMPLES, SIMULATE, SIMULATE_EXAMPLES,
};
