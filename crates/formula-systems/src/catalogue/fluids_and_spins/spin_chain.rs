//! A chain of classical spins.

use crate::algebras::system_algebra::SystemAlgebra;
use crate::catalogue::parameter::Parameter;
use crate::catalogue::system_kind::{Description, Given, KindError, SystemKind};

/// A Heisenberg chain of N classical spins with the anisotropy K along the third axis in a field B, with the plus bracket
/// {s_a, s_b} = ε_abc s_c of each spin:
///
/// ```text
/// h = −J Σ_i s_i·sᵢ₊₁ − K Σ_i s_i₃² − B·Σ_i s_i,    ds_i/dt = ∂h/∂s_i × s_i
/// ```
///
/// A periodic chain has the bond of the last spin with the first, too. Spins, J, K and B are numbers without units. The
/// Casimirs are |s_i|².
///
/// Source: M. Lakshmanan, Phil. Trans. R. Soc. A 369 (2011), §4.
pub(in crate::catalogue) const SPIN_CHAIN: SystemKind = SystemKind {
    name: "spin-chain",
    about: "classical spins in a row",
    parameters: &[
        Parameter::number("spins", "how many there are, at least 2"),
        Parameter::number("exchange", "J of neighbours; positive for a ferromagnet"),
        Parameter::number("anisotropy", "K; positive for an easy axis").or(&[0.0]),
        Parameter::vector("field", 3, "B").or(&[0.0, 0.0, 0.0]),
        Parameter::number("periodic", "1 for a ring, 0 for open ends").or(&[1.0]),
    ],
    describe,
    orbit: None,
    directions: &[],
    start: None,
};

fn describe(given: &Given<'_>) -> Result<Description, KindError> {
    let (count, periodic) = (given.number("spins"), given.number("periodic"));
    let most = SystemAlgebra::MOST_DIMENSIONS / 3;
    if count.fract() != 0.0 || !(2.0..=most as f64).contains(&count) {
        let needed = format!("a whole number from 2 to {most}, got {count}; spin-lattice has more");
        return Err(KindError::Value("spins", needed));
    }
    let closed = match periodic {
        0.0 => String::new(),
        1.0 => format!(" + S[{count}]·S[1]"),
        other => return Err(KindError::Value("periodic", format!("0 or 1, got {other}"))),
    };
    let mut hamiltonian = format!("-exchange*(sum(S[i]·S[i+1]){closed})");
    for (name, text) in [("anisotropy", "anisotropy*sum(S[i][3]^2)"), ("field", "field·sum(S[i])")]
    {
        if given.values(name).iter().any(|x| *x != 0.0) {
            hamiltonian = format!("{hamiltonian} - {text}");
        }
    }
    Ok(Description {
        algebra: SystemAlgebra::named(&format!("so(3)^{count}"))?.with_symbols(&["S"])?,
        hamiltonian,
        parameters: given.parameters(&["exchange", "anisotropy", "field"])?,
        has_plus_bracket: true,
    })
}
