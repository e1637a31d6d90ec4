//! The spherical midpoint method for the lattice of spins, on SIMD lanes and threads: [`LatticeMidpoint`].

use crate::spin_lattice::heisenberg_lattice::HeisenbergLattice;
use crate::spin_lattice::rows::{add_blocks, clear, sum_is_finite, write_blocks};
use crate::spin_lattice::slab_sweep::{Slab, SlabSweep};
use crate::spin_lattice::stencil::{BLOCK, Spins, Stencil};
use collective_integrators::{Integrator, StageSolver, StateIsMomentum, Step, StepError};
use lie_poisson::generic_scalars::{InstructionSet, MissingInstructions, Width, dispatch};
use lie_poisson::{Covector, Sites, larger};
use nalgebra::Vector3;
use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;

/// The spherical midpoint method for a [`HeisenbergLattice`], on SIMD lanes and on all threads.
///
/// Up to rounding it is the map of [`SphericalMidpoint`](collective_integrators::SphericalMidpoint) applied to the
/// lattice, a Poisson map of order 2:
///
/// ```text
/// s′ = s + h X(m),    m_i = |s_i| (s_i + s′_i)/|s_i + s′_i|,    X_i(m) = m_i × H_i(m)
/// ```
///
/// One sweep of its iteration reads s and X once, and writes X once. It keeps only the part of m that stays in the
/// cache: some rows of the planes of the lattice that the bonds of one plane reach. Rows of spins along x are padded to
/// multiples of 8; the storage is 72 bytes per spin of these rows, beside the state. The work is divided by planes, or
/// in two dimensions by rows, among the threads of the current pool. Results are bit-identical for any number of
/// threads, and on all processors with fused multiply-add. With [portable instructions](Self::with_instructions) they
/// are bit-identical on all processors. A chain along x has a single plane, and uses one thread; a chain along another
/// direction has rows of one spin, and is slow.
///
/// Spins, J, K and B are numbers without units, as in [`HeisenbergLattice`].
///
/// # Example
/// ```
/// use collective_integrators::{Integrator, SphericalMidpoint};
/// use lie_poisson_systems::{HeisenbergLattice, LatticeMidpoint};
/// use nalgebra::Vector3;
/// let lattice = HeisenbergLattice::new([6, 5, 4])?.with_exchange([1, 0, 0], 1.0)?;
/// let start = lattice.state(|[x, y, _]| Vector3::new(x as f64, 1.0, y as f64).normalize());
/// let (general, fast) = (SphericalMidpoint::new(lattice.clone()), LatticeMidpoint::new(lattice));
/// let mut ends = [start.clone(), start];
/// let (mut space, mut lanes) = (Integrator::<f64>::workspace(&general), fast.workspace());
/// general.step_in_place(&mut ends[0], 0.1, &mut space)?;
/// fast.step_in_place(&mut ends[1], 0.1, &mut lanes)?;
/// assert!(ends[0].0.iter().zip(ends[1].0.iter()).all(|(a, b)| (a - b).norm() < 1e-15));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LatticeMidpoint {
    lattice: HeisenbergLattice,
    stencil: Stencil,
    solver: StageSolver,
    instructions: InstructionSet,
}

/// The least number of spins of a slab, so that small lattices are not spread over threads.
const SLAB: usize = 4096;

impl LatticeMidpoint {
    /// Creates the method for a lattice, with the widest instructions of the processor.
    #[must_use]
    pub fn new(lattice: HeisenbergLattice) -> Self {
        let (stencil, instructions) = (lattice.stencil(), InstructionSet::detected());
        Self { lattice, stencil, solver: StageSolver::default(), instructions }
    }

    /// Returns the method with another solver for its implicit equation. Newton's iteration is not used.
    #[must_use]
    pub fn with_solver(self, solver: StageSolver) -> Self {
        Self { solver, ..self }
    }

    /// Replaces the instruction set. The portable set gives bit-identical results on every processor.
    ///
    /// # Errors
    /// Returns [`MissingInstructions`] if the processor lacks it.
    pub fn with_instructions(self, set: InstructionSet) -> Result<Self, MissingInstructions> {
        Ok(Self { instructions: set.if_available()?, ..self })
    }

    /// Returns the lattice of the spins.
    #[must_use]
    pub fn lattice(&self) -> &HeisenbergLattice {
        &self.lattice
    }

    /// Replaces the rates by those at the midpoints. Returns the largest change and the largest size of a component.
    fn sweep(&self, half_step: f64, space: &mut LatticeWorkspace) -> [f64; 2] {
        let LatticeWorkspace { start, rates: [rates, next], slabs, planes } = space;
        let (stencil, planes) = (&self.stencil, *planes);
        let plane = stencil.plane();
        // A block has as many spins as the widest register has lanes.
        let width = match self.instructions {
            InstructionSet::Avx512 => Width::Register,
            _ => Width::TwoRegisters,
        };
        let compute = |number: usize, next: &mut [Spins], slab: &mut Slab| {
            let first = number * planes;
            let planes = first..first + next.len() / plane;
            slab.progress = [f64::NAN; 2];
            let sweep = SlabSweep { stencil, half_step, start, rates, planes, next, slab };
            // The instructions are those that were found on this processor.
            dispatch(sweep, self.instructions, width).unwrap_or_default();
        };
        if let [slab] = &mut slabs[..] {
            compute(0, next, slab);
        } else {
            let tasks = next.par_chunks_mut(plane * planes).zip(slabs.par_iter_mut()).enumerate();
            tasks.for_each(|(number, (next, slab))| compute(number, next, slab));
        }
        core::mem::swap(rates, next);
        let progress = slabs.iter().map(|slab| slab.progress);
        progress.fold([0.0; 2], |[a, b], [c, d]| [larger(a, c), larger(b, d)])
    }

