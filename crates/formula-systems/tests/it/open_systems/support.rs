//! Open systems from texts.

use collective_integrators::{AnyState, NoiseRule, Start};
use heavytop::methods::Method;
use lie_poisson::{InnerProduct, InputTable};
use lie_poisson_formula_systems::{
    Damping, FormulaSystemError, NamedInputs, NoiseFields, NoiseTerms, OpenNames, OpenSystem,
    OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;

/// What opens a system, as texts.
#[derive(Clone, Default)]
pub struct Texts {
    pub inputs: Vec<(&'static str, InputTable)>,
    pub drive: Option<Vec<&'static str>>,
    pub friction: Option<f64>,
    pub gilbert: Option<f64>,
    pub product: Option<Vec<f64>>,
    pub noise: Option<Vec<Vec<&'static str>>>,
    pub temperature: Option<f64>,
    pub rule: NoiseRule,
    pub torque: Option<Vec<&'static str>>,
}

/// Returns the open system of an algebra and a Hamiltonian, for steps of a size.
pub fn open(
    algebra: &str,
    hamiltonian: &str,
    texts: &Texts,
    step: f64,
) -> Result<OpenSystem, FormulaSystemError> {
    let algebra = SystemAlgebra::named(algebra)?;
    let inputs = texts.inputs.iter().map(|(name, table)| ((*name).to_owned(), table.clone()));
    let inputs = NamedInputs::new(inputs.collect());
    let names = OpenNames::new(algebra, &inputs, Parameters::new())?;
    let (base, hamiltonian) = names.system(hamiltonian)?;
    let all = |what: &str, texts: &Vec<&str>| -> Result<Vec<_>, FormulaSystemError> {
        Ok(texts.iter().map(|text| names.formula(what, text)).collect::<Result<_, _>>()?)
    };
    let product = texts
        .product
        .as_deref()
        .map_or(Ok(InnerProduct::euclidean()), |rows| names.inner_product(Some(rows)))?;
    let bracket = |friction| Damping::DoubleBracket { friction, inner_product: product.clone() };
    let damping = texts.friction.map(bracket).or(texts.gilbert.map(Damping::Gilbert));
    let fields = match (&texts.noise, texts.temperature) {
        (Some(fields), _) => {
            let fields =
                fields.iter().map(|field| all("noise", field)).collect::<Result<_, _>>()?;
            Some(NoiseFields::Formulas(fields))
        }
        (None, Some(temperature)) => Some(NoiseFields::thermal(damping.as_ref(), temperature)?),
        (None, None) => None,
    };
    let rule = texts.rule;
    let noise = fields.map(|fields| NoiseTerms {
        fields,
        seed: 1,
        path: 0,
        rule,
        interval: None,
        bound: None,
    });
    let drive = texts.drive.as_ref().map(|texts| all("drive", texts)).transpose()?;
    let torque = texts.torque.as_ref().map(|texts| all("torque", texts)).transpose()?;
    let terms = OpenTerms { inputs, hamiltonian, drive, damping, noise, torque };
    Ok(OpenSystem::new(base.with_found_casimirs()?, terms, step)?)
}

/// Returns a method of an open system.
pub fn method(system: &OpenSystem, formulation: &str, scheme: &str) -> Method {
    system.method(formulation.parse().unwrap(), scheme.parse().unwrap(), 0.0).unwrap()
}

/// Returns the momentum after some steps.
pub fn after(
    system: &OpenSystem,
    names: (&str, &str),
    start: &[f64],
    step: f64,
    steps: u64,
) -> Vec<f64> {
    let integrator = system.tangent_integrator(&method(system, names.0, names.1), start).unwrap();
    integrator
        .after(&AnyState::from_slice(start), step, steps)
        .unwrap()
        .momentum
        .as_slice()
        .to_vec()
}

/// Returns the largest difference of two momenta.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
