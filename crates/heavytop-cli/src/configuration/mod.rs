//! The configuration: its tables, tops by name, and writing it.

mod top_config;
mod integrator_config;
mod system;
mod section_config;
mod observable;
mod parameter;
mod sweep_config;
mod config;
mod preset;
mod as_toml;

pub use config::{Config, OutputConfig};
pub use integrator_config::{Instructions, Integration, IntegratorConfig};
pub use observable::{Column, Observable};
pub use parameter::{Parameter, Part};
pub use preset::Preset;
pub use section_config::SectionConfig;
pub use sweep_config::{AxisConfig, SweepConfig};
pub(crate) use sweep_config::{Spread, SweepAxis};
pub use system::{Numbers, SystemConfig};
pub use top_config::{BodyConfig, InitialConfig};
