//! Sums over an index, and numbered names.

use lie_poisson_formulas::{Coordinates, Formula, Parameters, Problem, Vocabulary};

/// Returns the names of five vectors S_1 to S_5, a vector x of four numbers, and parameters k (5 numbers) and J.
fn names() -> Vocabulary {
    let spins = Coordinates::new().vector("S", 3).unwrap().repeated(5).unwrap();
    let parameters = Parameters::new().vector("k", &[1.0, -2.0, 3.0, 0.5, 4.0]).unwrap();
    let parameters = parameters.number("J", 0.7).unwrap();
    Vocabulary::new(&spins.vector("x", 4).unwrap(), &parameters).unwrap()
}

fn formula(text: &str) -> Formula {
    Formula::new(text, &names()).unwrap_or_else(|error| panic!("{}", error.quoted(text)))
}

/// Checks that two texts have the same values and derivatives at a generic point.
fn same(text: &str, written_out: &str) {
    let z: Vec<f64> = (0..19).map(|i| (f64::from(i) * 0.7).sin() + 0.1).collect();
    let (short, long) = (formula(text), formula(written_out));
    assert_eq!(short.value_at(&z), long.value_at(&z), "{text}");
    assert_eq!(short.differential_at(&z), long.differential_at(&z), "{text}");
    // The printed text is the text, and is read as the same formula.
    assert_eq!(short.to_string(), text);
    assert_eq!(formula(&short.to_string()), short);
    assert_eq!(short, long);
}

#[test]
fn a_sum_is_written_out_over_what_exists() {
    same("sum(k[i])", "k[1] + k[2] + k[3] + k[4] + k[5]");
    same("-J*sum(S[i]·S[i+1])", "-J*(S_1·S_2 + S_2·S_3 + S_3·S_4 + S_4·S_5)");
    same("sum(S[i-2]·S[i])", "S_1·S_3 + S_2·S_4 + S_3·S_5");
    same("sum(x[i+1] - x[i])", "x[2] - x[1] + (x[3] - x[2]) + (x[4] - x[3])");
    same(
        "sum(k[i]*S[i][3])",
        "k[1]*S_1[3] + k[2]*S_2[3] + k[3]*S_3[3] + k[4]*S_4[3] + k[5]*S_5[3]",
    );
    same("|sum(S[i])|^2", "|S_1 + S_2 + S_3 + S_4 + S_5|^2");
    same("sum(x[i], i)", "x[1] + x[2] + x[3] + x[4]");
    same(
        "sum(x[i]*x[j], i < j)",
        "x[1]*x[2] + x[1]*x[3] + x[1]*x[4] + x[2]*x[3] + x[2]*x[4] + x[3]*x[4]",
    );
    same(
        "sum(x[i]*k[j], j, i)",
        &(1..=5)
            .flat_map(|j| (1..=4).map(move |i| format!("x[{i}]*k[{j}]")))
            .collect::<Vec<_>>()
            .join(" + "),
    );
    same(
        "sum(x[i]*sum(k[j], j), i)",
        &(1..=4)
            .map(|i| format!("x[{i}]*(k[1] + k[2] + k[3] + k[4] + k[5])"))
            .collect::<Vec<_>>()
            .join(" + "),
    );
    same(
        "sum(x[i]*x[j]*x[l], i < j < l)",
        "x[1]*x[2]*x[3] + x[1]*x[2]*x[4] + x[1]*x[3]*x[4] + x[2]*x[3]*x[4]",
    );
}

#[test]
fn numbered_names_have_short_forms() {
    let value = |text: &str| formula(text).value_at(&(1..=19).map(f64::from).collect::<Vec<_>>());
    assert_eq!(value("S1·S2"), value("S_1·S_2"));
    assert_eq!(value("S[2][3]"), 6.0);
    assert_eq!(value("S5[1]"), 13.0);
    assert_eq!(value("x[3]"), value("x3"));
    // Control: another number is another vector.
    assert_ne!(value("S1·S2"), value("S1·S3"));
}

#[test]
fn what_is_no_sum_is_refused() {
    let problem =
        |text: &str| Formula::new(text, &names()).map_err(|error| error.problem().clone());
    for text in
        ["sum(S[i]·S[j])", "sum(J)", "sum(x[i], j)", "sum(x[i], i, i)", "sum(y[i])", "sum((x)[i])"]
    {
        assert_eq!(problem(text), Err(Problem::SumIndex), "{text}");
    }
    assert_eq!(problem("sum(x[i]*x[i+4])"), Err(Problem::EmptySum { index: "i".into() }));
    for text in ["x[i]", "x[i+1]", "sum(x[i]*x[j], i)", "x[2-2]", "x[1-2]", "sum(x[i] + x[0])"] {
        assert_eq!(problem(text), Err(Problem::NotAnIndex), "{text}");
    }
    assert!(matches!(problem("sum(x[i]"), Err(Problem::NotClosed { .. })));
    assert!(matches!(problem("sum"), Err(Problem::MissingArgument { .. })));
    assert!(matches!(problem("sum()"), Err(Problem::SumIndex)));
    assert!(matches!(problem("sum(x[i] x[i])"), Err(Problem::MissingOperator { .. })));
    assert!(problem("sum(x[i]*k[j]*S[l][1]*k[m]*k[n], i, j, l, m, n)").is_ok());
    assert!(matches!(
        problem("sum(x[i]*k[j]*k[l]*k[m]*k[n]*k[o]*k[p]*k[q], i, j, l, m, n, o, p, q)"),
        Err(Problem::TooLarge { .. })
    ));
    assert!(matches!(problem("x[99999999999999999999]"), Err(Problem::NotAnIndex)));
    // Sums within each other multiply their terms.
    let nested: String = ('a'..='p').map(|i| format!("sum(k[{i}]*")).collect();
    let nested =
        format!("{nested}J{}", ('a'..='p').rev().map(|i| format!(", {i})")).collect::<String>());
    assert!(matches!(problem(&nested), Err(Problem::TooLarge { .. })), "{nested}");
}
