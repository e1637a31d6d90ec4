//! Messages of errors: an error does not repeat its causes, so that nothing is printed twice, and the error of a run says
//! the reason itself, so that nothing is lost where only its message is printed.

use collective_integrators::diagnostics::{DriftError, StepMapError};
use collective_integrators::{
    DenseOutputError, EventError, IntegrationError, MemberError, OrderFitError, RunError,
    StepError, VariationalError,
};
use momentum_map::LiftError;
use std::error::Error;
use std::path::Path;
use workspace_tests::architecture::sources;

/// Returns the messages of an error and its causes, the error first.
fn chain(error: &dyn Error) -> Vec<String> {
    let mut said = vec![error.to_string()];
    let causes = std::iter::successors(error.source(), |&cause| cause.source());
    said.extend(causes.map(ToString::to_string));
    said
}

/// Returns whether an error of the chain repeats the message of a later one.
fn repeats(error: &dyn Error) -> bool {
    let said = chain(error);
    (1..said.len()).any(|n| said[..n].iter().any(|earlier| earlier.contains(&said[n])))
}

#[test]
fn errors_of_the_libraries_do_not_repeat_their_causes() {
    let source = StepError::NotFinite;
    let step = IntegrationError { step: 5, time: 0.5, source };
    let lift = LiftError { quantity: "Γ", value: 0.0, reason: "Γ must be different from 0" };
    let fit = OrderFitError::TooFew { usable: 2, plateau: 1e-12 };
    let errors: Vec<Box<dyn Error>> = vec![
        Box::new(step),
        Box::new(MemberError { index: 7, source: step }),
        Box::new(RunError::from(step)),
        Box::new(RunError::from(lift)),
        Box::new(EventError::from(step)),
        Box::new(DenseOutputError::from(step)),
        Box::new(VariationalError::from(step)),
        Box::new(StepMapError::from(source)),
        Box::new(StepMapError::from(lift)),
        Box::new(DriftError::from(step)),
        Box::new(DriftError::from(fit)),
    ];
    for error in &errors {
        assert!(!repeats(error.as_ref()), "{:?}", chain(error.as_ref()));
    }
}

/// Many programs print the message of an error with `{}`, without those of its causes.
#[test]
fn the_errors_of_a_run_say_the_reason_in_one_message() {
    let failed = StepError::NotConverged { residual: 0.5, required: 1e-16, iterations: 30 };
    let reasons = [failed, StepError::NotFinite, StepError::StepSize { step: f64::INFINITY }];
    for source in reasons {
        let step = IntegrationError { step: 5, time: 0.5, source };
        let said = format!("step 5 at t = 0.5: {source}");
        let errors: [Box<dyn Error>; 6] = [
            Box::new(step),
            Box::new(RunError::from(step)),
            Box::new(EventError::from(step)),
            Box::new(DenseOutputError::from(step)),
            Box::new(VariationalError::from(step)),
            Box::new(DriftError::from(step)),
        ];
        for error in &errors {
            assert_eq!(chain(error.as_ref()), [said.as_str()]);
        }
        let member = MemberError { index: 7, source: step };
        assert_eq!(chain(&member), [format!("member 7: {said}")]);
    }
    let lift = LiftError { quantity: "Γ", value: 0.0, reason: "Γ must be different from 0" };
    assert_eq!(chain(&RunError::from(lift)), [lift.to_string()]);
}

/// Negative control: an error that repeats its cause is found.
#[test]
fn an_error_that_repeats_its_cause_is_seen() {
    #[derive(Debug)]
    struct Repeating(StepError);
    impl std::fmt::Display for Repeating {
        fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            write!(f, "failed: {}", self.0)
        }
    }
    impl Error for Repeating {
        fn source(&self) -> Option<&(dyn Error + 'static)> {
            Some(&self.0)
        }
    }
    assert!(repeats(&Repeating(StepError::NotFinite)));
    let repeating = "#[error(\"a {}: {source}\", b)]\nA { source: B },";
    let other = "#[error(\"{0}\")]\nC(#[from] D),\n#[error(\"{0}\")]\nE(String),";
    assert_eq!((faults(repeating), faults(other)), (1, 1));
    let sound = "#[error(\"a {}\", b)]\nA { source: B },\n#[error(transparent)]\nC(#[from] D),";
    assert_eq!(faults(sound), 0);
}

/// Returns how many messages in a Rust source contain the source of their error.
fn faults(text: &str) -> usize {
    let messages = text.split("#[error(").skip(1);
    let repeats = |message: &str| {
        let (message, item) = message.split_once(")]").unwrap_or((message, ""));
        let uses = |name: &str| message.contains(&format!("{{{name}"));
        let named = uses("source") && item.contains("source:");
        // A tuple variant ends with its parenthesis.
        let fields = item.split('\n').find(|line| line.contains('(')).unwrap_or("");
        named || uses("0") && (fields.contains("#[source]") || fields.contains("#[from]"))
    };
    messages.filter(|message| repeats(message)).count()
}

/// Returns how many messages in a Rust source lack the cause that their error has: a message that is not transparent, of an
/// error with a source.
fn silent_about_causes(text: &str) -> usize {
    let messages = text.split("#[error(").skip(1);
    let has_source = |message: &&str| {
        let (message, item) = message.split_once(")]").unwrap_or((message, ""));
        // The item ends with its fields, or with its type.
        let ends = ["\n    },", "\n}\n"].into_iter().filter_map(|end| item.find(end));
        let own = item.get(..ends.min().unwrap_or(item.len())).unwrap_or("");
        let has = |words: &str| own.contains(words);
        !message.starts_with("transparent")
            && (has("#[source]")
                || has("#[from]")
                || has("        source: ")
                || has("    pub source: "))
    };
    messages.filter(has_source).count()
}

/// Programs of others print the message of an error alone. The program of this workspace prints the causes, too.
#[test]
fn no_message_of_a_library_leaves_its_cause_to_others() {
    let with_source =
        "    #[error(\"a\")]\n    A {\n        source: B,\n    },\n    #[error(\"c\")]\n    C,";
    let tuple =
        "    #[error(\"a\")]\n    A(#[source] B),\n    #[error(transparent)]\n    C(#[from] D),";
    assert_eq!((silent_about_causes(with_source), silent_about_causes(tuple)), (1, 1));
    let sources = sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates")).unwrap();
    let is_of_library = |file: &str| {
        file.contains("/src/") && !["heavytop-cli/", "page/"].iter().any(|door| file.contains(door))
    };
    let mut messages = 0;
    for (file, text) in sources.iter().filter(|(file, _)| is_of_library(file)) {
        messages += text.matches("#[error(").count();
        assert_eq!(silent_about_causes(text), 0, "{file}");
    }
    assert!(messages > 60, "{messages}");
}

#[test]
fn no_message_of_the_workspace_contains_the_source_of_its_error() {
    let sources = sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates")).unwrap();
    let mut messages = 0;
    for (file, text) in sources.iter().filter(|(file, _)| file.contains("/src/")) {
        messages += text.matches("#[error(").count();
        assert_eq!(faults(text), 0, "{file}");
    }
    assert!(messages > 80, "{messages}");
}
