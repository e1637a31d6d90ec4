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

impl View {
    /// Returns whether a picture shows one sample, and not the whole run.
    pub(super) fn is_of_a_sample(self) -> bool {
        matches!(self, Self::Fluid | Self::Vortices | Self::Lattice)
    }
}
