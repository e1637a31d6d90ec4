//! A run of `simulate`: methods, formats, progress, and the bytes that it writes.

mod accuracy;
mod backward;
mod closing;
mod forecasts;
mod formats;
mod manners;
mod methods;
mod progress;
mod same_bytes;
mod simulate;
