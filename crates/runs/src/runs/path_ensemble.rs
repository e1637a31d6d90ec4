//! Statistics of many paths of a motion with noise: [`PathEnsemble`].

use super::experiment::Experiment;
use super::moment::Moment;
use crate::error::RunFailure;
use average::{Estimate, Quantile, Variance};
use collective_integrators::{AnyIntegrator, AnyState, RunError, Start};
use lie_poisson_formula_systems::OpenSystem;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// The most numbers of which statistics are kept: rows times columns.
const MOST_NUMBERS: u64 = 2_000_000;

/// The most numbers of paths that wait for their turn.
const MOST_WAITING: u64 = 4_000_000;

/// The paths that are followed before their numbers are added.
const MOST_TOGETHER: u64 = 256;

/// Many paths of an experiment with noise, and what is asked of them. Path i has the number of the path of the noise plus i.
///
/// The paths are followed on all threads, and their numbers are added in the order of the paths, so that the results do not depend
/// on the threads. No path is kept: means and variances are updated by Welford's method, and quantiles by the P² algorithm, which
/// estimates them.
///
/// Source of the second: Jain & Chlamtac, Commun. ACM 28 (1985), 1076–1085.
///
/// # Example
/// A spin at a temperature: in the limit of long times ⟨s₃⟩ = coth x − 1/x with x = B/kT.
/// ```
/// use lie_poisson::InnerProduct;
/// use lie_poisson_formula_systems::{Damping, FormulaSystem, NoiseFields, NoiseTerms, OpenSystem, OpenTerms, SystemAlgebra};
/// use lie_poisson_runs::{Experiment, Pace, PathEnsemble, Schedule};
/// let damping = Some(Damping::DoubleBracket { friction: 1.0, inner_product: InnerProduct::euclidean() });
/// let fields = NoiseFields::thermal(damping.as_ref(), 0.5)?;
/// let rule = Default::default();
/// let noise = Some(NoiseTerms { fields, seed: 1, path: 0, rule, interval: None, bound: None });
/// let spin = FormulaSystem::new(SystemAlgebra::named("so(3)")?, "-Pi3", &Default::default())?;
/// let model = OpenSystem::new(spin, OpenTerms { damping, noise, ..OpenTerms::default() }, 0.1)?;
/// let method = model.method("collective".parse()?, "implicit-midpoint".parse()?, 0.0)?;
/// let pace = Pace { schedule: Schedule::new(0.1, 4.0)?, every: 40 };
/// let run = Experiment { model, start: vec![1.0, 0.0, 0.0], method, pace, attitude: false };
/// let paths = PathEnsemble { paths: 400, quantiles: vec![0.5] };
/// let last = paths.follow(&run, |_| true)?.ok_or("interrupted")?.pop().ok_or("no row")?;
/// let s3 = &last.quantities[2];
/// assert!((s3.mean - (1.0 / 2.0_f64.tanh() - 0.5)).abs() < 4.0 * s3.error && s3.error < 0.03);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PathEnsemble {
    /// The number of paths, at least 2.
    pub paths: u64,
    /// The probabilities of the quantiles, between 0 and 1.
    pub quantiles: Vec<f64>,
}

/// The statistics of the paths at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct PathRow {
    /// The time, s.
    pub time: f64,
    /// The statistics of each coordinate, and then of each conserved quantity that has a column.
    pub quantities: Vec<PathStatistics>,
}

/// The statistics of a quantity over the paths.
#[derive(Clone, Debug, PartialEq)]
pub struct PathStatistics {
    /// The mean.
    pub mean: f64,
    /// The standard error of the mean.
    pub error: f64,
    /// The standard deviation of the quantity.
    pub deviation: f64,
    /// The estimated quantiles, in the order of their probabilities.
    pub quantiles: Vec<f64>,
}

/// What is known of a number of each path so far.
#[derive(Clone)]
struct Streamed {
    variance: Variance,
    quantiles: Vec<Quantile>,
}

impl Streamed {
    fn add(&mut self, x: f64) {
        self.variance.add(x);
        self.quantiles.iter_mut().for_each(|quantile| quantile.add(x));
    }

    fn statistics(&self) -> PathStatistics {
        PathStatistics {
            mean: self.variance.mean(),
            error: self.variance.error(),
            deviation: self.variance.sample_variance().sqrt(),
            quantiles: self.quantiles.iter().map(Quantile::quantile).collect(),
        }
    }
}

