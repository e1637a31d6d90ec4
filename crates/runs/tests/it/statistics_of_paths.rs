//! Ensembles of paths.

use crate::support::{experiment, noisy, pace};
use lie_poisson_runs::{Experiment, Model, PathEnsemble, RunFailure};

/// The statistics are those of the paths, each of which is the run on its path.
#[test]
fn statistics_are_those_of_the_runs_one_by_one() {
    let run = noisy("so(3)", "-Pi3", pace(0.1, 2.0, 5));
    let paths = PathEnsemble { paths: 40, quantiles: vec![0.25, 0.5] };
    let found = paths.follow(&run, |_| true).unwrap().unwrap();
    let mut rows: Vec<Vec<Vec<f64>>> = Vec::new();
    for path in 0..40 {
        let one = Experiment { model: run.model.clone().on_path(path), ..run.clone() };
        let mut all = Vec::new();
        one.follow(None, |moment| {
            if !moment.row.is_empty() {
                all.push(moment.row.to_vec());
            }
            Ok::<_, RunFailure>(())
        })
        .unwrap();
        rows.push(all);
    }
    assert_eq!((found.len(), rows[0].len()), (5, 5));
    for (place, row) in found.iter().enumerate() {
        assert_eq!(row.time, rows[0][place][0]);
        for (column, statistics) in row.quantities.iter().enumerate() {
            let mut values: Vec<f64> = rows.iter().map(|rows| rows[place][column + 1]).collect();
            let mean = values.iter().sum::<f64>() / 40.0;
            let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 39.0;
            assert!((statistics.mean - mean).abs() < 1e-13, "{column}");
            assert!((statistics.deviation - variance.sqrt()).abs() < 1e-12, "{column}");
            assert!((statistics.error - (variance / 40.0).sqrt()).abs() < 1e-12, "{column}");
            // The estimate of a quantile lies among the values near it.
            values.sort_by(f64::total_cmp);
            assert!(
                values[5] - 1e-13 <= statistics.quantiles[0]
                    && statistics.quantiles[0] <= values[15] + 1e-13
            );
            assert!(
                values[14] - 1e-13 <= statistics.quantiles[1]
                    && statistics.quantiles[1] <= values[25] + 1e-13
            );
        }
    }
    // |Π|² is the same on all, and Π is not.
    let last = &found[4].quantities;
    assert!(last[4].deviation < 1e-13 && last[2].deviation > 0.1);
}

#[test]
fn the_threads_do_not_matter() {
    let run = noisy("so(3)", "-Pi3", pace(0.1, 1.0, 10));
    let paths = PathEnsemble { paths: 600, quantiles: vec![0.9] };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| paths.follow(&run, |_| true).unwrap().unwrap())
    };
    assert_eq!(on(1), on(3));
    // An end that is asked for leaves nothing.
    assert_eq!(paths.follow(&run, |_| false).unwrap(), None);
}

#[test]
fn what_has_no_statistics_is_refused() {
    let top = experiment("collective", "gauss-4", pace(0.1, 1.0, 1));
    let run = noisy("so(3)", "-Pi3", pace(0.1, 1.0, 1));
    let message = |run: &Experiment, quantile: f64| {
        let paths = PathEnsemble { paths: 2, quantiles: vec![quantile] };
        paths.follow(run, |_| true).unwrap_err().to_string()
    };
    assert!(message(&top, 0.5).contains("a motion without noise has one path"));
    for wrong in [0.0, 1.0, -0.5, f64::NAN] {
        assert!(message(&run, wrong).contains(&format!("between 0 and 1, got {wrong}")));
    }
    assert_eq!(run.model.noise(), Some((1, 0)));
}
