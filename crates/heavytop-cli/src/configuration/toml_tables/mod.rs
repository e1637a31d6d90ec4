//! Tables of TOML, as which configurations are read and written.

mod keyed_value;
mod as_toml;

pub(crate) use as_toml::{inner, read_saved};
