//! Numbers for all stages of a method, side by side: [`StageRow`].

use crate::tableaux::tableau::Tableau;
use core::array::from_fn;
use core::ops::RangeInclusive;
use lie_poisson::Lanes;

/// The largest number of stages that are computed side by side.
pub(crate) const WIDTH: usize = 8;

/// The numbers of stages that are computed side by side.
pub(crate) const SIDE_BY_SIDE: RangeInclusive<usize> = 2..=WIDTH;

/// A number for each stage, aligned for the widest register. Those of missing stages repeat the last stage.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(crate) struct StageRow(pub(crate) [f64; WIDTH]);

impl StageRow {
    pub(crate) const ZERO: Self = Self([0.0; WIDTH]);

    /// Loads the numbers of the stages in a block of lanes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn load<T: Lanes>(&self, block: usize) -> T {
        T::load(&self.0[block * T::COUNT..])
    }

    /// Stores the numbers of the stages in a block of lanes.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn store<T: Lanes>(&mut self, x: T, block: usize) {
        x.store(&mut self.0[block * T::COUNT..]);
    }
}

/// The columns a_0j, a_1j, … of the matrix of a method, for stages side by side. Missing columns are zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StageColumns {
    pub(crate) stages: usize,
    pub(crate) whole: [StageRow; WIDTH],
    /// The columns of the low parts; `None` if there are none.
    pub(crate) low: Option<[StageRow; WIDTH]>,
}

impl StageColumns {
    /// Creates the columns of an implicit method of two to [`WIDTH`] stages. Returns `None` for other methods.
    pub(crate) fn new(tableau: &Tableau) -> Option<Self> {
        let stages = tableau.stages();
        if tableau.is_explicit() || !SIDE_BY_SIDE.contains(&stages) {
            return None;
        }
        let low = (!tableau.row_low(0).is_empty())
            .then(|| from_fn(|j| column(stages, |i| tableau.row_low(i), j)));
        let whole = from_fn(|j| column(stages, |i| tableau.row(i), j));
        Some(Self { stages, whole, low })
    }
}

/// Returns a column of the matrix with the given rows, one for each stage; zero if there is no such column.
pub(crate) fn column<'a>(stages: usize, row: impl Fn(usize) -> &'a [f64], j: usize) -> StageRow {
    StageRow(from_fn(|i| row(i.min(stages - 1)).get(j).copied().unwrap_or(0.0)))
}

/// The storage of an iteration with stages side by side: a row for each coordinate.
#[derive(Clone, Debug, Default)]
pub(crate) struct StageRows {
    /// The stage derivatives.
    pub(crate) k: Vec<StageRow>,
    /// Those of the next sweep. All are computed from `k`, so that they do not depend on the number of lanes.
    pub(crate) next: Vec<StageRow>,
    /// The stage derivatives from which the iteration begins.
    pub(crate) guess: Vec<StageRow>,
    /// The sums Σ_j low_ij k_j.
    pub(crate) small: Vec<StageRow>,
}

impl StageRows {
    /// Creates empty storage with room for vectors of a dimension.
    pub(crate) fn with_room(dimension: usize) -> Self {
        let room = || Vec::with_capacity(dimension);
        Self { k: room(), next: room(), guess: room(), small: room() }
    }

    /// Makes room for vectors of a dimension, and sets the sums with the low parts to zero.
    pub(crate) fn fit(&mut self, dimension: usize) {
        for rows in [&mut self.k, &mut self.next, &mut self.guess] {
            rows.resize(dimension, StageRow::ZERO);
        }
        self.small.clear();
        self.small.resize(dimension, StageRow::ZERO);
    }

    /// Replaces the stage derivatives by the next ones.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn take_next(&mut self) {
        core::mem::swap(&mut self.k, &mut self.next);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::schemes::runge_kutta::RungeKutta;

    #[test]
    fn columns_have_the_low_parts_of_the_coefficients() {
        let gauss = RungeKutta::gauss(3).unwrap();
        let columns = StageColumns::new(gauss.tableau()).unwrap();
        let low = columns.low.unwrap();
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            assert_eq!(columns.whole[j].0[i], gauss.tableau().row(i)[j]);
            assert_eq!(low[j].0[i], gauss.tableau().row_low(i)[j]);
        }
        assert!(low.iter().any(|row| row.0.iter().any(|x| *x != 0.0)));
        // Control: a method whose coefficients are exact.
        let exact = Tableau::new(&[0.25, 0.0, 0.5, 0.25], &[0.5, 0.5]).unwrap();
        assert_eq!(StageColumns::new(&exact).unwrap().low, None);
    }
}
