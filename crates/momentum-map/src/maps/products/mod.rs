//! Products and powers of Poisson maps.

mod product_map;
mod product_algebra_map;
mod power_map;

pub use power_map::PowerMap;
pub use product_algebra_map::{DifferentSigns, ProductAlgebraMap};
pub use product_map::ProductMap;
