//! Classical spins on a lattice of any size, in one to three dimensions.

use crate::error::{SystemError, require_finite};
use crate::spin_lattice::stencil::Stencil;
use collective_integrators::VectorField;
use lie_poisson::{Covector, Real, Sites, SitesHamiltonian, State, Vector};
use nalgebra::Vector3;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

/// A periodic lattice of classical spins s_i with exchange, an easy axis and a magnetic field, of a size that is known
/// only when the program runs.
///
/// ```text
/// h(s) = −Σ_i ( Σ_o J_o s_i·s_(i+o) + K (a·s_i)² + B·s_i )
/// ds_i/dt = s_i × H_i,    H_i = −∂h/∂s_i = Σ_o J_o (s_(i+o) + s_(i−o)) + 2K (a·s_i) a + B
/// ```
///
/// These are the equations of Landau and Lifshitz without damping. Each exchange constant J_o belongs to an offset o,
/// given as numbers of cells along x, y and z, so bonds may have any range and direction; J > 0 is ferromagnetic. A
/// lattice with one cell in a direction has a lower dimension. The site in cell (x, y, z) has the index x + n_x (y +
/// n_y z).
///
/// The bracket is the plus bracket {s_a, s_b} = ε_abc s_c of each spin. The conserved quantities are h and every |s_i|.
/// If B and a lie along one axis, the component of Σ s_i along it is also conserved. Spins, J, K and B are numbers
/// without units.
///
/// Integrators for [`State`]s advance it in place: [`SphericalMidpoint`](collective_integrators::SphericalMidpoint) is
/// a Poisson map, and [`LatticeMidpoint`](crate::LatticeMidpoint) is its fast path. For Poisson maps of other orders
/// use [`CollectiveSites`](collective_integrators::CollectiveSites) with
/// `QuadraticMomentumMap::new(So3OnC2, Side::Left)`, whose bracket is the plus bracket. (`HOPF` has the minus bracket,
/// and turns the spins the other way.) The rows of cells along x are divided among all threads of the current pool,
/// with bit-identical results for any number of threads.
///
/// Source: Lakshmanan, *The fascinating world of the Landau–Lifshitz–Gilbert equation*, Phil. Trans. R. Soc. A 369
/// (2011), §4; McLachlan, Modin & Verdier, *Symplectic integrators for spin systems*, Phys. Rev. E 89 (2014).
///
/// # Example
/// A spin wave on a cubic lattice: spins on a cone about z, at the angle k·r − ωt, ω = s_z Σ_o 2J_o (1 − cos k·o).
/// ```
/// use collective_integrators::{Integrator, SphericalMidpoint};
/// use lie_poisson_systems::HeisenbergLattice;
/// use nalgebra::Vector3;
/// use std::f64::consts::TAU;
/// let lattice = HeisenbergLattice::new([8, 4, 4])?
///     .with_exchange([1, 0, 0], 1.0)?
///     .with_exchange([0, 1, 0], 1.0)?
///     .with_exchange([0, 0, 1], 1.0)?;
/// let wave = |angle: f64| Vector3::new(0.6 * angle.cos(), 0.6 * angle.sin(), 0.8);
/// let start = lattice.state(|[x, _, _]| wave(TAU * x as f64 / 8.0));
/// let midpoint = SphericalMidpoint::new(lattice.clone());
/// let mut run = midpoint.trajectory_from(start, 0.002);
/// let spins = run.advance(1000)?;
/// let omega = 0.8 * 2.0 * (1.0 - (TAU / 8.0).cos());
/// assert!((spins.0[3] - wave(TAU * 3.0 / 8.0 - omega * 2.0)).norm() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HeisenbergLattice {
    cells: [usize; 3],
    exchanges: Vec<Exchange>,
    axis: Vector3<f64>,
    anisotropy: f64,
    field: Vector3<f64>,
}

/// An exchange constant, with its offset reduced to the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Exchange {
    offset: [usize; 3],
    constant: f64,
}

/// The number of spins of a task, so that small lattices are not spread over threads.
const TASK: usize = 4096;

