//! Fields of Lie algebra elements, whose motions stay on coadjoint orbits: with time and with controls.

pub(crate) mod known_coordinate;
pub(crate) mod time_axis;
pub(crate) mod path_axis;
pub(crate) mod orbit_field;
pub(crate) mod interpolation;
pub(crate) mod input_table;
pub(crate) mod inner_product;
pub(crate) mod breakpoints;
pub(crate) mod control;
