//! The Clebsch maps to the dual of an algebra from structure constants.

use crate::error::FormulaSystemError;
use lie_poisson::{
    Covector, Diagonal, ExtendedAdjoint, ExtendedCoadjoint, Momentum, Pair, Real, Representation,
    StructureConstants,
};
use momentum_map::{ClebschRealisation, Lift, Side, clebsch_realisation};
use nalgebra::{SVector, Vector1};

/// The adjoint or the coadjoint representation, extended by a cocycle so that it sees the centre. It is one type, so that
/// integrators on both are compiled once.
#[derive(Clone)]
pub(in crate::methods) enum Extended<const N: usize> {
    Adjoint(ExtendedAdjoint<StructureConstants<N>>),
    Coadjoint(ExtendedCoadjoint<StructureConstants<N>>),
}

/// The map of two copies of such a representation.
pub(in crate::methods) type ClebschMap<const N: usize> =
    ClebschRealisation<Diagonal<Extended<N>, 2>>;

/// Returns the map of the adjoint representation. If a momentum has no lift, it is that of the coadjoint representation.
/// The algebra is that of a dimension, completed to N. `missing` is the error of an algebra that has no map.
pub(in crate::methods) fn clebsch_map<const N: usize>(
    (table, dimension): (StructureConstants<N>, usize),
    mu: &Momentum<StructureConstants<N>>,
    missing: impl Fn() -> FormulaSystemError,
) -> Result<ClebschMap<N>, FormulaSystemError> {
    let of = |representation| clebsch_realisation(Diagonal(representation), Side::Right);
    let adjoint = ExtendedAdjoint::of_summand(table.clone(), dimension).map_err(|_| missing())?;
    let map = of(Extended::Adjoint(adjoint))?;
    if map.lift(mu).is_ok() {
        return Ok(map);
    }
    let coadjoint = ExtendedCoadjoint::of_summand(table, dimension).map_err(|_| missing())?;
    Ok(of(Extended::Coadjoint(coadjoint))?)
}

impl<const N: usize> Representation for Extended<N> {
    type Algebra = StructureConstants<N>;
    type Space<T: Real> = Pair<SVector<T, N>, Vector1<T>>;

    fn algebra(&self) -> Self::Algebra {
        match self {
            Self::Adjoint(extended) => extended.algebra(),
            Self::Coadjoint(extended) => extended.algebra(),
        }
    }

    fn act<T: Real>(&self, xi: &SVector<T, N>, v: &Self::Space<T>) -> Self::Space<T> {
        match self {
            Self::Adjoint(extended) => extended.act(xi, v),
            Self::Coadjoint(extended) => extended.act(xi, v),
        }
    }

    fn transpose_act<T: Real>(
        &self,
        xi: &SVector<T, N>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Covector<Self::Space<T>> {
        match self {
            Self::Adjoint(extended) => extended.transpose_act(xi, alpha),
            Self::Coadjoint(extended) => extended.transpose_act(xi, alpha),
        }
    }

    fn diamond<T: Real>(
        &self,
        v: &Self::Space<T>,
        alpha: &Covector<Self::Space<T>>,
    ) -> Momentum<Self::Algebra, T> {
        match self {
            Self::Adjoint(extended) => extended.diamond(v, alpha),
            Self::Coadjoint(extended) => extended.diamond(v, alpha),
        }
    }
}
