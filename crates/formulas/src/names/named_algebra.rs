//! The usual names of the coordinates of 𝔤∗: [`NamedAlgebra`].

use super::coordinates::Coordinates;
use super::name_error::NameError;
use lie_poisson::{
    Inherited, LieAlgebra, PowerAlgebra, ProductAlgebra, RealSpace, SO2OnR2, SO3OnR3, SU2OnC2,
    SemidirectAlgebra, Sl2, So2, So3, StructureConstants, Su2, UnitaryAlgebra,
};

/// A Lie algebra with names for the coordinates of its dual.
///
/// | algebra | coordinates of 𝔤∗ |
/// |---|---|
/// | so(3) | `Pi` |
/// | so(2) | `Pi` (a scalar) |
/// | su(2), and an algebra from structure constants | `mu` |
/// | sl(2) | `alpha`, `beta`, `gamma` (scalars) |
/// | se(3) | `Pi`, `Gamma` |
/// | se(2) | `Pi` (a scalar), `Gamma` (two components) |
/// | se(3) ⋉ R³ | `Pi`, `P`, `Gamma` |
/// | su(2) ⋉ C² | `mu`, `alpha` (four components: Re α₁, Im α₁, Re α₂, Im α₂) |
/// | u(N) | `mu` (N² components, in the order of [`SkewHermitian`](lie_poisson::SkewHermitian)) |
/// | Rᴺ | `p` |
/// | 𝔤 × 𝔥 | those of both; if some clash, all have the suffixes `_1` and `_2` |
/// | 𝔤ᴺ | those of 𝔤 with the suffixes `_1` … `_N` |
///
/// # Example
/// ```
/// use lie_poisson::{Covector, Hamiltonian, LieAlgebra, PowerAlgebra, Real, So3};
/// use lie_poisson_formulas::{Coordinates, FormulaHamiltonian, NameError, NamedAlgebra, Parameters, Vocabulary};
/// use nalgebra::Vector3;
///
/// /// The Heisenberg algebra [e₀, e₁] = e₂.
/// #[derive(Clone)]
/// struct Heisenberg;
/// impl LieAlgebra for Heisenberg {
///     type Element<T: Real> = Vector3<T>;
///     fn bracket<T: Real>(&self, xi: &Vector3<T>, eta: &Vector3<T>) -> Vector3<T> {
///         Vector3::new(T::zero(), T::zero(), xi.x * eta.y - xi.y * eta.x)
///     }
/// }
/// impl NamedAlgebra for Heisenberg {
///     fn coordinates(&self) -> Result<Coordinates, NameError> {
///         Coordinates::scalars(["p", "q", "z"])
///     }
/// }
///
/// let names = Vocabulary::of(&Heisenberg, &Parameters::new())?;
/// let h = FormulaHamiltonian::<Heisenberg>::new("½*(p² + q²) + z", &names)?;
/// assert_eq!(h.differential(&Covector(Vector3::new(2.0, 3.0, 5.0))), Vector3::new(2.0, 3.0, 1.0));
///
/// let spins = PowerAlgebra::<So3, 4>(So3).coordinates()?;
/// assert_eq!(spins.names().nth(3).as_deref(), Some("Pi_2_1")); // the first component of Pi_2
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait NamedAlgebra: LieAlgebra {
    /// Returns the names of the coordinates of 𝔤∗, as many as the algebra has dimensions.
    ///
    /// # Errors
    /// Returns [`NameError::TooMany`] if the dimension is larger than a formula allows.
    fn coordinates(&self) -> Result<Coordinates, NameError>;
}

macro_rules! named {
    ($([$($parameters:tt)*] $algebra:ty: $coordinates:expr;)*) => {$(
        impl<$($parameters)*> NamedAlgebra for $algebra {
            fn coordinates(&self) -> Result<Coordinates, NameError> {
                $coordinates
            }
        }
    )*};
}

named! {
    [] So3: Coordinates::new().vector("Pi", 3);
    [] So2: Coordinates::new().scalar("Pi");
    [] Su2: Coordinates::new().vector("mu", 3);
    [] Sl2: Coordinates::scalars(["alpha", "beta", "gamma"]);
    [] SemidirectAlgebra<SO3OnR3>: Coordinates::new().vector("Pi", 3)?.vector("Gamma", 3);
    [] SemidirectAlgebra<SO2OnR2>: Coordinates::new().scalar("Pi")?.vector("Gamma", 2);
    [] SemidirectAlgebra<SU2OnC2>: Coordinates::new().vector("mu", 3)?.vector("alpha", 4);
    [] SemidirectAlgebra<Inherited<SO3OnR3, SO3OnR3>>:
        Coordinates::new().vector("Pi", 3)?.vector("P", 3)?.vector("Gamma", 3);
    [const N: usize] UnitaryAlgebra<N>: vector_or_nothing("mu", N.saturating_mul(N));
    [const N: usize] RealSpace<N>: vector_or_nothing("p", N);
    [const N: usize] StructureConstants<N>: vector_or_nothing("mu", N);
}

/// Returns the coordinates of a vector, or none for the dimension zero.
fn vector_or_nothing(name: &str, dimension: usize) -> Result<Coordinates, NameError> {
    if dimension == 0 { Ok(Coordinates::new()) } else { Coordinates::new().vector(name, dimension) }
}

impl<A: NamedAlgebra, B: NamedAlgebra> NamedAlgebra for ProductAlgebra<A, B> {
    fn coordinates(&self) -> Result<Coordinates, NameError> {
        self.0.coordinates()?.then(&self.1.coordinates()?)
    }
}

impl<A: NamedAlgebra, const N: usize> NamedAlgebra for PowerAlgebra<A, N> {
    fn coordinates(&self) -> Result<Coordinates, NameError> {
        self.0.coordinates()?.repeated(N)
    }
}
