//! A run of `simulate`: methods, formats, accuracy, and the bytes that it writes.

mod accuracy;
mod backward;
mod forecasts;
mod formats;
mod methods;
mod numbers_in_all_units;
mod requested_columns;
mod same_bytes;
mod simulate;
