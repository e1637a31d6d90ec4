//! Errors of systems by formula that are driven, damped, noisy or forced.

use super::refused;
use collective_integrators::NoiseRule;
use lie_poisson::{InnerProduct, InputTable, Interpolation, IsotropicNoise};
use lie_poisson_formula_systems::{
    Damping, FormulaSystem, FormulaSystemError, NamedInputs, NoiseFields, NoiseTerms, OpenNames,
    OpenSystem, OpenTerms, SystemAlgebra,
};
use lie_poisson_formulas::Parameters;

/// Returns the errors of names, formulas and terms.
pub fn errors() -> Vec<String> {
    let algebra = |name| SystemAlgebra::named(name).unwrap();
    let table = InputTable::new(vec![0.0, 1.0], vec![0.0, 1.0], Interpolation::Linear).unwrap();
    let inputs = |name: &str| NamedInputs::new(vec![(name.into(), table.clone())]);
    let names = |algebra, inputs| OpenNames::new(algebra, &inputs, Parameters::new());
    let none = NamedInputs::default;
    let spin = names(algebra("so(3)"), none()).unwrap();
    let top = names(algebra("se(3)"), none()).unwrap();
    let base = FormulaSystem::new(algebra("so(3)"), "Pi3", &Parameters::new()).unwrap();
    let open = |terms| OpenSystem::new(base.clone(), terms, 0.1);
    let damped = |friction, inner_product| {
        let damping = Some(Damping::DoubleBracket { friction, inner_product });
        OpenTerms { damping, ..OpenTerms::default() }
    };
    let noise = |strength, bound| {
        let inner_product = InnerProduct::euclidean();
        let fields = NoiseFields::Isotropic(IsotropicNoise { inner_product, strength });
        let (rule, interval) = (NoiseRule::Together, None);
        Some(NoiseTerms { fields, seed: 1, path: 0, rule, interval, bound })
    };
    let noisy =
        |strength, bound| OpenTerms { noise: noise(strength, bound), ..OpenTerms::default() };
    let drive = Some(vec![spin.formula("drive", "1").unwrap()]);
    let plane = InnerProduct::new(&[1.0, 0.0, 0.0, 1.0]).unwrap();
    let numbered = |path, interval| {
        let noise = noise(1.0, None).map(|noise| NoiseTerms { path, interval, ..noise });
        open(OpenTerms { noise, ..OpenTerms::default() })
    };
    let thermal =
        NoiseFields::thermal(damped(1.0, InnerProduct::euclidean()).damping.as_ref(), 0.5);
    let back = noise(1.0, None).map(|noise| NoiseTerms { fields: thermal.unwrap(), ..noise });
    let back = OpenTerms { noise: back, ..damped(1.0, InnerProduct::euclidean()) };
    let timed = Parameters::new().number("t", 1.0).unwrap();
    let vertical = top.clone().with_directions(&["Gamma"]);
    let on_vertical = vec![top.formula("torque", "1").unwrap(); 6];
    vec![
        refused(OpenNames::new(algebra("so(3)"), &none(), timed)),
        refused(numbered(OpenSystem::PATHS, None)),
        refused(numbered(0, Some(1e-6))),
        refused(names(algebra("so(3)"), inputs("Pi1"))),
        refused(inputs("u").require_until(2.0)),
        refused(spin.formula("torque Pi1", "Pj")),
        refused(open(OpenTerms { drive, ..OpenTerms::default() })),
        refused(spin.element("torque", [("P", vec!["1".into()])])),
        refused(spin.inner_product(Some(&[1.0; 9]))),
        refused(top.inner_product(None)),
        refused(open(damped(1.0, plane))),
        refused(open(damped(-1.0, InnerProduct::euclidean()))),
        refused(open(noisy(1.0, Some(0.5)))),
        refused(open(noisy(-1.0, None))),
        refused(NoiseFields::thermal(None, 1.0)),
        refused(NoiseFields::thermal(Some(&Damping::Gilbert(0.0)), 1.0)),
        refused(OpenSystem::new(base.clone(), back, -0.1)),
        refused(top.require_spins()),
        refused(vertical.require_torque(&on_vertical)),
        refused(open(damped(-1.0, InnerProduct::euclidean())).map_err(FormulaSystemError::from)),
    ]
}