impl HeisenbergLattice {
    /// Creates a lattice with the given numbers of cells along x, y and z, without any interaction.
    ///
    /// # Errors
    /// Returns [`SystemError::Zero`] if a number is 0, or [`SystemError::TooMany`] if a state would have more
    /// than `isize::MAX` coordinates.
    pub fn new(cells: [usize; 3]) -> Result<Self, SystemError> {
        if cells.contains(&0) {
            return Err(SystemError::Zero { name: "the number of cells in a direction" });
        }
        let [x, y, z] = cells;
        let coordinates = [y, z, 3].iter().try_fold(x, |product, n| product.checked_mul(*n));
        if coordinates.is_none_or(|coordinates| isize::try_from(coordinates).is_err()) {
            return Err(SystemError::TooMany { name: "cells of the lattice" });
        }
        let (axis, field) = (Vector3::z(), Vector3::zeros());
        Ok(Self { cells, exchanges: Vec::new(), axis, anisotropy: 0.0, field })
    }

    /// Adds the exchange constant J of the bonds from each cell to the cell at the given offset. Add each bond only
    /// once: an offset stands for its opposite too.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] if J is not finite.
    pub fn with_exchange(mut self, offset: [i64; 3], constant: f64) -> Result<Self, SystemError> {
        require_finite("exchange", constant)?;
        let cells = self.cells.map(|count| count as i128);
        let reduced = |i: usize| i128::from(offset[i]).rem_euclid(cells[i]) as usize;
        self.exchanges.push(Exchange { offset: [0, 1, 2].map(reduced), constant });
        Ok(self)
    }

    /// Returns the lattice with an anisotropy K along an axis a. Only the direction of a counts. K > 0 makes it an easy
    /// axis, and K < 0 a hard axis.
    ///
    /// # Errors
    /// Returns [`SystemError`] if a number is not finite or the axis has no direction.
    pub fn with_anisotropy(self, axis: Vector3<f64>, k: f64) -> Result<Self, SystemError> {
        require_finite("anisotropy", k)?;
        axis.iter().try_for_each(|&component| require_finite("axis", component))?;
        let largest = axis.amax();
        if largest == 0.0 {
            return Err(SystemError::Zero { name: "axis" });
        }
        Ok(Self { axis: (axis / largest).normalize(), anisotropy: k, ..self })
    }

    /// Returns the lattice in a magnetic field B.
    ///
    /// # Errors
    /// Returns [`SystemError::NotFinite`] if a component is not finite.
    pub fn with_field(self, field: Vector3<f64>) -> Result<Self, SystemError> {
        field.iter().try_for_each(|&component| require_finite("field", component))?;
        Ok(Self { field, ..self })
    }

    /// Returns the numbers of cells along x, y and z.
    #[must_use]
    pub fn cells(&self) -> [usize; 3] {
        self.cells
    }

    /// Returns the number of spins.
    #[must_use]
    pub fn count(&self) -> usize {
        self.cells.iter().product()
    }

    /// Returns the state with the spin f([x, y, z]) in each cell.
    #[must_use]
    pub fn state(&self, f: impl Fn([usize; 3]) -> Vector3<f64>) -> Covector<Sites<Vector3<f64>>> {
        let [nx, ny, _] = self.cells;
        Covector((0..self.count()).map(|i| f([i % nx, i / nx % ny, i / nx / ny])).collect())
    }

    /// Returns the bonds and fields for planes of rows of spins.
    pub(crate) fn stencil(&self) -> Stencil {
        let exchanges = self.exchanges.iter().map(|exchange| (exchange.offset, exchange.constant));
        let (axis, twice_anisotropy) = (self.axis, 2.0 * self.anisotropy);
        Stencil { axis, twice_anisotropy, field: self.field, ..Stencil::new(self.cells, exchanges) }
    }

