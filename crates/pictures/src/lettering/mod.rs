//! Texts of drawings: their attributes, their letters side by side, the outlines and the boxes.

pub(crate) mod attributes;
pub(crate) mod letters;
pub(crate) mod row;
pub(crate) mod text;
pub(crate) mod outlines;
pub(crate) mod boxes;
pub(crate) mod description;
