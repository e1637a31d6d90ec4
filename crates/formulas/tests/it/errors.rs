//! Errors point at what is wrong.

use crate::support::heavy_top;
use lie_poisson_formulas::{Coordinates, Formula, Parameters, Problem, Vocabulary};

/// Returns the text that the error points at, and its message.
fn error(text: &str) -> (String, String) {
    let error = Formula::new(text, &heavy_top()).err();
    let error = error.unwrap_or_else(|| panic!("{text} is a formula"));
    (text[error.span()].to_owned(), error.to_string())
}

#[test]
fn errors_name_the_place_and_the_remedy() {
    for (text, place, message) in [
        ("", "", "the formula is empty"),
        (" \n", "", "the formula is empty"),
        ("Pi1 +", "", "a number, a name or `(` is missing here; found the end of the formula"),
        ("Pi1 * / 2", "/", "a number, a name or `(` is missing here; found `/`"),
        ("2 Pi1", "Pi1", "an operator is missing before `Pi1`; write `*` for a product"),
        ("½Π₁²", "Π₁", "an operator is missing before `Pi1`; write `*` for a product"),
        ("2(Pi1)", "(", "an operator is missing before `(`; write `*` for a product"),
        ("Pi1(2)", "Pi1", "`Pi1` is not a function; write `*` for a product"),
        ("(Pi1 + Pi2", "(", "this `(` is not closed by `)`"),
        ("Pi1)", ")", "there is no open bracket or function to which this `)` belongs"),
        ("Pi1, Pi2", ",", "there is no open bracket or function to which this `,` belongs"),
        ("|Pi", "|", "this `|` is not closed by `|`"),
        ("Pi[1", "[", "this `[` is not closed by `]`"),
        (
            "Pi[0]",
            "0",
            "the index of a component is a whole number from 1 on, or in a sum an index such as i or i+1",
        ),
        (
            "Pi[1.5]",
            "1.5",
            "the index of a component is a whole number from 1 on, or in a sum an index such as i or i+1",
        ),
        (
            "Pi[4]",
            "4",
            "there is no component 4 of a vector of dimension 3; components count from 1",
        ),
        ("mgl[1]", "1", "there is no component 1 of a scalar; components count from 1"),
        ("Pi1 + Gama2", "Gama2", "there is no `Gama2`; did you mean `Gamma2`?"),
        ("gamma1", "gamma1", "there is no `gamma1`; did you mean `Gamma1`?"),
        ("PI", "PI", "there is no `PI`; did you mean `Pi`?"),
        ("zebra", "zebra", "there is no `zebra`"),
        ("sqr(Pi1)", "sqr", "there is no function `sqr`; did you mean `sqrt`?"),
        ("sin", "sin", "the function `sin` needs its argument in parentheses"),
        ("sin*2", "sin", "the function `sin` needs its argument in parentheses"),
        ("sin(Pi1, Pi2)", "sin", "`sin` takes 1 argument(s), not 2"),
        ("atan2(Pi1)", "atan2", "`atan2` takes 2 argument(s), not 1"),
        ("if(Pi1, 1, 2)", "if", "`if` needs a comparison first, as in `if(x >= 0, y, z)`"),
        ("if(Pi1 > 0, 1)", "if", "`if` takes 3 argument(s), not 2"),
        (
            "if(Pi1 > 0, Pi, 2)",
            "if",
            "`if` needs two scalars or two vectors of one dimension, not a vector of dimension 3 and a scalar",
        ),
        ("if(Pi > 0, 1, 2)", "if", "`if` needs a scalar, not a vector of dimension 3"),
        ("Pi1 > 0", ">", "an operator is missing before `>`; write `*` for a product"),
        ("dot()", "dot", "`dot` takes 2 argument(s), not 0"),
        (
            "1 + Pi",
            "+",
            "`+` needs two scalars or two vectors of one dimension, not a scalar and a vector of dimension 3",
        ),
        (
            "Pi*Gamma",
            "*",
            "`*` needs a scalar, not a vector of dimension 3; write `·` or `×` between vectors",
        ),
        (
            "Pi1·Gamma",
            "·",
            "`·` needs two vectors of one dimension, not a scalar and a vector of dimension 3",
        ),
        (
            "Pi×2",
            "×",
            "`×` needs two vectors of dimension 3, not a vector of dimension 3 and a scalar",
        ),
        ("2/Pi", "/", "`/` needs a scalar, not a vector of dimension 3"),
        (
            "Pi^2",
            "^",
            "`^` needs a scalar, not a vector of dimension 3; write |v|^2 for the square of a vector",
        ),
        (
            "Pi²",
            "²",
            "`^` needs a scalar, not a vector of dimension 3; write |v|^2 for the square of a vector",
        ),
        ("sqrt(Pi)", "sqrt", "`sqrt` needs a scalar, not a vector of dimension 3"),
        (
            "Pi + Gamma",
            "+",
            "a Hamiltonian is a scalar, and this formula is a vector of dimension 3",
        ),
        ("Pi1/0", "/", "the divisor is 0"),
        (
            "Pi1 + ln(0)",
            "ln",
            "this part of the formula has the constant value -inf, which is not a finite number",
        ),
        ("Pi1.Gamma", ".", "the character `.` has no meaning in a formula; did you mean `·`?"),
        ("Pi1 $ 2", "$", "the character `$` has no meaning in a formula"),
        ("Pi • c", "•", "the character `•` has no meaning in a formula; did you mean `·`?"),
        ("{Pi1", "{", "the character `{` has no meaning in a formula; did you mean `(`?"),
        ("Pi1⟩", "⟩", "the character `⟩` has no meaning in a formula; did you mean `)`?"),
        ("Pi ∧ c", "∧", "the character `∧` has no meaning in a formula; did you mean `×`?"),
        ("Pi1′", "′", "the character `′` has no meaning in a formula; did you mean `_`?"),
        ("Pi1; 2", ";", "the character `;` has no meaning in a formula; did you mean `,`?"),
        ("1.2.3", "1.2.3", "`1.2.3` is not a number"),
        ("1e400*Pi1", "1e400", "`1e400` is outside of the range of numbers, 2.3e-308 to 1.8e308"),
        (
            "1e-400*Pi1",
            "1e-400",
            "`1e-400` is outside of the range of numbers, 2.3e-308 to 1.8e308",
        ),
    ] {
        assert_eq!(error(text), (place.to_owned(), message.to_owned()), "{text}");
    }
}

