//! The tables of open systems: `[inputs]`, `[drive]`, `[damping]`, `[noise]`, `[torque]`.

mod element;
mod input_config;
mod input_file;
mod damping_config;
mod noise_config;
mod named_in_formulas;
mod open_tables;
mod open_run;
mod array_run;

pub use damping_config::{DampingConfig, DampingForm, InnerProductConfig};
pub use element::{Element, Formulas};
pub use input_config::InputConfig;
pub use noise_config::{NoiseConfig, Shell, ShellConfig};
pub(crate) use open_run::{OpenModel, OpenStart};
