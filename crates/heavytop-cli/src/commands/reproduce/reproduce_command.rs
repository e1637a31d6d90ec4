//! The command `reproduce`: the paper's experiment (Ohsawa 2019, §5.2), its figures and its tables.

use super::deviations::{Deviations, Reproduction};
use super::record::{QUANTITIES, Record};
use super::{figures, plot};
use crate::configuration::{Config, Integration};
use crate::errors::Error;
use crate::files::place::require_folder;
use crate::files::{Kind, Output, OutputSet};
use crate::formats::run_table::{STATE_COLUMNS, append_row, state_values};
use crate::pictures::render;
use crate::runs::{Experiment, TopInAxes};
use crate::supervision::{Progress, Watch};
use heavytop::methods::{Formulation, SchemeName};
use std::io::Write;
use std::path::Path;

/// The four integrators, in the order of the tables.
const METHODS: [(Formulation, SchemeName); 4] = [
    (Formulation::Collective, SchemeName::ImplicitMidpoint),
    (Formulation::Collective, SchemeName::ExplicitMidpoint),
    (Formulation::Direct, SchemeName::ExplicitMidpoint),
    (Formulation::Direct, SchemeName::ImplicitMidpoint),
];

/// How the tables are recognised.
const TRAJECTORIES: Kind<'_> =
    Kind::of_first_bytes("table of reproduce", b"formulation,scheme,t,Pi1,Pi2,Pi3,Gamma1,");
const SUMMARY: Kind<'_> =
    Kind::of_first_bytes("table of reproduce", b"formulation,scheme,step,end,h,f1,f2,K\n");

/// The number of pixels per CSS pixel: 576 dots per inch at the figures' own size.
const SCALE: f32 = 6.0;

/// Runs the paper's top with the four integrators and writes figures and tables into the folder
/// `out`.
///
/// # Errors
/// If the request is wrong, another run writes into the folder, or the command is stopped: then nothing is written.
/// If a run fails, or a file cannot be written: then `trajectories.csv.partial` is kept, and no other file is written.
///
/// # Example
/// ```
/// let folder = tempfile::tempdir()?;
/// let (step, end, watch) = (0.02, 1.0, heavytop_cli::supervision::Watch::default());
/// let done = heavytop_cli::commands::reproduce::reproduce(folder.path(), step, end, &watch)?;
/// assert!(done.runs[0].f1 < 1e-14 && done.runs[1].f1 > 1e-6);
/// assert!(folder.path().join("fig1a.svg").exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reproduce(
    out: &Path,
    step: f64,
    end: f64,
    watch: &Watch<'_>,
) -> Result<Reproduction, Error> {
    for (name, value) in [("step", step), ("end", end)] {
        if !(value > 0.0 && value.is_finite()) {
            // The figures are those of the paper, which go forward.
            return Err(Error::OutOfRange { name, range: "positive and finite", value });
        }
    }
    let mut config = Config::default();
    let mut experiments = Vec::with_capacity(METHODS.len());
    for (formulation, scheme) in METHODS {
        let own = Integration::default();
        config.integrator = Integration { formulation, scheme, step, end, ..own }.into();
        experiments.push(config.experiment()?);
    }
    require_replaceable(out, watch)?;
    std::fs::create_dir_all(out).map_err(|source| Error::Create { path: out.into(), source })?;

    // No other run writes here until the table has its name, which it gets last.
    let mut trajectories = Output::create(&out.join("trajectories.csv"))?;
    let mut others = OutputSet::default();
    let outcome = run(&experiments, &mut trajectories, watch);
    let written = outcome.and_then(|records| write_figures_and_summary(&records, out, &mut others));
    others.conclude(trajectories, written)
}

/// Checks that the files of the command may be written.
fn require_replaceable(out: &Path, watch: &Watch<'_>) -> Result<(), Error> {
    require_folder(out)?;
    for name in figures::names() {
        let [svg, png] = ["svg", "png"].map(|ending| format!("{name}.{ending}"));
        watch.safeguard.require_all(out, &[(&svg, &render::SVG), (&png, &render::PNG)])?;
    }
    let tables = [("summary.csv", &SUMMARY), ("trajectories.csv", &TRAJECTORIES)];
    watch.safeguard.require_all(out, &tables)
}

fn write_figures_and_summary(
    records: &[Record],
    out: &Path,
    files: &mut OutputSet,
) -> Result<Reproduction, Error> {
    for figure in figures::all(records) {
        let (svg, png) = render::render(&plot::plot(&figure)?, SCALE)?;
        files.add(&out.join(figure.name).with_extension("svg"), svg.as_bytes())?;
        files.add(&out.join(figure.name).with_extension("png"), &png)?;
    }
    let runs = records.iter().map(Deviations::of).collect();
    let reproduction = Reproduction { out: out.into(), runs };
    files.add(&out.join("summary.csv"), reproduction.csv().as_bytes())?;
    Ok(reproduction)
}

/// Runs all experiments; writes every state, and records what the figures and tables need.
fn run(
    experiments: &[Experiment<TopInAxes>],
    trajectories: &mut Output,
    watch: &Watch<'_>,
) -> Result<Vec<Record>, Error> {
    let names = QUANTITIES.map(heavytop::Invariant::symbol).join(",");
    trajectories.write(|to| writeln!(to, "formulation,scheme,{STATE_COLUMNS},{names}"))?;
    experiments
        .iter()
        .map(|experiment| {
            let mut record = Record::new(experiment);
            let method = &experiment.method;
            let (formulation, scheme) = (method.formulation().name(), method.scheme().name());
            let progress = Progress::new(experiment, watch.quiet);
            experiment.run(|step, time, mu, _| {
                watch.require_going()?;
                progress.at(step);
                let values = QUANTITIES.map(|quantity| quantity.value(&experiment.model.top, mu));
                record.add(step, time, values);
                let mut line = format!("{formulation},{scheme},").into_bytes();
                append_row(&mut line, &[&state_values(time, mu)[..], &values].concat());
                trajectories.write(|to| to.write_all(&line))
            })?;
            Ok(record)
        })
        .collect()
}
