//! What is found along runs: events, and the start as it is given.

mod events_of_any_function;
mod starts_as_given;
