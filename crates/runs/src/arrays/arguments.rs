//! Numbers by name, as many as there are: [`Arguments`].

use lie_poisson_formula_systems::{FormulaSystemError, Parameter, require_parameters};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// The largest seed, up to which a number of a configuration is exact.
const MOST_SEED: usize = 1_000_000_000_000_000;

/// Numbers and lists of numbers by name, from which a system of arrays and its start are made. A list may have millions.
///
/// # Example
/// ```
/// use lie_poisson_runs::Arguments;
/// let given = Arguments::new().number("exchange", 1.0).list("shape", vec![4.0, 4.0]);
/// assert!(given != Arguments::new());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arguments(BTreeMap<String, Argument>);

/// A number, or a list.
#[derive(Clone, Debug, PartialEq)]
struct Argument {
    values: Vec<f64>,
    is_list: bool,
}

impl Arguments {
    /// Creates it without any.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a number, or replaces what has this name.
    #[must_use]
    pub fn number(mut self, name: &str, value: f64) -> Self {
        self.0.insert(name.into(), Argument { values: vec![value], is_list: false });
        self
    }

    /// Adds a list of numbers, or replaces what has this name.
    #[must_use]
    pub fn list(mut self, name: &str, values: Vec<f64>) -> Self {
        self.0.insert(name.into(), Argument { values, is_list: true });
        self
    }
}

/// The values of all parameters of a system, those with a default too.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'a> {
    kind: &'static str,
    table: &'static [Parameter],
    arguments: &'a Arguments,
}

impl<'a> Given<'a> {
    /// Checks that what is given are these parameters of a kind of system.
    ///
    /// # Errors
    /// If one is missing, unknown, of another shape or not finite.
    pub(super) fn new(
        (kind, is_start): (&'static str, bool),
        table: &'static [Parameter],
        arguments: &'a Arguments,
    ) -> Result<Self, FormulaSystemError> {
        let shape = |argument: &Argument| argument.is_list.then_some(argument.values.len());
        let shapes: Vec<_> = arguments.0.iter().map(|(name, own)| (&**name, shape(own))).collect();
        require_parameters((kind, is_start), table, &shapes)?;
        for (name, argument) in &arguments.0 {
            let own = table.iter().find(|own| own.name == name);
            let odd = argument.values.iter().find(|value| !value.is_finite());
            if let (Some(own), Some(value)) = (own, odd) {
                let needed = format!("finite, got {value}");
                return Err(FormulaSystemError::KindValue { kind, name: own.name, needed });
            }
        }
        Ok(Self { kind, table, arguments })
    }

    /// Returns the error of a parameter that is not what it must be.
    pub(super) fn refused(&self, name: &'static str, needed: String) -> FormulaSystemError {
        FormulaSystemError::KindValue { kind: self.kind, name, needed }
    }

    /// Returns whether a parameter is given, be it the default.
    pub(super) fn has(&self, name: &str) -> bool {
        self.arguments.0.contains_key(name)
    }

    /// Checks that what one parameter gives is not given by others, too.
    ///
    /// # Errors
    /// If it is.
    pub(super) fn require_alone(
        &self,
        name: &'static str,
        others: &[&'static str],
    ) -> Result<(), FormulaSystemError> {
        match others.iter().find(|other| self.has(other)) {
            Some(other) => Err(self.refused(other, format!("left out beside {name}"))),
            None => Ok(()),
        }
    }

    /// Returns the numbers of a parameter.
    pub(super) fn values(&self, name: &str) -> &'a [f64] {
        let default = || self.table.iter().find(|own| own.name == name)?.default;
        let given = self.arguments.0.get(name).map(|argument| argument.values.as_slice());
        given.or_else(default).unwrap_or_default()
    }

    /// Returns a parameter that is a number.
    pub(super) fn number(&self, name: &str) -> f64 {
        self.values(name).first().copied().unwrap_or(f64::NAN)
    }

    /// Returns a parameter that is a vector.
    pub(super) fn vector(&self, name: &str) -> Vector3<f64> {
        let values = self.values(name);
        Vector3::from_fn(|i, _| values.get(i).copied().unwrap_or(f64::NAN))
    }

    /// Returns the seed of a random start.
    ///
    /// # Errors
    /// If it is no whole number.
    pub(super) fn seed(&self) -> Result<u64, FormulaSystemError> {
        Ok(self.whole("seed", [0, MOST_SEED])? as u64)
    }

    /// Returns a parameter that is a whole number in a range.
    ///
    /// # Errors
    /// If it is not.
    pub(super) fn whole(
        &self,
        name: &'static str,
        [least, most]: [usize; 2],
    ) -> Result<usize, FormulaSystemError> {
        whole(self.number(name), [least, most]).ok_or_else(|| {
            let found = self.number(name);
            self.refused(name, format!("a whole number from {least} to {most}, got {found}"))
        })
    }
}

/// Returns a number as a whole number in a range, if it is one.
pub(super) fn whole(value: f64, [least, most]: [usize; 2]) -> Option<usize> {
    let is_in = value.fract() == 0.0 && value >= least as f64 && value <= most as f64;
    is_in.then_some(value as usize)
}
