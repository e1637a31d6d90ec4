//! The columns of a top in the words of pictures.

use crate::pictures::symbols;
use heavytop::Invariant;
use lie_poisson_runs::TopQuantity;

/// Returns the symbol of the vector in an array, or the name of the array.
pub(super) fn title(array: &str) -> String {
    match array {
        "spatial_momentum" => "RΠ".into(),
        "euler_angles" => "Euler angles".into(),
        _ => symbols::symbol(array),
    }
}

/// Returns the symbol of a column, such as `Π₁` for `Pi1`.
pub(super) fn symbol(column: &str) -> String {
    match column.strip_prefix("spatial_momentum") {
        Some(index) => symbols::symbol(&format!("Pi{index}")).replace('Π', "(RΠ)"),
        None => symbols::symbol(column),
    }
}

/// Returns the unit of an array; it is empty for what is a pure number.
pub(super) fn unit(array: &str) -> &'static str {
    /// The conserved quantities of tops.
    const CONSERVED: [Invariant; 7] = [
        Invariant::Energy,
        Invariant::VerticalSquared,
        Invariant::VerticalMomentum,
        Invariant::AxialMomentum,
        Invariant::Kovalevskaya,
        Invariant::GoryachevChaplygin,
        Invariant::MomentumSquared,
    ];
    let conserved = CONSERVED.iter().find(|quantity| quantity.symbol() == array);
    let requested = TopQuantity::NAMES.iter().map(|(_, quantity)| quantity);
    let mut requested = requested.filter(|quantity| quantity.name().replace('-', "_") == array);
    match array {
        "t" => "s",
        "Pi" => "kg m²/s",
        _ => {
            let unit = conserved.map(|quantity| quantity.unit());
            unit.or_else(|| requested.next().map(|quantity| quantity.unit())).unwrap_or("")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        assert_eq!(["Pi", "Gamma", "height"].map(title), ["Π", "Γ", "height"]);
        let columns = ["Pi1", "Gamma3", "Omega2", "psi", "spatial_momentum3", "kinetic", "f1"];
        let symbols = ["Π₁", "Γ₃", "Ω₂", "ψ", "(RΠ)₃", "kinetic", "f₁"];
        assert_eq!(columns.map(symbol), symbols);
    }

    #[test]
    fn every_column_of_a_top_has_its_unit() {
        let arrays =
            ["t", "Pi", "Gamma", "q", "Omega", "euler_angles", "height", "kinetic", "f3", "K"];
        let units = ["s", "kg m²/s", "", "", "rad/s", "rad", "m", "J", "kg m²/s", "(kg m²/s)⁴"];
        assert_eq!(arrays.map(unit), units);
    }
}
