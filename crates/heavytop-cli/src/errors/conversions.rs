//! Errors of the libraries as errors of the program.

use super::error::Error;
use super::parts::system_table_error::SystemTableError;
use heavytop::methods::MethodError;
use lie_poisson_formula_systems::{FormulaSystemError, OpenSystemError};
use lie_poisson_runs::RunFailure;
use momentum_map::LiftError;
use plotters::drawing::DrawingAreaErrorKind;
use svg_pictures::PictureError;

impl From<MethodError> for Error {
    fn from(error: MethodError) -> Self {
        match error {
            MethodError::Tolerance { value } => Self::OutOfRange {
                name: "integrator.tolerance",
                range: "finite and not negative",
                value,
            },
            error => Self::Method(error),
        }
    }
}

impl From<RunFailure> for Error {
    fn from(error: RunFailure) -> Self {
        match error {
            RunFailure::Start(error) => error.into(),
            RunFailure::Method(error) => error.into(),
            RunFailure::System(error) => (*error).into(),
            RunFailure::NoDirection { name, value } => {
                let name = if name == "end" { "integrator.end" } else { "integrator.step" };
                Self::OutOfRange { name, range: "finite and different from 0", value }
            }
            RunFailure::EarlyEnd { end: value } => {
                Self::OutOfRange { name: "integrator.end", range: "finite and more than 10", value }
            }
            RunFailure::Tangent(error) => Self::Tangent(error),
            RunFailure::Top(error) => Self::Spin(error),
            error => Self::Run(error),
        }
    }
}

impl From<SystemTableError> for Error {
    fn from(error: SystemTableError) -> Self {
        Self::System(Box::new(error))
    }
}

impl From<OpenSystemError> for Error {
    fn from(error: OpenSystemError) -> Self {
        FormulaSystemError::from(error).into()
    }
}

impl From<FormulaSystemError> for Error {
    fn from(error: FormulaSystemError) -> Self {
        match error {
            FormulaSystemError::Method(error) => error.into(),
            FormulaSystemError::Lift(error) => error.into(),
            error => SystemTableError::from(error).into(),
        }
    }
}

impl Error {
    /// Returns the error of a section of a system.
    pub(crate) fn of_system_section(error: FormulaSystemError) -> Self {
        Self::SystemSection(Box::new(error))
    }
}

impl From<LiftError> for Error {
    fn from(error: LiftError) -> Self {
        Self::Start(error.into())
    }
}

impl From<PictureError> for Error {
    fn from(error: PictureError) -> Self {
        Self::Figure(error.to_string())
    }
}

impl From<DrawingAreaErrorKind<PictureError>> for Error {
    fn from(error: DrawingAreaErrorKind<PictureError>) -> Self {
        Self::Figure(error.to_string())
    }
}
