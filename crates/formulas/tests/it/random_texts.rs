//! Random formulas come back as they were printed; random texts never panic.

use crate::support::heavy_top;
use lie_poisson_formulas::{Formula, Vocabulary};
use proptest::prelude::*;

/// Returns random scalars, written with superfluous parentheses here and there.
fn scalar() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        (0.0..1e6_f64).prop_map(|x| x.to_string()),
        (-300..300_i32).prop_map(|n| format!("3e{n}")),
        Just("½".to_owned()),
        Just("pi".to_owned()),
    ];
    let name = "(Pi1|Π₂|Pi\\[3\\]|Gamma1|k|mgl|Γ₂|I3)";
    let leaf = prop_oneof![number, name.prop_map(String::from)];
    let vector = "(Pi|Gamma|c|Π|(Pi×c)|(Pi - Gamma)|Gamma×c)";
    leaf.prop_recursive(6, 60, 2, move |inner| {
        let pair = (inner.clone(), inner.clone());
        let operator = "( \\+ |-|\\*|/|\\^|\\*\\*| \\* )";
        let function = "(sqrt|exp|ln|log|sin|cos|tan|sinh|cosh|tanh|abs|√|norm|arcsin|arccos|arctan|log10|cbrt)";
        prop_oneof![
            (pair.clone(), operator).prop_map(|((x, y), sign)| format!("{x}{sign}{y}")),
            (pair.clone(), operator).prop_map(|((x, y), sign)| format!("({x}){sign}({y})")),
            pair.clone().prop_map(|(x, y)| format!("atan2({x}, {y})")),
            (pair.clone(), "(<|<=|>|>=|≤|≥)")
                .prop_map(|((x, y), sign)| format!("if({x} {sign} {y}, {y}, hypot({x}, 2))")),
            inner.clone().prop_map(|x| format!("-{x}")),
            inner.clone().prop_map(|x| format!("({x})²")),
            inner.clone().prop_map(|x| format!("|{x}|")),
            (inner.clone(), function).prop_map(|(x, function)| format!("{function}({x})")),
            (vector, vector).prop_map(|(v, w)| format!("{v}·{w}")),
            (inner, vector).prop_map(|(x, v)| format!("|({x})*{v}|")),
        ]
    })
}

/// Formulas with constant parts such as ln(0) are refused; all others print to themselves.
fn prints_to_itself(text: &str) -> Result<(), TestCaseError> {
    let names = heavy_top();
    if let Ok(formula) = Formula::new(text, &names) {
        let printed = formula.to_string();
        let again = Formula::new(&printed, &names);
        prop_assert_eq!(again.as_ref(), Ok(&formula), "{}", printed);
        prop_assert_eq!(again.map(|again| again.to_string()), Ok(printed));
    }
    Ok(())
}

proptest! {
    #[test]
    fn printed_formulas_parse_to_themselves(texts in prop::collection::vec(scalar(), 25)) {
        for text in texts {
            prints_to_itself(&text)?;
        }
    }
}

/// The pieces of random texts: all tokens, and what is none.
const PIECES: &[&str] = &[
    "Pi", "Pi1", "Γ₂", "Gamma", "c", "mgl", "zz", "2", "0.5", "1e3", "1e999", ".", "½", "²", "⁻¹",
    "⁻", "³⁴", "+", "-", "*", "/", "^", "**", "·", "×", "(", ")", "[", "]", "|", ",", "√", "sin",
    "sqrt(", "atan2", "dot(", "norm", " ", "\n", "é", "$", "\u{0}", "🙂", "0", "-1", "‖", "e", "E",
    "_", "1e", "pi", "[1]", "[3]",
];

/// Returns whether a random text is a formula; checks the error if it is not.
fn try_text(seed: u64, names: &Vocabulary) -> bool {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = |bound: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as usize % bound
    };
    let length = 1 + next(24);
    let text: String = (0..length).map(|_| PIECES[next(PIECES.len())]).collect();
    match Formula::new(&text, names) {
        Ok(_) => true,
        Err(error) => {
            let place = text.get(error.span());
            assert!(place.is_some(), "{text:?}: {:?}", error.span());
            assert!(!error.to_string().is_empty() && error.quoted(&text).contains('^'));
            false
        }
    }
}

/// Checks 10⁴ random texts, or as many as the environment variable `FORMULA_TEXTS` says.
#[test]
fn random_texts_never_panic() {
    let count = std::env::var("FORMULA_TEXTS").ok().and_then(|count| count.parse().ok());
    let (names, count) = (heavy_top(), count.unwrap_or(10_000));
    let formulas = (0..count).filter(|&seed| try_text(seed, &names)).count();
    // Some short texts are formulas by chance, most are not.
    assert!(formulas > 0 && formulas < count as usize / 5, "{formulas} of {count}");
}