    /// Returns the row of cells at an offset from a row, and by how many cells along x it is shifted.
    fn neighbours<'a, V>(&self, row: usize, [x, y, z]: [usize; 3], s: &'a [V]) -> (usize, &'a [V]) {
        let [nx, ny, nz] = self.cells;
        let other = (row % ny + y) % ny + ny * ((row / ny + z) % nz);
        (x, &s[nx * other..nx * (other + 1)])
    }

    /// Calls f with the spins of each row and the fields H_i = −∂h/∂s_i of that row, on all threads.
    fn for_rows<T: Real>(
        &self,
        s: &[Vector3<T>],
        fields: &mut [Vector3<T>],
        f: impl Fn(&[Vector3<T>], &mut [Vector3<T>]) + Sync,
    ) {
        let nx = self.cells[0];
        let rows = TASK.div_ceil(nx);
        let tasks = fields.par_chunks_mut(nx * rows).enumerate();
        tasks.for_each(|(task, fields)| {
            for (row, fields) in (task * rows..).zip(fields.chunks_exact_mut(nx)) {
                self.fields_into(row, s, fields);
                f(&s[nx * row..nx * (row + 1)], fields);
            }
        });
    }

    /// Writes the fields H_i of the spins in one row.
    fn fields_into<T: Real>(&self, row: usize, s: &[Vector3<T>], fields: &mut [Vector3<T>]) {
        let (nx, field) = (self.cells[0], self.field.map(T::from_f64));
        fields.fill(field);
        for Exchange { offset, constant } in &self.exchanges {
            let opposite = [0, 1, 2].map(|i| (self.cells[i] - offset[i]) % self.cells[i]);
            for offset in [*offset, opposite] {
                let (shift, neighbours) = self.neighbours(row, offset, s);
                let (first, last) = neighbours.split_at(shift);
                let (before, after) = fields.split_at_mut(last.len());
                add_scaled(before, *constant, last);
                add_scaled(after, *constant, first);
            }
        }
        let spins = &s[nx * row..nx * (row + 1)];
        if self.anisotropy != 0.0 {
            let (axis, twice) = (self.axis.map(T::from_f64), 2.0 * self.anisotropy);
            for (field, spin) in fields.iter_mut().zip(spins) {
                *field += axis.scaled(axis.dot(spin) * twice);
            }
        }
    }
}

#[cfg_attr(optimised, inline(always))]
fn add_scaled<T: Real>(sum: &mut [Vector3<T>], constant: f64, terms: &[Vector3<T>]) {
    let constant = T::from_f64(constant);
    sum.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term.scaled(constant));
}

impl<T: Real> SitesHamiltonian<Vector3<T>> for HeisenbergLattice {
    fn value(&self, s: &Covector<Sites<Vector3<T>>>) -> T {
        if s.0.len() != self.count() {
            return T::from_f64(f64::NAN);
        }
        let (nx, axis, field) =
            (self.cells[0], self.axis.map(T::from_f64), self.field.map(T::from_f64));
        let mut sum = T::zero();
        for (row, spins) in s.0.chunks_exact(nx).enumerate() {
            for spin in spins {
                let along = axis.dot(spin);
                sum -= along * along * self.anisotropy + field.dot(spin);
            }
            for exchange in &self.exchanges {
                let (shift, neighbours) = self.neighbours(row, exchange.offset, &s.0);
                let shifted = neighbours[shift..].iter().chain(&neighbours[..shift]);
                let bonds = spins.iter().zip(shifted).map(|(a, b)| a.dot(b));
                sum -= bonds.fold(T::zero(), |sum, bond| sum + bond) * exchange.constant;
            }
        }
        sum
    }

    fn differential_into(&self, s: &Covector<Sites<Vector3<T>>>, dh: &mut Sites<Vector3<T>>) {
        if [s.0.len(), dh.len()] != [self.count(); 2] {
            return dh.set_coordinates(|_| T::from_f64(f64::NAN));
        }
        self.for_rows(&s.0, dh, |_, fields| fields.iter_mut().for_each(|field| *field = -*field));
    }
}

impl<T: Real> VectorField<T> for HeisenbergLattice {
    type Point = Covector<Sites<Vector3<T>>>;

    fn at(&self, s: &Self::Point) -> Self::Point {
        let mut rate = s.zeros_like();
        self.at_into(s, &mut rate);
        rate
    }

    /// Writes the rates ds_i/dt. They are NaN if s has another number of spins.
    fn at_into(&self, s: &Self::Point, rate: &mut Self::Point) {
        if [s.0.len(), rate.0.len()] != [self.count(); 2] {
            return rate.set_coordinates(|_| T::from_f64(f64::NAN));
        }
        self.for_rows(&s.0, &mut rate.0, |spins, fields| {
            fields.iter_mut().zip(spins).for_each(|(field, spin)| *field = spin.cross(field));
        });
    }
}
