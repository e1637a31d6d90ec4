//! The names in a formula: coordinates, parameters, and the letters of names; and letters that nobody sees.

pub(crate) mod letters;
pub(crate) mod invisible;
pub(crate) mod name_error;
pub(crate) mod coordinates;
pub(crate) mod parameters;
pub(crate) mod vocabulary;
pub(crate) mod named_algebra;
