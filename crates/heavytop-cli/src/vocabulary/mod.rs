//! The names in configurations and messages: formulations, schemes and other items.

pub(crate) mod brief;
pub(crate) mod suggestion;
pub(crate) mod named;
pub(crate) mod method_names;