    /// Makes a step in storage that fits.
    fn step_within_pool(
        &self,
        s: &mut Covector<Sites<Vector3<f64>>>,
        step: f64,
        space: &mut LatticeWorkspace,
    ) -> Result<usize, StepError> {
        let nx = self.stencil.counts[0];
        write_blocks(&s.0, nx, &mut space.start);
        // The midpoints of k = 0 are the spins themselves: the first guess is X(s).
        clear(&mut space.rates[0]);
        self.sweep(0.0, space);
        let iterations = self.solver.solve_by_sweeps(|| self.sweep(0.5 * step, space))?;
        let rates = &space.rates[0];
        if !sum_is_finite(&space.start, step, rates) {
            return Err(StepError::NotFinite);
        }
        add_blocks(&mut s.0, step, rates, nx);
        Ok(iterations)
    }

    /// Makes the storage fit the lattice and the threads of the current pool.
    fn fit(&self, space: &mut LatticeWorkspace) {
        let count = self.stencil.counts[2];
        for storage in [&mut space.start].into_iter().chain(&mut space.rates) {
            storage.resize(self.stencil.plane() * count, Spins::default());
        }
        let spins = self.stencil.plane() * BLOCK;
        let least = SLAB.div_ceil(spins).max(4 * self.stencil.reach[2]);
        space.planes = count.div_ceil(rayon::current_num_threads()).max(least).min(count);
        space.slabs.resize_with(count.div_ceil(space.planes), Slab::default);
        space.slabs.iter_mut().for_each(|slab| slab.fit(&self.stencil));
    }
}

/// The storage of a step of [`LatticeMidpoint`].
#[derive(Clone, Debug, Default)]
pub struct LatticeWorkspace {
    start: Vec<Spins>,
    rates: [Vec<Spins>; 2],
    slabs: Vec<Slab>,
    /// The number of planes of a slab.
    planes: usize,
}

impl Integrator for LatticeMidpoint {
    type State = Covector<Sites<Vector3<f64>>>;
    type Momentum = Covector<Sites<Vector3<f64>>>;
    type Workspace = LatticeWorkspace;

    fn workspace(&self) -> LatticeWorkspace {
        LatticeWorkspace::default()
    }

    /// # Errors
    /// See [`step_in_place`](Self::step_in_place).
    fn step(
        &self,
        s: &Self::State,
        step: f64,
        space: &mut LatticeWorkspace,
    ) -> Result<Step<Self::State>, StepError> {
        Step::of_copy(s, |s| self.step_in_place(s, step, space))
    }

    /// Replaces the spins by those after one step. After the first step nothing is allocated, as long as the number of
    /// threads stays the same.
    ///
    /// # Errors
    /// Returns [`StepError::Dimension`] for a state with another number of spins, [`StepError::NotConverged`] if the
    /// implicit equation is not solved, for example if a spin is zero, or [`StepError::NotFinite`]. In these cases the
    /// spins are not changed.
    fn step_in_place(
        &self,
        s: &mut Self::State,
        step: f64,
        space: &mut LatticeWorkspace,
    ) -> Result<usize, StepError> {
        StepError::check_dimension(s, 3 * self.stencil.spins())?;
        self.fit(space);
        if space.slabs.len() == 1 {
            return self.step_within_pool(s, step, space);
        }
        // Within the pool a sweep finds threads that are awake.
        rayon::scope(|_| self.step_within_pool(s, step, space))
    }

    /// Nothing is remembered from step to step.
    fn forget(&self, _: &mut LatticeWorkspace) {}

    fn momentum(&self, s: &Self::State) -> Self::State {
        s.clone()
    }
}

impl StateIsMomentum for LatticeMidpoint {}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// 72 bytes per spin, 128 KiB for each thread, and nothing more after the first step.
    #[test]
    fn storage_is_linear_in_a_million_spins_and_does_not_grow() {
        let lattice = HeisenbergLattice::new([100; 3]).unwrap();
        let lattice = lattice.with_exchange([0, 0, 1], 1.0).unwrap();
        let mut s = lattice.state(|[x, _, z]| Vector3::new(x as f64, 1.0, z as f64).normalize());
        let midpoint = LatticeMidpoint::new(lattice);
        let mut space = midpoint.workspace();
        let bytes = |space: &LatticeWorkspace| {
            let blocks =
                space.start.capacity() + space.rates[0].capacity() + space.rates[1].capacity();
            let slabs: usize = space.slabs.iter().map(Slab::bytes).sum();
            blocks * size_of::<Spins>() + slabs
        };
        midpoint.step_in_place(&mut s, 1e-3, &mut space).unwrap();
        let first = bytes(&space);
        // rows of 100 spins are padded to 104, and each slab holds what the cache does
        let slabs = space.slabs.len();
        assert!(first <= 72 * 104 * 100 * 100 + slabs * (128 << 10), "{first}");
        midpoint.step_in_place(&mut s, 1e-3, &mut space).unwrap();
        assert_eq!(bytes(&space), first);
    }
}
