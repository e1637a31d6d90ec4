//! Fields of Lie algebra elements, whose motions stay on coadjoint orbits: with time, with controls, and with
//! dissipation.

pub(crate) mod time_axis;
pub(crate) mod orbit_field;
pub(crate) mod interpolation;
pub(crate) mod input_table;
pub(crate) mod inner_product;
pub(crate) mod control;
pub(crate) mod double_bracket;
pub(crate) mod noise;
pub(crate) mod gilbert_damping;
