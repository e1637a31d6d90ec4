//! The text that the program prints for an error: the error and its causes, each once.

use super::error::{Error, resumption};
use super::parts::checkpoint_error::CheckpointError;
use std::io;
use std::path::Path;

impl Error {
    /// Returns the text that the program prints: this error and its causes, each once, and below them the line of the
    /// configuration that is at fault, if it is known.
    #[must_use]
    pub fn message(&self) -> String {
        match self {
            Self::Resumable { resume, source } => source.message() + &resumption(resume),
            Self::Kept { partial, source } => {
                let partial = partial.display();
                format!("{}; what was computed until then is in {partial}", source.message())
            }
            Self::Quoted { quotation, source } => {
                format!("{quotation}: {}\n{}", source.message(), quotation.excerpt())
            }
            Self::Checkpoint { source, .. } => with_causes(self) + remedy(source),
            Self::Create { path, source } if source.kind() == io::ErrorKind::NotFound => {
                with_causes(self) + &missing_folder(path)
            }
            error => with_causes(error),
        }
    }
}

/// Joins the messages of the error and its causes, the outermost first.
fn with_causes(error: &dyn std::error::Error) -> String {
    let mut message = error.to_string();
    for cause in causes(error) {
        // The name of a table is followed by what is wrong in it, without a colon.
        let link = if message.ends_with(']') { " " } else { ": " };
        // Errors of other crates may repeat their causes.
        if !message.contains(&cause) {
            message = message + link + &cause;
        }
    }
    message
}

/// Returns the messages of the causes of an error, its own cause first.
fn causes(error: &dyn std::error::Error) -> impl Iterator<Item = String> {
    std::iter::successors(error.source(), |&cause| cause.source()).map(ToString::to_string)
}

/// Names the folder of an output if it does not exist.
fn missing_folder(path: &Path) -> String {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
    folder.map_or_else(String::new, |folder| format!("; make the folder {}", folder.display()))
}

fn remedy(source: &CheckpointError) -> &'static str {
    if source.is_of_no_use() { "; start anew with --restart" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::errors::SweepError;
    use collective_integrators::{IntegrationError, RunError, SchemeError, StepError};
    use heavytop::methods::{MethodError, SchemeName};
    use heavytop::{SectionError, TopError};
    use lie_poisson_runs::RunFailure;
    use momentum_map::LiftError;
    use std::error::Error as _;
    use std::path::PathBuf;

    fn step() -> IntegrationError {
        IntegrationError { step: 5, time: 0.5, source: StepError::StepSize { step: f64::INFINITY } }
    }

    fn refused() -> io::Error {
        io::Error::new(io::ErrorKind::PermissionDenied, "not allowed")
    }

    /// Returns an error of each kind with a cause, and the text that is printed for it.
    fn errors() -> Vec<(Error, &'static str)> {
        let path = || PathBuf::from("a.toml");
        let too_long = "step 5 at t = 0.5: the step size must be finite, it is inf";
        let written = || Error::Write { path: path(), source: refused() };
        let rows = CheckpointError::Rows { path: "a.csv".into(), source: refused() };
        let top = || TopError::NotPositive { name: "mass", value: -1.0 };
        let lift = LiftError { quantity: "Γ", value: 0.0, reason: "Γ must be different from 0" };
        let integration = |source| {
            Error::Run(RunFailure::Integration {
                formulation: "direct",
                scheme: "rk4",
                reason: source,
            })
        };
        vec![
            (
                Error::Read { path: path(), source: refused() },
                "cannot read the configuration a.toml: not allowed",
            ),
            (
                Error::Checkpoint { path: path(), source: rows },
                "cannot go on from a.toml: the rows in a.csv: not allowed",
            ),
            (
                Error::Checkpoint { path: path(), source: CheckpointError::Read(refused()) },
                "cannot go on from a.toml: not allowed",
            ),
            (Error::Body(top()), "[body] mass must be positive, got -1.0"),
            (Error::Vertical(top()), "[initial] mass must be positive, got -1.0"),
            (lift.into(), "[initial] no lift: Γ must be different from 0 (|Γ| = 0e0)"),
            (
                RunError::Integration(step()).into(),
                "[initial] step 5 at t = 0.5: the step size must be finite, it is inf",
            ),
            (
                MethodError::Scheme {
                    scheme: SchemeName::Gauss(0),
                    reason: SchemeError::NotFinite,
                }
                .into(),
                "gauss-0: a coefficient of the method is not finite",
            ),
            (
                Error::Create { path: path(), source: refused() },
                "cannot create a.toml: not allowed",
            ),
            (written(), "cannot write a.toml: not allowed"),
            (
                integration(step()),
                "direct, rk4: step 5 at t = 0.5: the step size must be finite, it is inf",
            ),
            (
                Error::Run(RunFailure::Timed { name: "rk4".into(), reason: step() }),
                "rk4: step 5 at t = 0.5: the step size must be finite, it is inf",
            ),
            (
                SectionError::Empty { energy: 1.0, least: 2.0 }.into(),
                "[section] no state of the section has an energy of 1.0 J: the least is 2.0 J",
            ),
            (
                Error::Crossing {
                    formulation: "direct",
                    scheme: "rk4",
                    start: 2,
                    source: step().into(),
                },
                "direct, rk4, start 2: step 5 at t = 0.5: the step size must be finite, it is inf",
            ),
            (SweepError::NoAxes.into(), "[sweep] axes must have at least one axis"),
            (Error::Tangent(step().into()), too_long),
            (Error::Tile { path: path(), source: refused() }, "cannot read a.toml: not allowed"),
            (
                Error::Resumable { resume: "--resume".into(), source: Box::new(written()) },
                "cannot write a.toml: not allowed; go on by the same command with --resume",
            ),
            (
                Error::Kept { partial: "a.partial".into(), source: Box::new(integration(step())) },
                "direct, rk4: step 5 at t = 0.5: the step size must be finite, it is inf; what was computed until then is in a.partial",
            ),
        ]
    }

    #[test]
    fn messages_have_every_cause_once() {
        for (error, message) in errors() {
            assert_eq!(error.message(), message);
        }
        let unwritable = toml::to_string(&1).err().map(Error::Unwritable);
        let message =
            unwritable.map(|error| (error.message(), error.source().map(ToString::to_string)));
        assert!(message.is_some_and(|(message, cause)| cause.is_some_and(|cause| {
            message == format!("the configuration cannot be written as TOML: {cause}")
        })));
    }

    #[test]
    fn no_error_repeats_its_causes() {
        for (error, _) in errors() {
            let mut said = error.to_string();
            for cause in causes(&error) {
                assert!(!said.contains(&cause), "{error:?}: {said:?} has {cause:?}");
                said = cause;
            }
        }
    }
}
