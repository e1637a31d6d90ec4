//! The scales in which tangent vectors are measured: [`TangentScales`].

use crate::chaos::generic_tangents::generic_coordinate;
use crate::chaos::tangent_integrator::{DualStateOf, MomentumOf, StateOf, TangentIntegrator};
use crate::error::StepError;
use crate::integrators::trajectories::integrator::Integrator;
use crate::natural_scales::natural_scales;
use lie_poisson::{BlockScales, DualNumber, State, larger};

/// The scales of the blocks of tangent vectors, constant along a run.
pub(super) struct TangentScales<S: State, M: State> {
    /// The scales of the states, also of a single block.
    pub(super) state: BlockScales<S>,
    /// The scales of the momenta; 1 if they have a single block.
    pub(super) momentum: BlockScales<M>,
}

impl<S: State, M: State> Clone for TangentScales<S, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: State, M: State> Copy for TangentScales<S, M> {}

impl<S: State<Scalar = f64>, M: State> TangentScales<S, M> {
    /// Divides the blocks of tangent vectors of states by their scales. A single block stays as it is. `spare` has temporary
    /// vectors.
    pub(super) fn divide(&self, vectors: &mut [S], spare: &mut [S]) {
        if vectors.first().is_some_and(|v| v.blocks() > 1) {
            for (v, spare) in vectors.iter_mut().zip(spare) {
                spare.assign(v);
                v.set_coordinates(|i| self.state.coordinate(spare, i));
            }
        }
    }

    /// Multiplies the blocks of tangent vectors of states by their scales. A single block stays as it is. `spare` has
    /// temporary vectors.
    pub(super) fn multiply(&self, vectors: &mut [S], spare: &mut [S]) {
        if vectors.first().is_some_and(|v| v.blocks() > 1) {
            for (v, spare) in vectors.iter_mut().zip(spare) {
                spare.assign(v);
                v.set_coordinates(|i| spare.coordinate(i) * self.state.at(spare.block(i)));
            }
        }
    }
}

/// The number of directions in each block along which a step is differentiated.
const PROBES: usize = 3;

/// An integrator with the workspaces of a run, and the step size.
pub(super) struct Prober<'a, I: TangentIntegrator> {
    pub(super) integrator: &'a I,
    pub(super) workspace: &'a mut <I as Integrator>::Workspace,
    pub(super) dual_workspace: &'a mut <I as Integrator<DualNumber>>::Workspace,
    pub(super) dual: &'a mut DualStateOf<I>,
    pub(super) step: f64,
}

