//! The samples of a run, column by column: [`Record`].

use pyo3::exceptions::PyMemoryError;
use pyo3::{PyErr, PyResult};

/// The times and the states of points.
#[derive(Clone, Default)]
pub(crate) struct Points {
    pub(crate) times: Vec<f64>,
    /// The coordinates of the states, as many each as the space has.
    pub(crate) states: Vec<f64>,
}

impl Points {
    /// Removes the points beyond a time, which is negative in a run backward in time.
    pub(crate) fn cut(&mut self, end: f64, width: usize) {
        let kept = self.times.iter().take_while(|time| time.abs() <= end.abs()).count();
        self.times.truncate(kept);
        self.states.truncate(kept * width);
    }
}

/// The record of a run.
#[derive(Default)]
pub(crate) struct Record {
    /// The recorded times and states.
    pub(crate) samples: Points,
    /// The conserved quantities, as many numbers each as there are.
    pub(crate) values: Vec<f64>,
    /// The attitude quaternions, four numbers each.
    pub(crate) attitudes: Vec<f64>,
    /// The points of each event.
    pub(crate) events: Vec<Points>,
    /// The number of iterations of all steps.
    pub(crate) iterations: u64,
    /// The index of the event that ended the run, if any.
    pub(crate) ended_by: Option<usize>,
    /// The error that ended the run, if any.
    pub(crate) failure: Option<PyErr>,
}

impl Record {
    /// Creates an empty record with room for all samples, which have `widths` coordinates, values and numbers of the
    /// attitude.
    pub(crate) fn new(samples: u64, widths: [usize; 3], events: usize) -> PyResult<Self> {
        let mut record = Self { events: vec![Points::default(); events], ..Self::default() };
        let Self { samples: Points { times, states }, values, attitudes, .. } = &mut record;
        let [dimension, count, attitude] = widths;
        let columns = [(times, 1), (states, dimension), (values, count), (attitudes, attitude)];
        let bytes: usize = columns.iter().map(|(_, width)| 8 * width).sum();
        for (column, width) in columns {
            let count =
                usize::try_from(samples).ok().and_then(|samples| samples.checked_mul(width));
            let room = count.is_some_and(|count| column.try_reserve_exact(count).is_ok());
            if !room {
                return Err(PyMemoryError::new_err(format!(
                    "{samples} samples of {bytes} bytes do not fit into memory; keep fewer with `every`"
                )));
            }
        }
        Ok(record)
    }

    /// Removes what lies beyond a time.
    pub(crate) fn cut(&mut self, end: f64, [dimension, count, attitude]: [usize; 3]) {
        self.samples.cut(end, dimension);
        let kept = self.samples.times.len();
        self.values.truncate(kept * count);
        self.attitudes.truncate(kept * attitude);
        self.events.iter_mut().for_each(|points| points.cut(end, dimension));
    }
}
