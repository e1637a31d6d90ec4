//! The arguments that describe a body.

use heavytop::{Body, HeavyTop, PrincipalAxes, TopError, point_inertia, require_possible_body};
use nalgebra::{Matrix3, Vector3};
use pyo3::{FromPyObject, IntoPyObject};

/// Moments of inertia: the principal ones, or the rows of a matrix.
#[derive(Clone, Copy, FromPyObject, IntoPyObject)]
pub(crate) enum InertiaArgument {
    Principal([f64; 3]),
    Matrix([[f64; 3]; 3]),
}

/// The arguments that describe a body.
#[derive(Clone, Copy)]
pub(crate) struct BodyArguments {
    pub(crate) inertia: InertiaArgument,
    pub(crate) mass: f64,
    pub(crate) gravity: f64,
    pub(crate) length: f64,
    pub(crate) center_of_mass: [f64; 3],
    /// Whether the moments are about the centre of mass.
    pub(crate) is_central: bool,
}

impl From<BodyArguments> for (InertiaArgument, f64, f64, f64, [f64; 3], bool) {
    fn from(body: BodyArguments) -> Self {
        let BodyArguments { inertia, mass, gravity, length, center_of_mass, is_central } = body;
        (inertia, mass, gravity, length, center_of_mass, is_central)
    }
}

impl BodyArguments {
    /// Returns the position of the centre of mass.
    fn position(&self) -> Vector3<f64> {
        Vector3::from(self.center_of_mass) * self.length
    }

    /// Returns the inertia matrix about the support.
    fn matrix(&self) -> Matrix3<f64> {
        let given = match self.inertia {
            InertiaArgument::Principal(moments) => Matrix3::from_diagonal(&Vector3::from(moments)),
            InertiaArgument::Matrix(rows) => Matrix3::from_fn(|i, j| rows[i][j]),
        };
        match self.is_central {
            true => given + point_inertia(self.mass, &self.position()),
            false => given,
        }
    }

    /// Returns the principal moments about the support and the principal axes.
    ///
    /// # Errors
    /// If a matrix is not symmetric, or no body has the moments about its centre of mass.
    pub(crate) fn axes(&self) -> Result<PrincipalAxes, TopError> {
        if self.is_central {
            require_possible_body(&self.matrix(), self.mass, &self.position())?;
        } else if let InertiaArgument::Principal(moments) = self.inertia {
            return Ok(PrincipalAxes::aligned(moments.into()));
        }
        PrincipalAxes::of(&self.matrix())
    }

    /// Returns the top in its principal axes.
    ///
    /// # Errors
    /// If there is no such top.
    pub(crate) fn top(&self, axes: &PrincipalAxes) -> Result<HeavyTop, TopError> {
        let Self { mass, gravity, length, .. } = *self;
        let center_of_mass = axes.to_principal(&Vector3::from(self.center_of_mass));
        HeavyTop::new(&Body { inertia: axes.moments(), mass, gravity, length, center_of_mass })
    }

    /// Returns the reason why no body has these moments, if it has a weight and there is one.
    pub(crate) fn impossibility(&self) -> Option<String> {
        let possible = require_possible_body(&self.matrix(), self.mass, &self.position());
        let is_impossible = |error: &TopError| matches!(error, TopError::ImpossibleBody { .. });
        let error = possible.err().filter(is_impossible).filter(|_| self.gravity != 0.0)?;
        Some(error.to_string())
    }
}