/// A cross product has three dimensions. A name of more than 64 letters is compared with no other name.
#[test]
fn vectors_of_the_plane_and_long_names() {
    let long = "a".repeat(65);
    let coordinates = Coordinates::new().scalar(&long).unwrap().vector("v", 2).unwrap();
    let names = Vocabulary::new(&coordinates, &Parameters::new()).unwrap();
    let message = |text: &str| Formula::new(text, &names).unwrap_err().to_string();
    let vector = "a vector of dimension 2";
    let needed = format!("`×` needs two vectors of dimension 3, not {vector} and {vector}");
    assert_eq!(message("(v×v)[1]"), needed);
    let misspelt = format!("{long}b");
    assert_eq!(message(&misspelt), format!("there is no `{misspelt}`"));
}

#[test]
fn quotations_mark_the_place() {
    let text = "Π₁ +\n  Γ₁*Gama2 + 1";
    let error = Formula::new(text, &heavy_top()).unwrap_err();
    let quoted = "  Γ₁*Gama2 + 1\n     ^^^^^ there is no `Gama2`; did you mean `Gamma2`?";
    assert_eq!(error.quoted(text), quoted);
}

#[test]
fn depth_and_length_have_limits() {
    let repeated = |part: &str, count: usize| part.repeat(count);
    for part in ["(", "|", "-", "√", "2^", "sin(", "Pi1*(", "+", "-(", "√(", "|-", "2^-"] {
        for count in [150, 1000, 10_000] {
            let text = repeated(part, count.min(60_000 / part.len()));
            assert!(Formula::new(&text, &heavy_top()).is_err(), "{part} {count}");
            let whole = format!("{text}Pi1");
            let error = Formula::new(&whole, &heavy_top()).map_err(|error| error.problem().clone());
            if count > 200 {
                assert!(matches!(error, Err(Problem::TooDeep { .. })), "{part} {count} {error:?}");
            }
        }
    }
    let long = format!("Pi1{}", repeated(" + Pi1", 20_000));
    let error = Formula::new(&long, &heavy_top()).unwrap_err();
    assert!(matches!(error.problem(), Problem::TooLong { length: 120_003, .. }));
    // Below the limits, long and deep formulas are read.
    let long = format!("Pi1{}", repeated(" + Pi1", 10_000));
    assert!(Formula::new(&long, &heavy_top()).is_ok());
    let deep = format!("{}Pi1{}", repeated("sin(", 190), repeated(")", 190));
    assert!(Formula::new(&deep, &heavy_top()).is_ok());
    // Raised exponents have at most nine digits.
    for (digits, is_read) in [(1, true), (9, true), (10, false), (20, false)] {
        let power = format!("Pi1{}", repeated("¹", digits));
        assert_eq!(Formula::new(&power, &heavy_top()).is_ok(), is_read, "{power}");
    }
    // Roots side by side are not within each other.
    let many = format!("√Pi1{}", repeated(" + √Pi1", 1000));
    assert!(Formula::new(&many, &heavy_top()).is_ok());
}

/// A formula whose differential needs more numbers at a time than there are registers.
#[test]
#[ignore = "long"]
fn registers_have_a_limit() {
    let factors: Vec<String> = (1..4700).map(|n| format!("sin({n}*Pi1)")).collect();
    let error = Formula::new(&factors.join("*"), &heavy_top()).unwrap_err();
    assert!(matches!(error.problem(), Problem::TooLarge { limit: 8192, .. }), "{error}");
}

/// Scalars S1, S2, S3 are no vector S, and the message says so.
#[test]
fn numbered_scalars_are_no_vector() {
    let scalars = |names: &[&str]| {
        let all = names.iter().try_fold(Coordinates::new(), |all, name| all.scalar(name));
        Vocabulary::new(&all.unwrap(), &Parameters::new()).unwrap()
    };
    let told =
        |names: &[&str], text: &str| Formula::new(text, &scalars(names)).unwrap_err().to_string();
    let expected = "there is no vector `S`: `S1` to `S3` are numbers of their own; write them out, as in `S1*S1 + S2*S2`";
    assert_eq!(told(&["S1", "S2", "S3"], "S·S"), expected);
    // One number makes no vector, and a name that nothing is like is told as before.
    assert_eq!(told(&["S1", "T"], "S·S"), "there is no `S`");
    assert_eq!(told(&["S1", "S2"], "zebra"), "there is no `zebra`");
}
