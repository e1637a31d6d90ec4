//! A column of the archive of a run, and how pictures write it: [`RunColumn`].

use super::top_words;
use crate::commands::plot::run_arrays::RunArrays;
use crate::errors::Error;
use crate::formats::RunTable;
use crate::pictures::caption::plain;
use crate::pictures::symbols::symbol;
use crate::runs::Experiment;

/// A column of the archive of a run.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::commands::plot) struct RunColumn {
    /// The name in tables.
    pub name: String,
    /// The symbol, as the inside of an SVG text.
    pub symbol: String,
    /// The name of the array of the archive.
    pub array: String,
    /// The symbol of the array, as the inside of an SVG text.
    pub title: String,
    /// The shape of a sample of the array.
    pub shape: Vec<usize>,
    /// The place in a sample of the array.
    pub place: usize,
    /// The unit, empty for a pure number; `None` if it is not known, as those of systems by formula.
    pub unit: Option<&'static str>,
}

impl RunColumn {
    /// Returns all columns of a run that the archive has, in the order of its table.
    ///
    /// # Errors
    /// If the columns of the run have no different names.
    pub fn all(run: &RunArrays, experiment: &Experiment) -> Result<Vec<Self>, Error> {
        let table = RunTable::new(experiment, &run.config.output.columns)?;
        let is_top = run.config.system.is_none();
        let header = table.header();
        let names: Vec<&str> = header.split(',').collect();
        let arrays = table.arrays().iter().filter(|array| run.has(&array.name));
        let columns = arrays.flat_map(|array| {
            let names = names.get(array.columns.clone()).unwrap_or_default().iter();
            names.enumerate().map(move |(place, name)| {
                let (title, symbol, unit) = match is_top {
                    true => {
                        let title = top_words::title(&array.name);
                        (title, top_words::symbol(name), Some(top_words::unit(&array.name)))
                    }
                    false if array.name == "t" => ("t".into(), "t".into(), Some("s")),
                    false => (plain(&symbol(&array.name)), plain(&symbol(name)), None),
                };
                let (name, array, shape) =
                    ((*name).into(), array.name.clone(), array.shape.clone());
                Self { name, symbol, array, title, shape, place, unit }
            })
        });
        Ok(columns.collect())
    }

    /// Returns whether the array is a number, and not a vector.
    pub fn is_number(&self) -> bool {
        self.shape.is_empty()
    }

    /// Returns whether the column is an angle that jumps by 2π: φ or ψ of the Euler angles of a top.
    pub fn is_periodic(&self) -> bool {
        self.array == "euler_angles" && self.unit.is_some() && self.place != 1
    }

    /// Returns the symbol or another text, with the unit.
    pub fn with_unit(&self, text: &str) -> String {
        match self.unit {
            None | Some("") => text.into(),
            Some(unit) => format!("{text} ({unit})"),
        }
    }
}
