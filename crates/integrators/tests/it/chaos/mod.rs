//! Indicators of chaos.

mod lyapunov;
