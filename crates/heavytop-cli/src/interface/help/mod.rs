//! The long texts of `--help`.

mod program;
mod runs;
mod comparisons;
mod maps;

pub(crate) use comparisons::{BENCH, BENCH_EXAMPLES, COMPARE, COMPARE_EXAMPLES};
pub(crate) use maps::{SECTION, SECTION_EXAMPLES, SWEEP, SWEEP_EXAMPLES};
pub(crate) use program::{COMPLETIONS_EXAMPLES, EXIT_CODES, INIT_EXAMPLES, MAN_EXAMPLES};
pub(crate) use runs::{
    ANIMATE, ANIMATE_EXAMPLES, REPRODUCE, REPRODUCE_EXAMPLES, SIMULATE, SIMULATE_EXAMPLES,
};
