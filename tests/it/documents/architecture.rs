//! The folders of each crate: no two files import each other, each folder imports only those that `lib.rs` declares
//! before it, and no folder is crowded.

use std::collections::BTreeMap;
use std::path::Path;
use workspace_tests::architecture::{
    Sources, cycles, declared_order, imports, imports_from_the_root, room, sources,
};

/// The crates, from the bottom to the top.
const CRATES: &[&str] = &[
    "pictures",
    "scalars",
    "lie-poisson",
    "formulas",
    "momentum-map",
    "integrators",
    "isospectral",
    "systems",
    "heavytop",
    "formula-systems",
    "runs",
    "python",
    "page",
    PROGRAM,
];

/// The crate of the program `heavytop`.
const PROGRAM: &str = "heavytop-cli";

/// The largest number of files in one folder, beside `mod.rs`, `lib.rs` or `main.rs`.
const CROWDED: usize = 9;

fn sources_of(name: &str) -> Sources {
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates").join(name).join("src"))
        .unwrap()
}

/// Returns the imports that violate the order of `lib.rs`.
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

#[test]
fn imports_name_the_module_that_defines() {
    for name in CRATES {
        assert_eq!(imports_from_the_root(&sources_of(name)), [""; 0], "{name}");
    }
}

/// The folder and the package of each crate, from the bottom to the top.
const PACKAGES: &[(&str, &str)] = &[
    ("pictures", "svg-pictures"),
    ("scalars", "generic-scalars"),
    ("lie-poisson", "lie-poisson"),
    ("formulas", "lie-poisson-formulas"),
    ("momentum-map", "momentum-map"),
    ("integrators", "collective-integrators"),
    ("isospectral", "isospectral-flows"),
    ("systems", "lie-poisson-systems"),
    ("heavytop", "heavytop"),
    ("formula-systems", "lie-poisson-formula-systems"),
    ("runs", "lie-poisson-runs"),
    ("python", "heavytop-python"),
    ("page", "heavytop-page"),
    ("heavytop-cli", "heavytop-cli"),
];

/// Returns whether the manifest of a crate names a package of the workspace, for its tests too.
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
    // These two crates stand side by side.
    assert!(!names("heavytop", "lie-poisson-systems"));
    // Negative control: packages that a crate names are found.
    assert!(names("systems", "momentum-map") && names("heavytop", "collective-integrators"));
}

/// Returns the folders with too many files.
fn crowded(sources: &Sources) -> Vec<String> {
    let mut files = BTreeMap::<&str, usize>::new();
    for file in sources.keys() {
        let (folder, name) = file.rsplit_once('/').unwrap_or(("", file));
        if !["mod.rs", "lib.rs", "main.rs"].contains(&name) {
            *files.entry(folder).or_default() += 1;
        }
    }
    let crowded = files.into_iter().filter(|(_, count)| *count > CROWDED);
    crowded.map(|(folder, count)| format!("{folder}: {count}")).collect()
}

#[test]
fn no_folder_is_crowded() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let tests = |name| sources(&root.join("../crates").join(name).join("tests/it"));
    for name in CRATES {
        assert_eq!(crowded(&sources_of(name)), [""; 0], "{name}");
        assert_eq!(crowded(&tests(name).unwrap_or_default()), [""; 0], "tests of {name}");
    }
    assert_eq!(crowded(&sources(&root.join("src")).unwrap()), [""; 0]);
    let mut sources = sources(&root.join("it")).unwrap();
    assert_eq!(crowded(&sources), [""; 0]);
    // Negative control: ten files in one folder.
    sources.extend((0..10).map(|n| (format!("documents/{n}.rs"), String::new())));
    assert_eq!(crowded(&sources).len(), 1);
}

/// Returns the imports of a command from another command.
fn across_commands(sources: &Sources) -> Vec<String> {
    let command = |file: &str| {
        let (command, _) = file.strip_prefix("commands/")?.split_once('/')?;
        Some(command.to_owned())
    };
    let mut found = Vec::new();
    for (file, imported) in imports(sources) {
        for target in imported.into_iter().filter(|target| command(target).is_some()) {
            if command(file).is_some() && command(file) != command(target) {
                found.push(format!("{file} imports {target}"));
            }
        }
    }
    found
}

#[test]
fn no_command_imports_another() {
    let sources = sources_of(PROGRAM);
    assert!(sources.keys().any(|file| file.starts_with("commands/simulate/")));
    assert_eq!(across_commands(&sources), [""; 0]);
}

/// Returns the file names that occur more than once, except `mod.rs`.
fn repeated_names(sources: &Sources) -> Vec<String> {
    let mut files = BTreeMap::<&str, usize>::new();
    let name = |file: &'_ str| file.rsplit_once('/').map_or(0, |(folder, _)| folder.len() + 1);
    for file in sources.keys() {
        *files.entry(&file[name(file)..]).or_default() += 1;
    }
    let repeated = files.into_iter().filter(|(name, count)| *count > 1 && *name != "mod.rs");
    repeated.map(|(name, _)| name.to_owned()).collect()
}

