//! The balance of a run with forces in its summary: [`RunBalance`].

use collective_integrators::diagnostics::Balance;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// What forces supplied to the conserved quantities along a run, by the names of these; none if a request to stop came first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct RunBalance(pub BTreeMap<String, Supply>);

/// How a quantity changed along a run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Supply {
    /// The change from the beginning to the end.
    pub change: f64,
    /// What the forces supplied of it, by quadrature along the run.
    pub supplied: f64,
    /// The largest difference of both at the steps, which is what the method added.
    pub defect: f64,
}

impl RunBalance {
    /// Reads what was measured.
    pub(super) fn of(measured: Option<Vec<(String, Balance)>>) -> Self {
        let supply = |(name, Balance { change, supplied, defect }): (String, Balance)| {
            (name, Supply { change, supplied, defect })
        };
        Self(measured.into_iter().flatten().map(supply).collect())
    }

    /// Returns whether a request to stop came before there was a result.
    #[must_use]
    pub fn was_interrupted(&self) -> bool {
        self.0.is_empty()
    }

    /// Writes the supplies to the quantities that the forces change, as a part of a closing line.
    pub(super) fn write(
        &self,
        to: &mut fmt::Formatter<'_>,
        is_changed: impl Fn(&str) -> bool,
    ) -> fmt::Result {
        if self.was_interrupted() {
            return to.write_str("; the balance was interrupted");
        }
        let changed = self.0.iter().filter(|(name, _)| is_changed(name));
        for (name, Supply { supplied, defect, .. }) in changed {
            write!(to, "; the forces supply {supplied:.3e} to {name}, the method {defect:.1e}")?;
        }
        Ok(())
    }
}
