//! A lattice of spins with open ends: [`OpenLattice`].

use collective_integrators::VectorField;
use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, State};
use lie_poisson_systems::{HeisenbergLattice, SystemError};
use nalgebra::Vector3;

/// A lattice that is periodic along some axes and ends along the others: a periodic lattice without the bonds that go round
/// it along the others.
#[derive(Clone, Debug)]
pub(in crate::arrays) struct OpenLattice {
    pub(super) periodic: HeisenbergLattice,
    /// The bonds that are taken away: two spins, and J.
    cut: Vec<([usize; 2], f64)>,
    /// The numbers of spins along the axes, the last of which is the fastest, and which axes are periodic.
    axes: Vec<(usize, bool)>,
}

impl OpenLattice {
    /// Creates a lattice without bonds.
    ///
    /// # Errors
    /// If there are no spins, or too many.
    pub(in crate::arrays) fn new(axes: Vec<(usize, bool)>) -> Result<Self, SystemError> {
        let mut cells = [1; 3];
        cells.iter_mut().zip(axes.iter().rev()).for_each(|(cells, (count, _))| *cells = *count);
        Ok(Self { periodic: HeisenbergLattice::new(cells)?, cut: Vec::new(), axes })
    }

    /// Returns the numbers of spins along the axes, and which axes are periodic.
    pub(in crate::arrays) fn axes(&self) -> &[(usize, bool)] {
        &self.axes
    }

    /// Returns whether no bond is taken away.
    pub(in crate::arrays) fn is_periodic(&self) -> bool {
        self.cut.is_empty()
    }

    /// Adds bonds of each spin to the one at an offset along the axes.
    ///
    /// # Errors
    /// If J is not finite.
    pub(in crate::arrays) fn with_exchange(
        mut self,
        offset: &[i64],
        constant: f64,
    ) -> Result<Self, SystemError> {
        let mut cells = [0; 3];
        cells.iter_mut().zip(offset.iter().rev()).for_each(|(cell, d)| *cell = *d);
        self.periodic = self.periodic.with_exchange(cells, constant)?;
        if self.axes.iter().zip(offset).any(|((_, periodic), d)| !periodic && *d != 0) {
            let ends =
                (0..self.periodic.count()).filter_map(|i| Some([i, self.beyond(i, offset)?]));
            let cut: Vec<_> = ends.map(|ends| (ends, constant)).collect();
            self.cut.extend(cut);
        }
        Ok(self)
    }

    /// Returns the lattice with an anisotropy along an axis.
    ///
    /// # Errors
    /// If a number is not finite or the axis has no direction.
    pub(super) fn with_anisotropy(self, axis: Vector3<f64>, k: f64) -> Result<Self, SystemError> {
        Ok(Self { periodic: self.periodic.with_anisotropy(axis, k)?, ..self })
    }

    /// Returns the lattice in a magnetic field.
    ///
    /// # Errors
    /// If a component is not finite.
    pub(super) fn with_field(self, field: Vector3<f64>) -> Result<Self, SystemError> {
        Ok(Self { periodic: self.periodic.with_field(field)?, ..self })
    }

    /// Returns the spin at an offset from another on the periodic lattice, if it is beyond an open end.
    fn beyond(&self, mut spin: usize, offset: &[i64]) -> Option<usize> {
        let (mut other, mut stride, mut is_beyond) = (0, 1, false);
        for ((count, periodic), d) in self.axes.iter().zip(offset).rev() {
            let target = (spin % count) as i64 + d;
            let wrapped = target.rem_euclid(*count as i64);
            is_beyond |= !periodic && wrapped != target;
            other += stride * wrapped as usize;
            (spin, stride) = (spin / count, stride * count);
        }
        is_beyond.then_some(other)
    }
}

impl<T: Real> SitesHamiltonian<Vector3<T>> for OpenLattice {
    fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
        let whole = self.periodic.value(s);
        if s.0.len() != self.periodic.count() {
            return whole;
        }
        let bonds = self.cut.iter().map(|([i, j], constant)| s.0[*i].dot(&s.0[*j]) * *constant);
        bonds.fold(whole, |sum, bond| sum + bond)
    }

    fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        self.periodic.differential_into(s, dh);
        if [s.0.len(), dh.len()] == [self.periodic.count(); 2] {
            for ([i, j], constant) in &self.cut {
                let constant = T::from_f64(*constant);
                dh[*i] += s.0[*j] * constant;
                dh[*j] += s.0[*i] * constant;
            }
        }
    }
}

impl<T: Real> VectorField<T> for OpenLattice {
    type Point = Covector<Sites<Vector3<T>>>;

    fn at(&self, s: &Self::Point) -> Self::Point {
        let mut rate = s.zeros_like();
        self.at_into(s, &mut rate);
        rate
    }

    /// ds/dt = ∂h/∂s × s
    fn at_into(&self, s: &Self::Point, rate: &mut Self::Point) {
        self.periodic.at_into(s, rate);
        if [s.0.len(), rate.0.len()] == [self.periodic.count(); 2] {
            for ([i, j], constant) in &self.cut {
                let turned = s.0[*j].cross(&s.0[*i]) * T::from_f64(*constant);
                rate.0[*i] += turned;
                rate.0[*j] -= turned;
            }
        }
    }
}