impl PathEnsemble {
    /// Follows the paths, and returns a row for each moment that is [written](crate::Pace::keeps). `advance` is told how many paths
    /// are done, and may end it: then there are no rows.
    ///
    /// # Errors
    /// Returns [`RunFailure::NoPaths`] if the model has no noise, there are fewer than two paths, or a probability is not between 0
    /// and 1; [`RunFailure::LargeEnsemble`] if rows and columns are too many; and [`RunFailure::Path`] with the number of the first path
    /// that fails.
    pub fn follow(
        &self,
        run: &Experiment,
        mut advance: impl FnMut(u64) -> bool,
    ) -> Result<Option<Vec<PathRow>>, RunFailure> {
        let (rows, width) = self.require_sane(run)?;
        let quantiles = self.quantiles.iter().map(|p| Quantile::new(*p)).collect();
        let one = Streamed { variance: Variance::new(), quantiles };
        let mut all = vec![one; rows * width];
        let mut times = Vec::new();
        // All paths have one integrator, and one lift of the start.
        let (integrator, start) = run.begin()?;
        let state = integrator.start(&start).map_err(RunError::from)?;
        let path_of = |path| follow_path(run, &integrator, (state.clone(), start.clone()), path);
        let together = (MOST_WAITING / (all.len() as u64).max(1)).clamp(1, MOST_TOGETHER);
        let first = run.model.noise().map_or(0, |(_, first)| first);
        let mut done = 0;
        while done < self.paths {
            let next = done.saturating_add(together).min(self.paths);
            let paths: Vec<_> = (done..next).into_par_iter().map(path_of).collect();
            for (path, numbers) in (done..next).zip(paths) {
                let path = first.saturating_add(path);
                let failed = |reason| RunFailure::Path { path, reason: Box::new(reason) };
                let (at, numbers) = numbers.map_err(failed)?;
                times = at;
                all.iter_mut().zip(numbers).for_each(|(streamed, x)| streamed.add(x));
            }
            done = next;
            if !advance(done) {
                return Ok(None);
            }
        }
        let rows = times.into_iter().zip(all.chunks(width));
        let row = |(time, row): (f64, &[Streamed])| PathRow {
            time,
            quantities: row.iter().map(Streamed::statistics).collect(),
        };
        Ok(Some(rows.map(row).collect()))
    }

    /// Checks what is asked for, and returns the numbers of rows and of columns.
    ///
    /// # Errors
    /// As [`follow`](Self::follow), without the paths.
    pub fn require_sane(&self, run: &Experiment) -> Result<(usize, usize), RunFailure> {
        let reason = match (run.model.noise(), self.paths, run.attitude) {
            (None, ..) => Some("a motion without noise has one path".to_owned()),
            (_, 0 | 1, _) => Some(format!("statistics need 2 paths or more, got {}", self.paths)),
            (Some((_, first)), paths, _) if first.saturating_add(paths) > OpenSystem::PATHS => {
                let most = OpenSystem::PATHS;
                Some(format!(
                    "the numbers of paths must be below {most}, {paths} from {first} on are not"
                ))
            }
            (.., true) => Some("paths have no statistics of attitudes".into()),
            _ => {
                let wrong = self.quantiles.iter().find(|p| !(**p > 0.0 && **p < 1.0));
                wrong.map(|p| format!("the probability of a quantile is between 0 and 1, got {p}"))
            }
        };
        if let Some(reason) = reason {
            return Err(RunFailure::NoPaths { reason });
        }
        let columns = run.model.columns().len() + run.conserved().len();
        let numbers = run.pace.rows().saturating_mul(columns as u64);
        match numbers <= MOST_NUMBERS {
            true => Ok((run.pace.rows() as usize, columns)),
            false => Err(RunFailure::LargeEnsemble { numbers, most: MOST_NUMBERS }),
        }
    }
}

/// Returns the times of the rows of a path, and their numbers without the times.
fn follow_path(
    run: &Experiment,
    integrator: &AnyIntegrator,
    (mut state, start): (AnyState, AnyState),
    path: u64,
) -> Result<(Vec<f64>, Vec<f64>), RunFailure> {
    run.model.move_path(state.as_mut_slice(), path);
    let (mut times, mut numbers) = (Vec::new(), Vec::new());
    run.follow_state(integrator, (state, start), |moment: &Moment<'_>| {
        if let Some((time, row)) = moment.row.split_first() {
            times.push(*time);
            numbers.extend_from_slice(row);
        }
    })?;
    Ok((times, numbers))
}
