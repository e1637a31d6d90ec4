//! What is drawn of a run, and how: [`PlotOptions`].

/// The options of `plot`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlotOptions {
    /// The number of the sample that is drawn, from 0; the last one without it.
    pub sample: Option<usize>,
    /// The index along the third axis of the plane that is drawn; the middle one without it.
    pub plane: Option<usize>,
}
