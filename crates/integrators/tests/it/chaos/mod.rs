//! Indicators of chaos.

mod lyapunov;
mod tangents_along_fibres;
