//! The points of trajectories: [`Sample`].

/// One point of a trajectory, with its time and its momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sample<S, M> {
    /// The number of steps made; 0 for the initial state.
    pub step: u64,
    /// The time t, which is `step` times the step size.
    pub time: f64,
    /// The state that is advanced.
    pub state: S,
    /// The momentum μ of the state. For equations on a space other than 𝔤∗ it is the state itself.
    pub momentum: M,
    /// The number of iterations of the stage solver in the steps since the previous sample; 0 in the first one.
    pub iterations: usize,
}
