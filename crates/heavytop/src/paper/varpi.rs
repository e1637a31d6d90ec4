//! The Poisson map ϖ: (su(2) ⋉ C²)∗ → se(3)∗.

use crate::paper::spinor_motions::SpinorAlgebra;
use lie_poisson::{
    Covector, Differential, LiePoisson, Pair, Real, SO3OnR3, SU2OnC2, Se3, Se3Dual,
    SemidirectAlgebra,
};
use momentum_map::{PoissonMap, SourcePoint, TargetDifferential, hopf_map, hopf_pull_back};

/// The Poisson map ϖ: (su(2) ⋉ C²)∗ → se(3)∗, which is the Hopf map on the second component.
///
/// ```text
/// ϖ(μ, α) = (μ, ϖ₂(α))
/// ```
///
/// Both spaces have the minus Lie–Poisson bracket, and su(2)∗ and so(3)∗ both have the coordinates of R³. ϖ₂
/// is the [Hopf map](hopf_map), so ϖ is quadratic.
///
/// Source: Ohsawa 2019, eq. (3.1) and Prop. 3.1.
///
/// # Example
/// ```
/// use heavytop::Varpi;
/// use lie_poisson::{Covector, Pair, Se3Dual};
/// use momentum_map::PoissonMap;
/// use nalgebra::{Vector2, Vector3};
/// use num_complex::Complex;
/// let alpha = Vector2::new(Complex::new(1.0, 0.0), Complex::new(0.0, 2.0));
/// let mu = Vector3::new(1.0, 2.0, 3.0);
/// let image = Varpi.apply(&Covector(Pair(mu, alpha)));
/// assert_eq!(image, Se3Dual::new(mu, Vector3::new(0.0, 4.0, -3.0)));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Varpi;

impl PoissonMap for Varpi {
    type Source = LiePoisson<SpinorAlgebra>;
    type Target = LiePoisson<Se3>;

    fn source(&self) -> Self::Source {
        LiePoisson::minus(SemidirectAlgebra(SU2OnC2))
    }

    fn target(&self) -> Self::Target {
        LiePoisson::minus(SemidirectAlgebra(SO3OnR3))
    }

    #[inline]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> Se3Dual<T> {
        let Covector(Pair(mu, alpha)) = z;
        Se3Dual::new(*mu, hopf_map(alpha))
    }

    /// Returns the pull-back (Ω, 2 (γ·σ) α) of the differential (Ω, γ). Source: Ohsawa 2019, Appendix B.
    #[inline]
    fn pull_back<T: Real>(
        &self,
        dh: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        let (Pair(omega, gamma), Covector(Pair(_, alpha))) = (dh, z);
        Pair(*omega, hopf_pull_back(gamma, alpha))
    }
}
