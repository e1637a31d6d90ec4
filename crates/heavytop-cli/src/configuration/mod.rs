//! The configuration: its tables, tops by name, and writing it.

mod top;
mod integrator_config;
mod system;
mod open;
mod plane_limits;
mod section_config;
mod events_config;
mod sweep;
mod notes;
mod output_config;
mod config;
mod preset;
mod toml_tables;

pub use config::Config;
pub(crate) use config::IMPOSSIBLE;
pub use events_config::EventsConfig;
pub use integrator_config::{Instructions, Integration, IntegratorConfig};
pub use notes::Notes;
pub use open::{
    DampingConfig, DampingForm, Element, Formulas, InnerProductConfig, InputConfig, NoiseConfig,
    Shell, ShellConfig,
};
pub(crate) use open::{OpenModel, OpenStart};
pub use output_config::OutputConfig;
pub use plane_limits::PlaneLimits;
pub use preset::Preset;
pub use section_config::SectionConfig;
pub use sweep::{
    AxisConfig, Column, ForceParameter, Observable, Parameter, Part, SweepConfig, SystemParameter,
    SystemTable, TopParameter,
};
pub(crate) use sweep::{Spread, SweepAxis};
pub use system::{Bracket, Numbers, SystemConfig};
pub(crate) use toml_tables::{inner, read_saved};
pub use top::{About, BodyConfig, Inertia, InitialConfig, LeftOut, Quantity};
