//! The fonts: their tables, the outlines of glyphs, and which face has a character.

pub(crate) mod bytes;
pub(crate) mod outline;
pub(crate) mod face;
pub(crate) mod faces;
