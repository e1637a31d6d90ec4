//! How a run is drawn: [`View`].

/// How a run is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum View {
    Fluid,
    Vortices,
    Lattice,
    Chain,
    Panels,
}
