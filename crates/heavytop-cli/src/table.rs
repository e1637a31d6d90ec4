//! Rows of numbers.

use heavytop::{HeavyTop, Invariant};
use lie_poisson::{Covector, Pair, Quaternion, Se3Dual};
use std::io::{self, Write};

/// The columns of a state.
pub const STATE_COLUMNS: &str = "t,Pi1,Pi2,Pi3,Gamma1,Gamma2,Gamma3";

/// The columns of the attitude.
pub const ATTITUDE_COLUMNS: &str = "qw,qx,qy,qz";

/// The attitude, in the order of its columns.
#[must_use]
pub fn attitude_values(attitude: &Quaternion) -> [f64; 4] {
    let vector = &attitude.vector;
    [attitude.scalar, vector.x, vector.y, vector.z]
}

/// The invariants that have a column: h, f₁, f₂, and K or G.
#[must_use]
pub fn columns(top: &HeavyTop) -> Vec<Invariant> {
    let mut invariants = top.invariants();
    // f₃ is Π₃, which has a column already.
    invariants.retain(|invariant| *invariant != Invariant::AxialMomentum);
    invariants
}

/// Writes the line of column names, with the attitude or without.
///
/// # Errors
/// Of the writer.
pub fn write_header(
    to: &mut impl Write,
    invariants: &[Invariant],
    attitude: bool,
) -> io::Result<()> {
    to.write_all(STATE_COLUMNS.as_bytes())?;
    for invariant in invariants {
        write!(to, ",{invariant}")?;
    }
    if attitude {
        write!(to, ",{ATTITUDE_COLUMNS}")?;
    }
    writeln!(to)
}

/// Writes a row: the time, the state, and the values of the invariants and of the attitude.
///
/// Each number has the fewest digits that read back as the same `f64`.
///
/// # Errors
/// Of the writer.
pub fn write_row(
    to: &mut impl Write,
    time: f64,
    mu: &Se3Dual,
    values: impl IntoIterator<Item = f64>,
) -> io::Result<()> {
    let Covector(Pair(pi, gamma)) = mu;
    write!(to, "{time:?}")?;
    for value in pi.iter().chain(gamma).copied().chain(values) {
        write!(to, ",{value:?}")?;
    }
    writeln!(to)
}
