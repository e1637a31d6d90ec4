//! The largest deviations of the invariants, in columns of time.

/// The largest number of invariants of a top: h, f₁, f₂, and C, f₃, K and G, of which a top has at most one of the last two.
pub const MOST_INVARIANTS: usize = 6;

/// The largest number of columns.
pub const MOST_COLUMNS: usize = 512;

/// The largest deviations in a span of time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct DeviationColumn {
    /// The time of the last step in the span, s.
    pub time: f64,
    /// The largest |Δ| of each invariant.
    pub largest: [f64; MOST_INVARIANTS],
}

/// A record of constant size of a run of any length.
///
/// When all columns are taken, neighbours are joined, and every column has twice the span from then on.
#[derive(Clone, Debug)]
pub(crate) struct DeviationRecord {
    columns: Vec<DeviationColumn>,
    /// The span of time of a column, s.
    span: f64,
    /// The time at which the last column ends, s.
    end: f64,
}

impl DeviationRecord {
    /// Creates a record whose columns have this span at first.
    pub(crate) fn new(span: f64) -> Self {
        Self { columns: Vec::with_capacity(MOST_COLUMNS), span, end: f64::NEG_INFINITY }
    }

    pub(crate) fn columns(&self) -> &[DeviationColumn] {
        &self.columns
    }

    /// Adds deviations at a time after all others.
    pub(crate) fn push(&mut self, time: f64, deviations: &[f64; MOST_INVARIANTS]) {
        let largest = deviations.map(f64::abs);
        match self.columns.last_mut() {
            Some(last) if time < self.end => {
                *last = last.joined(&DeviationColumn { time, largest })
            }
            _ => {
                if self.columns.len() == MOST_COLUMNS {
                    self.join_neighbours();
                }
                self.columns.push(DeviationColumn { time, largest });
                self.end = time + self.span;
            }
        }
    }

    fn join_neighbours(&mut self) {
        let joined = |pair: &[DeviationColumn]| match pair {
            [first, second, ..] => Some(first.joined(second)),
            [only] => Some(*only),
            [] => None,
        };
        self.columns = self.columns.chunks(2).filter_map(joined).collect();
        self.columns.reserve(MOST_COLUMNS - self.columns.len());
        self.span *= 2.0;
    }
}

impl DeviationColumn {
    /// Returns the column of both spans. The deviations are finite.
    fn joined(&self, later: &Self) -> Self {
        let mut largest = self.largest;
        for (value, other) in largest.iter_mut().zip(later.largest) {
            *value = value.max(other);
        }
        // A run that goes back within a step has an earlier time.
        Self { time: self.time.max(later.time), largest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_run_keeps_its_largest_values_in_few_columns() {
        let mut record = DeviationRecord::new(0.1);
        for n in 0..100_000_u32 {
            let spike = if n == 77 { -5.0 } else { 1e-3 };
            record.push(f64::from(n) * 0.01, &[spike, f64::from(n), 0.0, 0.0, 0.0, 0.0]);
        }
        let columns = record.columns();
        assert!((MOST_COLUMNS / 2..=MOST_COLUMNS).contains(&columns.len()), "{}", columns.len());
        assert_eq!(columns.iter().filter(|column| column.largest[0] == 5.0).count(), 1);
        assert_eq!(columns.last().map(|c| (c.time, c.largest[1])), Some((999.99, 99_999.0)));
        assert!(columns.is_sorted_by(|a, b| a.time < b.time));
    }

    #[test]
    fn each_step_has_a_column_while_there_are_few() {
        let mut record = DeviationRecord::new(0.01);
        for n in 0..20_u32 {
            record.push(f64::from(n) * 0.25, &[f64::from(n); MOST_INVARIANTS]);
        }
        assert_eq!(record.columns().len(), 20);
    }
}
