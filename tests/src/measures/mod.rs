//! Comparisons of numbers and maps: relative errors, defects of brackets and forms, extremes of runs.

pub(crate) mod compare;
pub(crate) mod defects;
pub(crate) mod forms;
pub(crate) mod runs;
