//! Tops: the integrators that follow them, and reports of their motion.

mod fastest_tops;
mod reports;
