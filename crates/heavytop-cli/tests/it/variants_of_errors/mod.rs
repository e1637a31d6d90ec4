//! Every variant of every error of the program is what some call returns.
//!
//! The variants are read from the sources, and the errors come from calls of the library of the program. A variant that is
//! added without such a call fails the test, and so does a variant that nothing can return any more.
#![cfg(target_os = "linux")]

mod failed_commands;
mod refused_checkpoints;
mod refused_configurations;

use heavytop_cli::Error;
use heavytop_cli::errors::{
    CheckpointError, FieldFileError, InputFileError, SweepError, SystemTableError,
};
use std::collections::BTreeSet;
use std::error::Error as AnyError;
use std::fmt::Debug;

/// The sources of the errors, with their types.
const SOURCES: [(&str, &str); 6] = [
    ("Error", include_str!("../../../src/errors/error.rs")),
    ("CheckpointError", include_str!("../../../src/errors/parts/checkpoint_error.rs")),
    ("FieldFileError", include_str!("../../../src/errors/parts/field_file_error.rs")),
    ("InputFileError", include_str!("../../../src/errors/parts/input_file_error.rs")),
    ("SweepError", include_str!("../../../src/errors/parts/sweep_error.rs")),
    ("SystemTableError", include_str!("../../../src/errors/parts/system_table_error.rs")),
];

/// The variants that no call of the library returns, with the place of their test.
const ELSEWHERE: [(&str, &str); 4] = [
    ("Error::NoCommand", "`init_and_man.rs`: only the command line has it"),
    ("Error::Large", "`forecasts.rs`: only the command line asks"),
    ("Error::MissingTile", "`faults/damaged_tiles.rs`, where a tile is removed during the run"),
    ("Error::Figure", "`pictures/render.rs`: the drawings of the commands are right"),
];

/// Returns the variants of a public enum in its source.
fn declared(kind: &str, source: &str) -> BTreeSet<String> {
    let body = source.split_once(&format!("pub enum {kind} {{\n")).unwrap().1;
    let body = body.split_once("\n}\n").unwrap().0;
    // The fields of a variant and long attributes are indented further.
    let variants = body.lines().filter_map(|line| line.strip_prefix("    "));
    let variants = variants.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    variants.map(|line| format!("{kind}::{}", identifier(line))).collect()
}

/// Returns the identifier with which a text begins.
fn identifier(text: &str) -> &str {
    text.split(|c: char| !c.is_alphanumeric()).next().unwrap()
}

/// Returns a word of a message that is a Rust path or the name of a type. Users of the program do not read Rust.
fn rust_name(message: &str) -> Option<&str> {
    let words = message.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    let is_type = |word: &str| {
        let letters: Vec<char> = word.chars().collect();
        let humps =
            letters.windows(2).filter(|pair| pair[0].is_lowercase() && pair[1].is_uppercase());
        let plain = ["NumPy", "NaN", "MiB", "GiB", "KiB", "TiB"].contains(&word);
        humps.count() > 0 && !plain && letters.first().is_some_and(|first| first.is_uppercase())
    };
    // A colon may also end a part of a sentence.
    words.map(|word| word.trim_matches(':')).find(|word| word.contains("::") || is_type(word))
}

/// Returns the variants of an error and of its causes, such as `Error::Checkpoint` and `CheckpointError::Read`.
fn variants(error: &(dyn AnyError + 'static)) -> BTreeSet<String> {
    fn named<E: AnyError + 'static>(
        kind: &str,
        error: &(dyn AnyError + 'static),
    ) -> Option<String> {
        let plain = error.downcast_ref::<E>();
        let found = plain.or_else(|| error.downcast_ref::<Box<E>>().map(|boxed| &**boxed))?;
        // A message that panics or is empty helps nobody.
        assert!(!found.to_string().is_empty(), "{found:?}");
        Some(format!("{kind}::{}", identifier(&format!("{found:?}"))))
    }
    let chain = std::iter::successors(Some(error), |&error| error.source());
    let names = chain.flat_map(|error| {
        [
            named::<Error>("Error", error),
            named::<CheckpointError>("CheckpointError", error),
            named::<FieldFileError>("FieldFileError", error),
            named::<InputFileError>("InputFileError", error),
            named::<SweepError>("SweepError", error),
            named::<SystemTableError>("SystemTableError", error),
        ]
    });
    names.flatten().collect()
}

/// Returns the variants of the error of a call, and checks that there is an expected one among them.
#[track_caller]
fn refused<T: Debug>(expected: &str, outcome: Result<T, Error>) -> BTreeSet<String> {
    let Err(error) = outcome else { panic!("{expected}: {outcome:?}") };
    let found = variants(&error);
    // A message may quote what a user wrote, and the file with it; the tests write no Rust.
    assert_eq!(rust_name(&error.message()), None, "{}", error.message());
    assert!(found.contains(expected), "{expected}: {found:?}, {}", error.message());
    found
}

#[test]
fn every_variant_of_every_error_is_returned() {
    let declared: BTreeSet<String> =
        SOURCES.iter().flat_map(|(kind, source)| declared(kind, source)).collect();
    let returned = [
        refused_configurations::errors(),
        refused_checkpoints::errors(),
        failed_commands::errors(),
    ];
    let returned: BTreeSet<String> = returned.into_iter().flatten().collect();
    let missing: BTreeSet<&str> = declared.difference(&returned).map(String::as_str).collect();
    let elsewhere = BTreeSet::from(ELSEWHERE.map(|(variant, _)| variant));
    assert_eq!(missing, elsewhere, "no call returns these, or the list names what is returned");
    // What a call returns is declared: the reader of the sources overlooks none.
    let unknown: Vec<_> = returned.difference(&declared).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    // There are more than 80; fewer would mean that the reader overlooks some.
    assert!(declared.len() > 80, "{}", declared.len());
}

/// Negative control: paths and types are seen, names of users and of methods are not.
#[test]
fn rust_in_a_message_is_found() {
    assert_eq!(
        rust_name("a nearer one, as PoissonMap::recentred finds"),
        Some("PoissonMap::recentred")
    );
    assert_eq!(rust_name("see StepError"), Some("StepError"));
    assert_eq!(rust_name("gauss-8 of Pi1, at t = NaN: x[1], `system.initial`"), None);
}

/// Negative control: a variant of any form is read from a source, and the name of an error is that of its own variant.
#[test]
fn a_planted_variant_is_found() {
    let planted = "pub enum Planted {\n    /// Text.\n    #[error(\n        \"Long {text}\"\n    )]\n    Fields {\n        \
                   text: String,\n    },\n    #[error(transparent)]\n    Tuple(#[from] Other),\n    Unit,\n}\n";
    let expected = ["Fields", "Tuple", "Unit"].map(|name| format!("Planted::{name}"));
    assert_eq!(declared("Planted", planted), BTreeSet::from(expected));
    let nested: Error = SweepError::NoAxes.into();
    let nested = Error::Argument { name: "end", source: Box::new(nested) };
    let expected = ["Error::Argument", "Error::Sweep", "SweepError::NoAxes"];
    assert_eq!(variants(&nested), BTreeSet::from(expected.map(String::from)));
}
