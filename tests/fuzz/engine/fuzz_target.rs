//! The target whose name the program has.

#![no_main]

libfuzzer_sys::fuzz_target!(|case: &[u8]| fuzz_targets::run(env!("CARGO_BIN_NAME"), case));
