//! Isospectral integrators on u(N)∗, with N known when the program runs: Poisson maps, and methods that conserve the
//! spectrum alone at a lower cost.
//!
//! ```toml
//! [dependencies]
//! isospectral-flows = "0.1"
//! ```
//!
//! The example is a rigid body in N dimensions, by Manakov's equations on so(N)∗. The collective midpoint rule
//! conserves the spectrum of the angular momentum to round-off.
//!
//! ```
//! use collective_integrators::{Integrator, RungeKutta};
//! use isospectral_flows::{IsospectralField, IsospectralRungeKutta, LargeSkewHermitian};
//! use num_complex::Complex;
//!
//! struct RigidBody(Vec<f64>);
//! impl IsospectralField for RigidBody {
//!     fn size(&self) -> usize {
//!         self.0.len()
//!     }
//!     fn generator_into(&self, m: &LargeSkewHermitian, b: &mut LargeSkewHermitian) {
//!         let rate = |j: usize, k: usize| -m.at(j, k) / (self.0[j] + self.0[k]);
//!         *b = LargeSkewHermitian::from_upper(self.0.len(), rate);
//!     }
//! }
//! let size = 6; // from a file, say
//! let midpoint = IsospectralRungeKutta::new(
//!     RungeKutta::implicit_midpoint(),
//!     RigidBody((1..=size).map(|j| j as f64).collect()),
//! );
//! let mut m = LargeSkewHermitian::from_upper(size, |j, k| Complex::new(((j + 3 * k) as f64).sin(), 0.0));
//! let norm = m.norm();
//! let mut workspace = midpoint.workspace();
//! for _ in 0..100 {
//!     midpoint.step_in_place(&mut m, 0.1, &mut workspace)?;
//! }
//! assert!((m.norm() - norm).abs() < 1e-13);
//! # Ok::<(), collective_integrators::StepError>(())
//! ```
//!
//! # Which item when
//!
//! | when you need | use |
//! |---|---|
//! | an equation dW/dt = [B(W), W] of your own | [`IsospectralField`] |
//! | a Poisson map, by any symplectic Runge–Kutta method | [`IsospectralRungeKutta`] |
//! | a Poisson map whose error does not grow with N | [`ExponentialMidpoint`], and its [`Composition`] |
//! | the spectrum alone, at the lowest cost | [`GaussMagnus`] |
//! | the spectrum of each path of an equation with noise | [`NoisyIsospectral`], with an [`IsospectralNoise`] |
//! | no structure: an explicit method | [`Direct`](collective_integrators::Direct) with a [`CommutatorField`] |
//! | skew-Hermitian and complex matrices of any size | [`LargeSkewHermitian`], [`LargeMatrix`] |
//! | products, commutators, exponentials | [`Products`] |
//!
//! [`Composition`]: collective_integrators::Composition
//!
//! The table gives the cost of conserving each structure, in complex N×N products per step. A sweep is one iteration
//! for the generators, s is the number of stages, and e is the number of products of an exponential (3 to 7, and one
//! more for each halving of a spectral radius above 3.9):
//!
//! | method | order | conserves | products per step |
//! |---|---|---|---|
//! | [`IsospectralRungeKutta`] with Gauss | 2s | bracket, spectrum | 3s per sweep, plus 2 |
//! | [`ExponentialMidpoint`] | 2 | bracket, spectrum | one per term of a series and sweep, plus 2 + e |
//! | [`GaussMagnus`] | 2s | spectrum | s per sweep, plus 2 + e and 0, 1 or 3 commutators |
//! | explicit Runge–Kutta, direct | any | the trace | one per stage |
//!
//! # Conventions
//!
//! * W is skew-Hermitian, dW/dt = [B, W], and the scalar product is ⟨V, W⟩ = −tr(V W).
//! * For a Hamiltonian h with the differential dh in this scalar product, B = −dh gives the minus bracket and B = dh
//!   the plus bracket of [`lie_poisson`].
//! * For N known to the compiler, [`lie_poisson::UnitaryAlgebra`] is the same algebra, and
//!   `momentum_map::ComplexMatrices` gives the same collective integrators.
//!
//! The notation of all the crates is collected in `docs/notation.md` of the source repository.
//!
//! # Features and versions
//!
//! The crate has no features. The oldest supported compiler is Rust 1.89. Products are made by the crate `gemm-f64`, on one thread.
//! It uses the instructions that the processor has, so that the last digits of a step depend on the processor.
//!
//! # Related crates
//!
//! [`collective_integrators`] holds schemes, trajectories and diagnostics, and `lie-poisson-systems` equations of this
//! kind, such as Zeitlin's model of a fluid on the sphere.

mod matrices;
mod fields;
mod methods;

pub use fields::direct_field::CommutatorField;
pub use fields::driven_isospectral_field::DrivenIsospectralField;
pub use fields::isospectral_double_bracket::IsospectralDoubleBracket;
pub use fields::isospectral_field::IsospectralField;
pub use fields::isospectral_noise::IsospectralNoise;
pub use fields::isotropic_isospectral_noise::IsotropicIsospectralNoise;
pub use matrices::large_matrix::LargeMatrix;
pub use matrices::products::Products;
pub use matrices::skew_hermitian::LargeSkewHermitian;
pub use methods::exponential_midpoint::{ExponentialMidpoint, ExponentialWorkspace};
pub use methods::gauss_magnus::{GaussMagnus, MagnusWorkspace};
pub use methods::isospectral_runge_kutta::{IsospectralRungeKutta, IsospectralWorkspace};
pub use methods::noisy_isospectral::{NoisyIsospectral, NoisyIsospectralWorkspace};

pub use collective_integrators;
pub use lie_poisson;
pub use num_complex;

/// Compiles and runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
