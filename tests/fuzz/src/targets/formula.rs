//! Formulas: a text is refused with a place in it, or means the same after it was printed.

use crate::input::Input;
use lie_poisson::Se3;
use lie_poisson_formulas::{Formula, Parameters, Vocabulary};

pub(super) fn run(case: &[u8]) {
    let (numbers, text) = case.split_at(case.len().min(24));
    let Ok(text) = str::from_utf8(text) else { return };
    let parameters =
        Parameters::new().number("m", 0.75).and_then(|p| p.vector("I", &[1.0, 1.5, 2.0]));
    let Ok(names) = parameters.and_then(|parameters| Vocabulary::of(&Se3::default(), &parameters))
    else {
        panic!("the names are right")
    };
    let formula = match Formula::new(text, &names) {
        Ok(formula) => formula,
        Err(error) => {
            let span = error.span();
            assert!(
                span.start <= span.end && text.get(span.clone()).is_some(),
                "{span:?} in {text:?}"
            );
            assert!(error.quoted(text).contains('^'), "{}", error.quoted(text));
            return;
        }
    };
    let printed = formula.to_string();
    let again = Formula::new(&printed, &names);
    let Ok(again) = again else { panic!("{text:?} is printed as {printed:?}: {again:?}") };
    let z: [f64; 6] = Input::new(numbers).numbers();
    let (here, there) = (formula.value_at(&z), again.value_at(&z));
    assert!(
        here.to_bits() == there.to_bits() || here.is_nan() && there.is_nan(),
        "{text:?} {printed:?}"
    );
    assert_eq!(formula.differential_at(&z).len(), 6);
}