impl<I: TangentIntegrator> Prober<'_, I> {
    /// Returns the scales at a state: [`natural_scales`] by the derivative of one step along generic directions.
    ///
    /// A space of a single block needs no step. The workspaces forget the steps. If no scales are `wanted`, they are 1.
    ///
    /// # Errors
    /// Returns the error of a step that fails.
    pub(super) fn scales(
        mut self,
        state: &StateOf<I>,
        wanted: bool,
    ) -> Result<TangentScales<StateOf<I>, MomentumOf<I>>, StepError> {
        if !wanted {
            let (state, momentum) = (BlockScales::uniform(1.0), BlockScales::uniform(1.0));
            return Ok(TangentScales { state, momentum });
        }
        let blocks = state.blocks();
        let mut sizes = BlockScales::of(state);
        let mut couplings = BlockMatrix::zero(blocks);
        if blocks > 1 {
            StepError::check_start(state, self.step)?;
            // A block that is zero at the start may be left a step later.
            let mut next = state.clone();
            let made = Integrator::<f64>::step_in_place(
                self.integrator,
                &mut next,
                self.step,
                self.workspace,
            );
            Integrator::<f64>::forget(self.integrator, self.workspace);
            made?;
            sizes.include(&next);
            self.differentiate(state, &sizes, &mut couplings)?;
        }
        let state_scales = natural_scales(blocks, &sizes, |a, b| couplings.at(a, b));
        let mut scales = TangentScales { state: state_scales, momentum: BlockScales::uniform(1.0) };
        let momentum = Integrator::<f64>::momentum(self.integrator, state);
        if momentum.blocks() > 1 {
            scales.momentum = BlockScales::of(&momentum);
            self.include_images(state, &mut scales);
        }
        Ok(scales)
    }

    /// Measures the blocks of DΦ − 1 at a state.
    fn differentiate(
        &mut self,
        state: &StateOf<I>,
        sizes: &BlockScales<StateOf<I>>,
        couplings: &mut BlockMatrix,
    ) -> Result<(), StepError> {
        let (mut probe, mut change) = (state.zeros_like(), state.zeros_like());
        for (b, number) in probes(state.blocks()) {
            let size = if sizes.at(b) > 0.0 { sizes.at(b) } else { 1.0 };
            set_probe(&mut probe, b, number, size);
            let length = BlockScales::of(&probe).at(b);
            self.dual
                .set_coordinates(|i| DualNumber::new(state.coordinate(i), probe.coordinate(i)));
            let made = Integrator::<DualNumber>::step_in_place(
                self.integrator,
                self.dual,
                self.step,
                self.dual_workspace,
            );
            Integrator::<DualNumber>::forget(self.integrator, self.dual_workspace);
            made?;
            change.set_coordinates(|i| self.dual.coordinate(i).derivative() - probe.coordinate(i));
            let sizes = BlockScales::of(&change);
            for a in 0..state.blocks() {
                couplings.include(a, b, sizes.at(a) / length);
            }
        }
        Ok(())
    }

    /// Raises the scales of the momenta to the images of tangent vectors of the scales of the states.
    fn include_images(
        &mut self,
        state: &StateOf<I>,
        scales: &mut TangentScales<StateOf<I>, MomentumOf<I>>,
    ) {
        let mut probe = state.zeros_like();
        let mut image = Integrator::<f64>::momentum(self.integrator, state).zeros_like();
        for (b, number) in probes(state.blocks()) {
            set_probe(&mut probe, b, number, 1.0);
            let length = BlockScales::of(&probe).at(b);
            let unit = scales.state.at(b) / length;
            self.dual.set_coordinates(|i| {
                DualNumber::new(state.coordinate(i), probe.coordinate(i) * unit)
            });
            let moved = Integrator::<DualNumber>::momentum(self.integrator, self.dual);
            image.set_coordinates(|i| moved.coordinate(i).derivative());
            scales.momentum.include(&image);
        }
        for block in 0..image.blocks() {
            if !scales.momentum.at(block).is_normal() {
                scales.momentum.set(block, 1.0);
            }
        }
    }
}

/// Returns the blocks and the numbers of the directions in each.
fn probes(blocks: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..blocks).flat_map(|block| (0..PROBES).map(move |number| (block, number)))
}

/// Sets a generic vector of a block, with coordinates of a size.
fn set_probe<V: State<Scalar = f64>>(probe: &mut V, block: usize, number: usize, size: f64) {
    let dimension = probe.dimension();
    for i in 0..dimension {
        let inside = probe.block(i) == block;
        let coordinate = generic_coordinate(number % dimension.max(1), dimension, i);
        probe.set_coordinate(i, if inside { coordinate * size } else { 0.0 });
    }
}

/// A number c_ab for each pair of blocks.
struct BlockMatrix {
    blocks: usize,
    entries: Vec<f64>,
}

impl BlockMatrix {
    fn zero(blocks: usize) -> Self {
        Self { blocks, entries: vec![0.0; blocks * blocks] }
    }

    fn at(&self, a: usize, b: usize) -> f64 {
        self.entries[a * self.blocks + b]
    }

    /// Raises c_ab to a number, if that is larger.
    fn include(&mut self, a: usize, b: usize, size: f64) {
        let entry = &mut self.entries[a * self.blocks + b];
        *entry = larger(*entry, size);
    }
}
