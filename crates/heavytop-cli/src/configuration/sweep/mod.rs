//! The table `[sweep]`: which numbers vary, and what is measured.

mod top_parameter;
mod system_parameter;
mod force_parameter;
mod parameter;
mod column;
mod observable;
mod axis_config;
mod sweep_config;

pub use axis_config::AxisConfig;
pub(crate) use axis_config::{Spread, SweepAxis};
pub use column::Column;
pub use force_parameter::ForceParameter;
pub use observable::Observable;
pub use parameter::Parameter;
pub use sweep_config::SweepConfig;
pub use system_parameter::{SystemParameter, SystemTable};
pub use top_parameter::{Part, TopParameter};