#[test]
fn file_names_of_the_program_are_unique() {
    assert_eq!(repeated_names(&sources_of(PROGRAM)), [""; 0]);
}

/// Returns the items in `mod.rs` files that are neither declarations of modules nor re-exports.
fn code_in_mod_files(sources: &Sources) -> Vec<String> {
    let mut found = Vec::new();
    for (file, text) in sources.iter().filter(|(file, _)| file.ends_with("mod.rs")) {
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        let code = code.collect::<Vec<_>>().join("\n");
        for statement in code.split(';').map(str::trim).filter(|statement| !statement.is_empty()) {
            let item = statement.split_once(' ').map_or("", |(_, item)| item);
            if !statement.starts_with("mod ")
                && !item.starts_with("mod ")
                && !item.starts_with("use ")
            {
                found.push(format!("{file}: {statement}"));
            }
        }
    }
    found
}

#[test]
fn mod_files_of_the_program_only_declare() {
    assert_eq!(code_in_mod_files(&sources_of(PROGRAM)), [""; 0]);
}

/// Negative control: the other tests find sources that break their rules.
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
        (
            "high/mod.rs",
            "pub(crate) mod top;\npub(crate) mod side;\n\npub type Tops = [top::Top; 2];\n",
        ),
        ("high/top.rs", "pub struct Top(pub crate::low::other::Inner);\n"),
        ("high/side.rs", "use super::Tops;\n"),
    ];
    let broken: Sources = files.map(|(file, text)| (file.to_owned(), text.to_owned())).into();
    assert_eq!(declared_order(&broken), ["low", "high"]);
    let found = imports(&broken);
    assert_eq!(Vec::from_iter(found["low/base.rs"].iter().copied()), ["high/top.rs"]);
    assert_eq!(Vec::from_iter(found["low/other.rs"].iter().copied()), ["low/base.rs"]);
    assert_eq!(cycles(&found), ["high/top.rs", "low/base.rs", "low/other.rs"]);
    assert_eq!(Vec::from_iter(found["high/mod.rs"].iter().copied()), ["high/top.rs"]);
    assert_eq!(Vec::from_iter(found["high/side.rs"].iter().copied()), ["high/mod.rs"]);
    assert_eq!(against_the_order(&broken), ["low/base.rs imports high/top.rs"]);
    let from_root = ["Other", "Top"].map(|name| format!("low/base.rs imports crate::{name}"));
    assert_eq!(imports_from_the_root(&broken), from_root);
}

/// Negative control: the tests of the program find sources that break their rules.
#[test]
fn broken_rules_of_the_program_are_found() {
    let files = [
        ("lib.rs", "pub mod commands;\n"),
        ("commands/mod.rs", "pub mod draw;\npub mod run;\n\npub use run::table::Table;\n"),
        ("commands/draw/mod.rs", "mod table;\n\nfn draw() {\n    println!();\n}\n"),
        ("commands/draw/table.rs", "use crate::commands::Table;\n"),
        ("commands/run/mod.rs", "pub(crate) mod table;\n"),
        ("commands/run/table.rs", "pub struct Table;\n"),
    ];
    let broken: Sources = files.map(|(file, text)| (file.to_owned(), text.to_owned())).into();
    let across = ["commands/draw/table.rs imports commands/run/table.rs"];
    assert_eq!(across_commands(&broken), across);
    assert_eq!(repeated_names(&broken), ["table.rs"]);
    assert_eq!(code_in_mod_files(&broken).len(), 2);
}

/// Adds the names of Rust files below a folder, with the files. Files that every test binary has do not count.
fn test_files(folder: &Path, found: &mut BTreeMap<String, Vec<String>>) {
    // A crate without tests of its promises has no such folder.
    for file in sources(folder).unwrap_or_default().into_keys() {
        let name = file.rsplit('/').next().unwrap_or_default().to_owned();
        if !["main.rs", "mod.rs", "support.rs"].contains(&&*name) {
            found.entry(name).or_default().push(folder.join(file).display().to_string());
        }
    }
}

/// Returns the names that more than one file has.
fn repeated(files: BTreeMap<String, Vec<String>>) -> Vec<String> {
    let files = files.into_iter().filter(|(_, folders)| folders.len() > 1);
    files.map(|(name, folders)| format!("{name}: {}", folders.join(", "))).collect()
}

#[test]
fn no_two_files_of_tests_have_one_name() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = BTreeMap::new();
    test_files(&root.join("it"), &mut files);
    for name in CRATES {
        test_files(&root.join("../crates").join(name).join("tests/it"), &mut files);
    }
    // Control: the files have been read, and a second one of a name is found.
    assert!(files.contains_key("architecture.rs") && files.contains_key("lanes.rs"));
    let mut planted = files.clone();
    planted.entry("lanes.rs".into()).or_default().push("elsewhere".into());
    assert_eq!(repeated(files), [""; 0]);
    assert_eq!(repeated(planted).len(), 1);
}
