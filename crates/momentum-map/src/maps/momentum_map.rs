//! The momentum map of a cotangent-lifted action: [`MomentumMap`].

use crate::actions::action::{ActionPoint, Generator, GroupAction};
use crate::maps::poisson_map::{PoissonMap, SourcePoint, TargetDifferential, TargetPoint};
use crate::maps::symplectic_representation::ODD_POWER_TOLERANCE;
use crate::phase_spaces::cotangent::CotangentBundle;
use crate::phase_spaces::symplectic::SymplecticSpace;
use lie_poisson::{
    Differential, LieGroup, LiePoisson, Real, State, Vector, larger, odd_power_defect_of,
};
use nalgebra::DMatrix;

/// The momentum map J: T∗Q → 𝔤∗ of the cotangent lift of an action, derived from the action:
///
/// ```text
/// ⟨J(q, p), ξ⟩ = ⟨p, ξ_Q(q)⟩
/// ```
///
/// It is equivariant: J(g·z) = `Ad*_g` J(z) for a right action and J(g·z) = (`Ad*_g`)⁻¹ J(z) for a left action, where
/// g·z is the lifted action. Hence it is a Poisson map to 𝔤∗ with the [sign](crate::Side::lie_poisson_sign) of the
/// side.
///
/// Source: Marsden & Ratiu, *Introduction to Mechanics and Symmetry*, 2nd ed., Thm. 12.1.4 and
/// Thm. 12.4.1; Ohsawa 2019, §2.3.
///
/// # Example
/// For rigid motions of R³ the momentum map consists of the angular and the linear momentum, with the signs
/// of a right action:
/// ```
/// use lie_poisson::{Covector, Pair, Real, RealSpace, SE3, Se3Dual};
/// use momentum_map::{Cotangent, GroupAction, MomentumMap, PoissonMap, Side};
/// use nalgebra::{Matrix3, Vector3};
///
/// #[derive(Clone)]
/// struct RigidMotions; // the right action q ↦ Rᵀ(q − a) of SE(3)
/// impl GroupAction for RigidMotions {
///     type Group = SE3;
///     type Space = RealSpace<3>;
///     const SIDE: Side = Side::Right;
///     fn group(&self) -> SE3 { SE3::default() }
///     fn space(&self) -> RealSpace<3> { RealSpace }
///     fn act<T: Real>(&self, Pair(r, a): &Pair<Matrix3<T>, Vector3<T>>, q: &Vector3<T>) -> Vector3<T> {
///         r.transpose() * (q - a)
///     }
/// }
/// // J(q, p) = −(q × p, p)
/// let (q, p) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.5, 0.0, 1.0));
/// let j = MomentumMap(RigidMotions).apply(&Cotangent::new(q, Covector(p)));
/// assert_eq!(j, Se3Dual::new(-q.cross(&p), -p));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MomentumMap<A>(pub A);

/// The Lie algebra 𝔤 of an action.
type Algebra<A> = <<A as GroupAction>::Group as LieGroup>::Algebra;

impl<A: GroupAction> PoissonMap for MomentumMap<A> {
    type Source = CotangentBundle<A::Space>;
    type Target = LiePoisson<Algebra<A>>;

    fn source(&self) -> Self::Source {
        CotangentBundle(self.0.space())
    }

    fn target(&self) -> Self::Target {
        LiePoisson::new(self.0.group().algebra(), A::SIDE.lie_poisson_sign())
    }

    #[cfg_attr(optimised, inline(always))]
    fn apply<T: Real>(&self, z: &SourcePoint<Self, T>) -> TargetPoint<Self, T> {
        self.0.momentum::<T>(z)
    }

    /// Returns the covector i_X Ω for the generator X, which is the Hamiltonian vector field of z ↦ ⟨J(z), ξ⟩.
    #[cfg_attr(optimised, inline(always))]
    fn pull_back<T: Real>(
        &self,
        xi: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> Differential<Self::Source, T> {
        self.source().flat::<T>(&self.generator::<T>(xi, z))
    }

    /// Returns the generator of the cotangent lift at z.
    #[cfg_attr(optimised, inline(always))]
    fn generator<T: Real>(
        &self,
        xi: &TargetDifferential<Self, T>,
        z: &SourcePoint<Self, T>,
    ) -> SourcePoint<Self, T> {
        self.0.lifted_generator::<T>(xi, z)
    }

    /// Returns whether the generators are affine, ξ_Q(q) = A q + b, and the matrices \[A b; 0 0\] contain their odd
    /// powers.
    ///
    /// The computation takes about n³ products of matrices for a group of dimension n. See [`odd_power_defect_of`].
    fn equivariant_maps_descend(&self) -> bool {
        let n = <Generator<A> as Vector>::DIM;
        let matrices: Option<Vec<_>> = (0..n).map(|i| affine_matrix(&self.0, i)).collect();
        matrices.is_some_and(|matrices| odd_power_defect_of(matrices) <= ODD_POWER_TOLERANCE)
    }
}

/// Returns the matrix \[A b; 0 0\] of the generator A q + b of the i-th basis vector, or `None` if it is not affine.
fn affine_matrix<A: GroupAction>(action: &A, i: usize) -> Option<DMatrix<f64>> {
    let d = <ActionPoint<A> as Vector>::DIM;
    let at = |q: &ActionPoint<A>| action.infinitesimal_generator::<f64>(&Vector::basis(i), q);
    let offset = at(&Vector::zero());
    let mut matrix = DMatrix::zeros(d + 1, d + 1);
    let mut expected = offset;
    // a point whose coordinates obey no simple relation
    let coordinate = |j: usize| (1.0 + 1.7 * j as f64).sin();
    for j in 0..d {
        let column = at(&Vector::basis(j)) - offset;
        expected += column.scaled(coordinate(j));
        for k in 0..d {
            matrix[(k, j)] = column.coordinate(k);
            matrix[(k, d)] = offset.coordinate(k);
        }
    }
    let error = (at(&Vector::from_coordinates(coordinate)) - expected).max_abs();
    let size = matrix.iter().fold(0.0, |most, x| larger(most, x.abs()));
    (error <= AFFINE_TOLERANCE * size).then_some(matrix)
}

/// The largest deviation from an affine map, relative to its largest coefficient, that is a rounding error.
const AFFINE_TOLERANCE: f64 = 1e-12;
