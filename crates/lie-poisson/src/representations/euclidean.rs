//! The Euclidean groups SE(2) and SE(3) with their Lie algebras.

use crate::representations::real_matrices::{SO2OnR2, SO3OnR3};
use crate::representations::semidirect::{SemidirectAlgebra, SemidirectGroup};
use generic_scalars::{Covector, Pair};
use nalgebra::Vector3;

/// The Lie algebra se(2) = so(2) ⋉ R².
pub type Se2 = SemidirectAlgebra<SO2OnR2>;

/// The special Euclidean group SE(2) = SO(2) ⋉ R² of the plane.
pub type SE2 = SemidirectGroup<SO2OnR2>;

/// The Lie algebra se(3) = so(3) ⋉ R³ of rigid motions of space.
pub type Se3 = SemidirectAlgebra<SO3OnR3>;

/// The special Euclidean group SE(3) = SO(3) ⋉ R³ of space.
pub type SE3 = SemidirectGroup<SO3OnR3>;

/// An element (Π, Γ) of se(3)∗: the angular part, then the part dual to translations.
pub type Se3Dual<T = f64> = Covector<Pair<Vector3<T>, Vector3<T>>>;
