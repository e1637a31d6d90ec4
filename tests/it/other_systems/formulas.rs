//! Hamiltonians from text in integrators, and the Casimirs of all small algebras.

use collective_integrators::{Collective, Direct, HamiltonianField, LiftFree, RungeKutta, Start};
use heavytop::{HeavyTop, SpinorRealisation};
use lie_poisson::{LiePoisson, Momentum, PoissonSpace, Se3, Se3Dual, StructureConstants, Vector};
use lie_poisson_formulas::{
    FormulaHamiltonian, NamedAlgebra, Parameters, Vocabulary, find_casimirs,
};
use momentum_map::DualQuaternions;
use std::collections::BTreeMap;
use std::error::Error;
use workspace_tests::low_dimensional::{Check, Entry, every_algebra, samples, table};
use workspace_tests::tops;

/// Returns the energy of a top as a formula.
fn formula(top: &HeavyTop) -> Result<FormulaHamiltonian<Se3>, Box<dyn Error>> {
    let parameters = Parameters::new()
        .vector("I", top.inertia().as_slice())?
        .number("mgl", top.weight_moment())?
        .vector("c", top.center_of_mass().as_slice())?;
    let names = Vocabulary::of(&Se3::default(), &parameters)?;
    let text = "½*(Π₁²/I₁ + Π₂²/I₂ + Π₃²/I₃) + mgl*c·Γ";
    Ok(FormulaHamiltonian::new(text, &names)?)
}

/// Returns the largest difference of two trajectories of 200 steps.
fn difference<I, J>(first: &I, second: &J) -> Result<f64, Box<dyn Error>>
where
    I: Start<Momentum = Se3Dual>,
    J: Start<Momentum = Se3Dual>,
{
    let start = tops::generic_start();
    let pairs = first.trajectory(&start, 0.05)?.zip(second.trajectory(&start, 0.05)?);
    let mut largest: f64 = 0.0;
    for (a, b) in pairs.take(200) {
        largest = largest.max((a?.momentum - b?.momentum).max_abs());
    }
    Ok(largest)
}

/// Rounding errors of the energy and of the stage equations grow along 10 s of a top without chaos.
const TOLERANCE: f64 = 1e-11;

#[test]
fn a_top_of_a_formula_moves_as_the_top() -> Result<(), Box<dyn Error>> {
    let top = tops::generic()?;
    let h = formula(&top)?;
    let gauss = || RungeKutta::gauss(2);
    let lifted = Collective::new(gauss()?, SpinorRealisation, h.clone());
    assert!(difference(&lifted, &Collective::new(gauss()?, SpinorRealisation, top))? < TOLERANCE);
    let free = LiftFree::new(gauss()?, DualQuaternions, h.clone());
    assert!(difference(&free, &LiftFree::new(gauss()?, DualQuaternions, top))? < TOLERANCE);
    let space = LiePoisson::minus(Se3::default());
    let direct = Direct::new(gauss()?, HamiltonianField { space, hamiltonian: h.clone() });
    let by_hand = Direct::new(gauss()?, HamiltonianField { space, hamiltonian: top });
    assert!(difference(&direct, &by_hand)? < TOLERANCE);
    // Negative control: another top moves differently.
    let other = LiftFree::new(gauss()?, DualQuaternions, tops::paper()?);
    assert!(difference(&free, &other)? > 0.01);
    Ok(())
}

/// Compares the number of Casimirs with the numerical rank of the Poisson tensor, and lists those found.
struct Casimirs {
    found: BTreeMap<&'static str, (Vec<String>, usize)>,
}

impl Check for Casimirs {
    fn check<const N: usize>(&mut self, entry: &Entry) {
        let algebra: StructureConstants<N> = table(entry, 1.0).unwrap();
        let coordinates = algebra.coordinates().unwrap();
        let casimirs = find_casimirs(&algebra, &coordinates).unwrap();
        let mu: Momentum<StructureConstants<N>> = samples(1)[0];
        let tensor = LiePoisson::minus(algebra).poisson_tensor::<f64>(&mu);
        // Constants and coordinates are of order 1, and ranks far from the next one.
        assert_eq!(casimirs.independent(), N - tensor.rank(1e-9), "{}", entry.name);
        let texts = casimirs.formulas().iter().map(ToString::to_string).collect();
        self.found.insert(entry.name, (texts, casimirs.missing()));
    }
}

/// Source: Patera, Sharp, Winternitz & Zassenhaus 1976, table I. The invariants of the nilpotent algebras (A3,1, A4,1,
/// A5,1 to A5,6) and of the simple ones (A3,8, A3,9) are polynomials.
#[test]
fn casimirs_of_every_small_algebra() {
    let mut casimirs = Casimirs { found: BTreeMap::new() };
    assert_eq!(every_algebra(&mut casimirs), casimirs.found.len());
    for (name, found) in [
        ("A2,1", &[][..]),
        ("A3,1", &["mu1"]),
        ("A3,8", &["mu1*mu3 + mu2^2"]),
        ("A3,9", &["|mu|^2"]),
        ("A4,1", &["mu1", "mu1*mu3 - mu2^2/2"]),
        ("A4,8", &["mu1", "mu1*mu4 - mu2*mu3"]),
        ("A4,10", &["mu1", "mu1*mu4 + mu2^2/2 + mu3^2/2"]),
        ("A5,1", &["mu1", "mu2", "mu1*mu4 - mu2*mu3"]),
        ("A5,2", &["mu1", "mu1*mu3 - mu2^2/2", "mu1^2*mu4 - mu1*mu2*mu3 + mu2^3/3"]),
        ("A5,3", &["mu1", "mu2", "mu1*mu4 - mu2*mu5 - mu3^2/2"]),
        ("A5,4", &["mu1"]),
        ("A5,5", &["mu1"]),
        ("A5,6", &["mu1"]),
        ("A5,40", &["mu1*mu4^2 - mu2*mu4*mu5 - mu3*mu5^2"]),
    ] {
        let texts: Vec<String> = found.iter().map(|text| (*text).to_owned()).collect();
        assert_eq!(casimirs.found[name], (texts, 0), "{name}");
    }
    // The rates of mu1 and mu4 are 1 and −2/5 here; its other invariants are quotients of powers.
    assert_eq!(casimirs.found["A5,9"], (vec!["mu1^2*mu4^5".to_owned()], 2));
    // The invariants of these are not polynomials: x e^(−y/x), and quotients of powers.
    for (name, missing) in [("A3,2", 1), ("A3,3", 1), ("A3,7", 1), ("A4,4", 2)] {
        assert_eq!(casimirs.found[name], (Vec::new(), missing), "{name}");
    }
}
