//! What drives, damps, shakes or forces a system, as Python passes it.

use super::named_inputs::{require_named, unnamed_inputs};
use super::open_arguments::{Element, InputArgument, NoiseSource, OpenArgument, PathArgument};
use crate::errors::refused;
use crate::formulas::{FormulaSource, expressions};
use collective_integrators::NoiseRule;
use core::ops::Deref;
use lie_poisson::{InnerProduct, InputTable, Interpolation, IsotropicNoise};
use lie_poisson_formula_systems::{
    Damping, FormulaSystem, NamedInputs, NoiseFields, NoiseTerms, OpenNames, OpenSystem,
    OpenSystemError, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::{Formula, Parameters};
use lie_poisson_runs::{
    ArraySystem, ArrayTerms, FluidNoise, FluidTerms, HarmonicShell, LatticeField, LatticeNoise,
    LatticeTerms, Model, NoisePaths, OpenArrays, SpinDamping,
};
use pyo3::exceptions::PyValueError;
use pyo3::{FromPyObject, IntoPyObject, PyErr, PyResult};

/// What is said where a path is asked for and there is no noise.
pub(crate) const WITHOUT_PATH: &str = "path is of systems with noise, and this one has none";

/// Returns the inputs.
///
/// # Errors
/// Returns `ValueError` for a table that is none.
pub(crate) fn inputs(arguments: &[InputArgument]) -> PyResult<NamedInputs> {
    let input = |(name, times, values, between): &InputArgument| {
        let between: Interpolation = between.parse().map_err(refused)?;
        let table = InputTable::new(times.clone(), values.clone(), between);
        let refused_input = |reason| refused(OpenSystemError::Input { name: name.clone(), reason });
        Ok((name.clone(), table.map_err(refused_input)?))
    };
    Ok(NamedInputs::new(arguments.iter().map(input).collect::<PyResult<_>>()?))
}

/// Returns what makes a system an open one.
///
/// # Errors
/// Returns `ValueError` for what does not fit the system.
pub(crate) fn terms(
    names: &OpenNames,
    inputs: NamedInputs,
    hamiltonian: Option<Formula>,
    (_, drive, damping, noise, torque): &OpenArgument,
) -> PyResult<OpenTerms> {
    let all = |element: &Element| -> PyResult<Vec<Formula>> {
        element.iter().map(|source| source.formula(names.vocabulary())).collect()
    };
    let product = |rows: &Option<Vec<f64>>| names.inner_product(rows.as_deref()).map_err(refused);
    let damping = damping.as_ref().map(|(friction, is_gilbert, rows)| {
        let friction = *friction;
        if is_gilbert.is_some() {
            names.require_spins().map_err(refused)?;
        }
        Ok::<_, PyErr>(match is_gilbert {
            Some(true) => Damping::Gilbert(friction),
            // Several spins have one friction, without a choice of units.
            Some(false) => {
                Damping::DoubleBracket { friction, inner_product: InnerProduct::euclidean() }
            }
            None => Damping::DoubleBracket { friction, inner_product: product(rows)? },
        })
    });
    let damping = damping.transpose()?;
    let noise = noise.as_ref().map(|(source, (seed, path, interval, bound), is_alternating)| {
        let fields = match source {
            NoiseSource::Temperature((temperature,)) => {
                NoiseFields::thermal(damping.as_ref(), *temperature).map_err(refused)?
            }
            NoiseSource::Strength(strength, rows) => {
                let (strength, inner_product) = (*strength, product(rows)?);
                NoiseFields::Isotropic(IsotropicNoise { inner_product, strength })
            }
            NoiseSource::Fields(fields) => {
                NoiseFields::Formulas(fields.iter().map(all).collect::<PyResult<_>>()?)
            }
        };
        let rule = if *is_alternating { NoiseRule::Alternating } else { NoiseRule::Together };
        let (interval, bound) = (*interval, *bound);
        Ok::<_, PyErr>(NoiseTerms { fields, seed: *seed, path: *path, rule, interval, bound })
    });
    let noise = noise.transpose()?;
    let (drive, torque) =
        (drive.as_ref().map(all).transpose()?, torque.as_ref().map(all).transpose()?);
    torque.iter().try_for_each(|torque| names.require_torque(torque)).map_err(refused)?;
    Ok(OpenTerms { inputs, hamiltonian, drive, damping, noise, torque })
}

/// Returns the system of a formula without Casimirs, and the formula if it depends on the time or on an input. Of a system without
/// forces there are no inputs.
///
/// # Errors
/// Returns `ValueError` for what is no formula.
pub(crate) fn of_formula(
    algebra: &SystemAlgebra,
    hamiltonian: &FormulaSource,
    given: &Parameters,
    inputs: Option<&NamedInputs>,
) -> PyResult<(FormulaSystem, Option<Formula>)> {
    let names = inputs.map(|inputs| OpenNames::new(algebra.clone(), inputs, given.clone()));
    let names = names.transpose().map_err(refused)?;
    let plain = algebra.vocabulary(given).map_err(refused)?;
    let vocabulary = names.as_ref().map_or(&plain, OpenNames::vocabulary);
    // A formula that is refused is refused here, with its text.
    let formula = hamiltonian.formula(vocabulary)?;
    let traced = match hamiltonian {
        FormulaSource::Text(text) => Err(text),
        FormulaSource::Traced(parts) => Ok(expressions(parts, vocabulary.coordinates())?),
    };
    let made = |parameters: &Parameters| match &traced {
        Err(text) => FormulaSystem::new(algebra.clone(), text, parameters),
        Ok((parts, value)) => {
            FormulaSystem::of_expressions(algebra.clone(), parts, *value, parameters)
        }
    };
    let system = match &names {
        None => made(given).map(|system| (system, None)),
        Some(names) => names.system_by(formula, made),
    };
    system.map_err(refused)
}

/// The least and the largest degree of a shell of harmonics, and the strength of the noise in it.
type ShellArgument = ((usize, usize), f64);

/// What damps, forces and shakes a system of arrays.
#[derive(Clone, FromPyObject, IntoPyObject)]
pub(crate) enum ArrayTermsArgument {
    /// The friction of spins, and whether it is Gilbert's damping; the energy kT, and the paths; and the inputs and the formulas
    /// of a field that depends on the time.
    Lattice(
        Option<(f64, bool)>,
        Option<(f64, PathArgument)>,
        Option<(Vec<InputArgument>, Vec<FormulaSource>)>,
    ),
    /// The viscosity, its power, and the drag of a fluid; rows l, m, re, im of the force; and shells of transport noise
    /// and of stirring, and the paths.
    Fluid(
        (f64, u32, f64),
        Vec<[f64; 4]>,
        Option<(Vec<ShellArgument>, Vec<ShellArgument>, PathArgument)>,
    ),
}

impl ArrayTermsArgument {
    /// Returns the terms.
    ///
    /// # Errors
    /// Returns `ValueError` for an input or a formula that is none.
    pub(crate) fn terms(&self) -> PyResult<ArrayTerms> {
        Ok(match self {
            Self::Lattice(damping, noise, field) => {
                let damping = damping.map(|(friction, is_gilbert)| match is_gilbert {
                    true => SpinDamping::Gilbert(friction),
                    false => SpinDamping::LandauLifshitz(friction),
                });
                let noise = noise
                    .map(|(temperature, path)| LatticeNoise { temperature, paths: paths(path) });
                let field = field.as_ref().map(lattice_field).transpose()?;
                LatticeTerms { field, damping, noise }.into()
            }
            Self::Fluid((viscosity, power, drag), force, noise) => {
                let noise = noise.as_ref().map(|(transport, stirring, path)| FluidNoise {
                    transport: shells(transport),
                    stirring: shells(stirring),
                    paths: paths(*path),
                });
                let (viscosity, power, drag) = (*viscosity, *power, *drag);
                FluidTerms { viscosity, power, drag, force: force.clone(), noise }.into()
            }
        })
    }

    /// Returns the number of the path of the noise, if there is one.
    pub(crate) fn path_mut(&mut self) -> Option<&mut u64> {
        Some(match self {
            Self::Lattice(_, noise, _) => &mut noise.as_mut()?.1.1,
            Self::Fluid(.., noise) => &mut noise.as_mut()?.2.1,
        })
    }
}

/// Returns the field of a lattice by formulas in the time and in inputs.
fn lattice_field(
    (tables, sources): &(Vec<InputArgument>, Vec<FormulaSource>),
) -> PyResult<LatticeField> {
    let inputs = inputs(tables)?;
    let vocabulary = inputs.vocabulary_of_time().map_err(refused)?;
    require_named(&unnamed_inputs(tables, 0, sources.iter()), core::iter::empty())?;
    let formulas = sources.iter().map(|source| source.formula(&vocabulary));
    LatticeField::of_formulas(inputs, formulas.collect::<PyResult<_>>()?).map_err(refused)
}

const fn paths((seed, path, interval, bound): PathArgument) -> NoisePaths {
    NoisePaths { seed, path, interval, bound }
}

fn shells(arguments: &[ShellArgument]) -> Vec<HarmonicShell> {
    let shell = |((least, most), strength): &ShellArgument| HarmonicShell {
        degrees: [*least, *most],
        strength: *strength,
    };
    arguments.iter().map(shell).collect()
}

/// The model of a run: that of a closed system, or of an open one with the step of the run.
pub(crate) enum ModelOfRun<'a> {
    Closed(&'a FormulaSystem),
    Open(Box<OpenSystem>),
    Arrays(&'a ArraySystem),
    OpenArrays(Box<OpenArrays>),
}

impl<'a> ModelOfRun<'a> {
    /// Returns the model of a run with steps of a size.
    ///
    /// # Errors
    /// Returns `ValueError` for terms that do not fit the system.
    pub(crate) fn new(
        system: &'a FormulaSystem,
        terms: Option<&OpenTerms>,
        step: f64,
    ) -> PyResult<Self> {
        let Some(terms) = terms else { return Ok(Self::Closed(system)) };
        let open = OpenSystem::new(system.clone(), terms.clone(), step);
        Ok(Self::Open(Box::new(open.map_err(refused)?)))
    }

    /// Checks that the zeros of a function do not depend on the step: with noise only those of functions of the time alone do not.
    ///
    /// # Errors
    /// Returns `ValueError` for a function of coordinates along a path with noise.
    pub(crate) fn require_zeros(&self, function: &Formula) -> PyResult<()> {
        match self {
            Self::Open(open) if open.noise().is_some() && !open.is_of_time(function) => {
                Err(PyValueError::new_err(
                    "a path with noise passes a value of a function of coordinates again and again in any time, however short, and \
                     where depends on the step: write a function of the time alone, such as \"sin(2*t)\"",
                ))
            }
            _ => Ok(()),
        }
    }

    /// Checks that the inputs reach to the end of a run.
    ///
    /// # Errors
    /// Returns `ValueError`, which names the input.
    pub(crate) fn require_until(&self, end: f64) -> PyResult<()> {
        match self {
            Self::Closed(_) | Self::Arrays(_) => Ok(()),
            Self::Open(open) => open.terms().inputs.require_until(end).map_err(refused),
            Self::OpenArrays(arrays) => {
                arrays.inputs().map_or(Ok(()), |inputs| inputs.require_until(end)).map_err(refused)
            }
        }
    }
}

impl Deref for ModelOfRun<'_> {
    type Target = dyn Model;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Closed(system) => *system,
            Self::Open(open) => &**open,
            Self::Arrays(arrays) => *arrays,
            Self::OpenArrays(arrays) => &**arrays,
        }
    }
}
