//! The exit codes of the program.

use super::error::Error;
use lie_poisson_runs::RunFailure;
use std::io;

impl Error {
    /// Returns whether nobody reads the output any more: a reader that closed its pipe has read enough.
    #[must_use]
    pub fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Write { source, .. } if source.kind() == io::ErrorKind::BrokenPipe)
    }

    /// Returns the exit code of the error.
    ///
    /// It is 2 if the request is wrong and nothing was written, 1 if the command failed underway, and 130 if it was
    /// interrupted, as shells have it.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            // At the start nothing has been computed.
            Self::Run(RunFailure::NoEvent { time: 0.0, .. }) => 2,
            Self::Reference { .. }
            | Self::Write { .. }
            | Self::NoValue { .. }
            | Self::Run(
                RunFailure::Integration { .. }
                | RunFailure::NoValue { .. }
                | RunFailure::NoEvent { .. }
                | RunFailure::Timed { .. }
                | RunFailure::Path { .. },
            )
            | Self::Crossing { .. }
            | Self::AllFailed { .. }
            | Self::Tangent(_)
            | Self::Workers(_)
            | Self::Tile { .. }
            | Self::MissingTile { .. }
            | Self::Figure(_)
            | Self::Resumable { .. }
            | Self::Kept { .. } => 1,
            Self::Interrupted { .. } => 130,
            _ => 2,
        }
    }
}
