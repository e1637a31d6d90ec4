//! SU(2) ⋉ C² and its action on C².

use lie_poisson::{SU2OnC2, SemidirectAlgebra, SemidirectGroup};
use momentum_map::{AffineAction, MomentumMap, Opposite};

/// The group SU(2) ⋉ C² with the product (U, ρ)·(W, ϑ) = (UW, Uϑ + ρ). Source: Ohsawa 2019, §2.2.
pub type SpinorGroup = SemidirectGroup<SU2OnC2>;

/// The Lie algebra su(2) ⋉ C² of [`SpinorGroup`]. Source: Ohsawa 2019, §2.3.
pub type SpinorAlgebra = SemidirectAlgebra<SU2OnC2>;

/// The right action of SU(2) ⋉ C² on C².
///
/// It is, with the infinitesimal generator X of (ξ, φ),
///
/// ```text
/// Ψ(U, ρ)(χ) = U∗(χ − ρ),    X(χ) = −ξχ − φ
/// ```
///
/// Its cotangent lift is (U∗(χ − ρ), U∗ψ). Source: Ohsawa 2019, §2.2 and §2.3.
///
/// # Example
/// ```
/// use heavytop::SPINOR_MOTIONS;
/// use lie_poisson::{Pair, Su2};
/// use momentum_map::GroupAction;
/// use nalgebra::{Vector2, Vector3};
/// use num_complex::Complex;
/// let c = Complex::new;
/// let (xi, phi) = (Vector3::new(0.1, 0.2, 0.3), Vector2::new(c(1.0, 2.0), c(3.0, 4.0)));
/// let chi = Vector2::new(c(0.5, 0.0), c(0.0, -1.0));
/// let velocity = SPINOR_MOTIONS.infinitesimal_generator(&Pair(xi, phi), &chi);
/// assert!((velocity + Su2.matrix(&xi) * chi + phi).norm() < 1e-15);
/// ```
pub type SpinorMotions = Opposite<AffineAction<SU2OnC2>>;

/// The action [`SpinorMotions`] as a value.
pub const SPINOR_MOTIONS: SpinorMotions = Opposite(AffineAction(SU2OnC2));

/// The momentum map L: T∗C² → (su(2) ⋉ C²)∗ of the cotangent lift of [`SpinorMotions`].
///
/// It is derived from the action:
///
/// ```text
/// L(χ, ψ) = ( ¼(χψ* − ψχ* − i Im(ψ*χ) I), −ψ )
/// ```
///
/// Source: Ohsawa 2019, §2.3.
pub type SpinorMomentum = MomentumMap<SpinorMotions>;
