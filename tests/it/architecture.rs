//! The folders of each crate show its architecture: no two files import each other, each room imports only those that
//! `lib.rs` declares before it, and no room is crowded.

use std::collections::BTreeMap;
use std::path::Path;
use workspace_tests::architecture::{Sources, cycles, declared_order, imports, room, sources};

/// The crates, from the bottom to the top.
const CRATES: &[&str] =
    &["scalars", "lie-poisson", "momentum-map", "integrators", "systems", "heavytop"];

/// Files beside `mod.rs` or `lib.rs` in one folder.
const CROWDED: usize = 9;

fn sources_of(name: &str) -> Sources {
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates").join(name).join("src"))
        .unwrap()
}

/// Imports against the order of `lib.rs`.
fn against_the_order(sources: &Sources) -> Vec<String> {
    let order = declared_order(sources);
    let place = |file: &str| order.iter().position(|name| *name == room(file));
    let mut found = Vec::new();
    for (file, imported) in imports(sources) {
        for target in imported.into_iter().filter(|target| place(file) < place(target)) {
            if file != "lib.rs" {
                found.push(format!("{file} imports {target}"));
            }
        }
    }
    found
}

#[test]
fn no_files_import_each_other() {
    for name in CRATES {
        let sources = sources_of(name);
        assert_eq!(cycles(&imports(&sources)), [""; 0], "{name}");
    }
}

#[test]
fn rooms_import_the_rooms_before_them() {
    for name in CRATES {
        assert_eq!(against_the_order(&sources_of(name)), [""; 0], "{name}");
    }
}

/// The folder and the package of each crate, from the bottom to the top.
const PACKAGES: &[(&str, &str)] = &[
    ("scalars", "generic-scalars"),
    ("lie-poisson", "lie-poisson"),
    ("momentum-map", "momentum-map"),
    ("integrators", "collective-integrators"),
    ("systems", "lie-poisson-systems"),
    ("heavytop", "heavytop"),
    ("heavytop-cli", "heavytop-cli"),
];

/// Whether the manifest of a crate names a package of the workspace, for its tests too.
fn names(folder: &str, package: &str) -> bool {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let manifest = std::fs::read_to_string(crates.join(folder).join("Cargo.toml")).unwrap();
    let from_workspace = [format!("\n{package}.workspace"), format!("\n{package} = {{ workspace")];
    from_workspace.iter().any(|start| manifest.contains(start))
}

#[test]
fn a_crate_names_only_crates_below_it() {
    for (place, (folder, _)) in PACKAGES.iter().enumerate() {
        for (_, above) in &PACKAGES[place..] {
            assert!(!names(folder, above), "{folder} names {above}");
        }
    }
    // Two crates stand side by side.
    assert!(!names("heavytop", "lie-poisson-systems"));
    // Negative control: what a crate does name is seen.
    assert!(names("systems", "momentum-map") && names("heavytop", "collective-integrators"));
}

#[test]
fn no_folder_is_crowded() {
    for name in CRATES {
        let mut files = BTreeMap::<String, usize>::new();
        let sources = sources_of(name);
        let inner = |file: &&String| !file.ends_with("mod.rs") && *file != "lib.rs";
        for file in sources.keys().filter(inner) {
            let folder = file.rsplit_once('/').map_or("", |(folder, _)| folder);
            *files.entry(folder.to_owned()).or_default() += 1;
        }
        let crowded: Vec<_> = files.iter().filter(|(_, count)| **count > CROWDED).collect();
        assert!(crowded.is_empty(), "{name}: {crowded:?}");
    }
}

/// Negative control: what the other tests must find in sources that break their rules.
#[test]
fn broken_rules_are_found() {
    let files = [
        (
            "lib.rs",
            "mod low;\nmod high;\n\npub use high::top::Top;\npub use low::base::{Base, Other};\n",
        ),
        ("low/mod.rs", "pub(crate) mod base;\npub(crate) mod other;\n"),
        ("low/base.rs", "use crate::{\n    Other,\n    Top, // upwards\n};\n\npub struct Base;\n"),
        (
            "low/other.rs",
            "use super::base::Base;\n\n#[cfg(test)]\nmod tests {\n    use crate::Top;\n}\n",
        ),
        ("high/mod.rs", "pub(crate) mod top;\n"),
        ("high/top.rs", "pub struct Top(pub crate::low::other::Inner);\n"),
    ];
    let broken: Sources = files.map(|(file, text)| (file.to_owned(), text.to_owned())).into();
    assert_eq!(declared_order(&broken), ["low", "high"]);
    let found = imports(&broken);
    assert_eq!(Vec::from_iter(found["low/base.rs"].iter().copied()), ["high/top.rs"]);
    assert_eq!(Vec::from_iter(found["low/other.rs"].iter().copied()), ["low/base.rs"]);
    assert_eq!(cycles(&found), ["high/top.rs", "low/base.rs", "low/other.rs"]);
    assert_eq!(against_the_order(&broken), ["low/base.rs imports high/top.rs"]);
}
