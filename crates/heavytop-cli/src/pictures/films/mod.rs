//! Films: animated GIF.

mod film_palette;
pub(crate) mod film;
