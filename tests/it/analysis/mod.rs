//! What is measured along trajectories: sections, diagnostics, tangent vectors and Lyapunov exponents.

mod diagnostics;
mod lyapunov_exponents;
mod sections;
mod tangent_vectors;
