//! Rust compilers that can make WebAssembly.

use crate::build_error::BuildError;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fmt, fs};

/// The name of the platform.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// A compiler with its cargo, and how it can make WebAssembly.
#[derive(Debug)]
pub struct Compiler {
    /// The path of cargo.
    pub cargo: PathBuf,
    /// The path of rustc.
    pub rustc: PathBuf,
    /// Whether the standard library must be compiled from its sources first.
    pub builds_std: bool,
    /// The path of the linker, if the compiler has none of its own.
    pub linker: Option<PathBuf>,
}

impl fmt::Display for Compiler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let library = if self.builds_std {
            "the standard library is compiled from its sources, which takes a minute"
        } else {
            "with its standard library for WebAssembly"
        };
        write!(f, "{}, {library}", self.rustc.display())
    }
}

/// Returns the first compiler that has a standard library for WebAssembly, else the first that has its sources.
///
/// The first one tried is that of the cargo that runs this program, then come those on the search path.
///
/// # Errors
/// Returns [`BuildError::NoCompiler`] with what each compiler lacks.
pub fn choose() -> Result<Compiler, BuildError> {
    let path = env::var_os("PATH").unwrap_or_default();
    let mut folders: Vec<PathBuf> = env::var_os("CARGO")
        .and_then(|cargo| Path::new(&cargo).parent().map(Path::to_path_buf))
        .into_iter()
        .collect();
    folders.extend(env::split_paths(&path));
    let linkers: Vec<PathBuf> =
        env::split_paths(&path).flat_map(|folder| linkers(&folder)).collect();
    let (mut found, mut tried, mut roots) = (Vec::new(), String::new(), Vec::new());
    for folder in folders {
        let [cargo, rustc] = ["cargo", "rustc"]
            .map(|name| folder.join(name).with_extension(env::consts::EXE_EXTENSION));
        if !cargo.is_file() || !rustc.is_file() {
            continue;
        }
        let Some(root) = printed(&rustc, &["--print", "sysroot"]) else { continue };
        if roots.contains(&root) {
            continue;
        }
        match examine(cargo, &rustc, Path::new(&root), linkers.first()) {
            Ok(compiler) => found.push(compiler),
            Err(lack) => tried += &format!("  {}: {lack}.\n", rustc.display()),
        }
        roots.push(root);
    }
    found.sort_by_key(|compiler| compiler.builds_std);
    found.into_iter().next().ok_or(BuildError::NoCompiler { tried })
}

/// Returns how a compiler can make WebAssembly, or what it lacks.
fn examine(
    cargo: PathBuf,
    rustc: &Path,
    root: &Path,
    linker: Option<&PathBuf>,
) -> Result<Compiler, String> {
    let version = printed(rustc, &["--version"]).unwrap_or_default();
    if minor(&version) < minor(concat!("rustc ", env!("CARGO_PKG_RUST_VERSION"))) {
        return Err(format!("it is older than Rust {}", env!("CARGO_PKG_RUST_VERSION")));
    }
    let library = root.join("lib/rustlib");
    let is_std = |name: &str| name.starts_with("libstd-") && name.ends_with(".rlib");
    let installed = names(&library.join(TARGET).join("lib")).iter().any(|name| is_std(name));
    if !installed && !library.join("src/rust/library/std/Cargo.toml").is_file() {
        return Err(format!("it has no standard library for {TARGET}, nor the sources of one"));
    }
    let has_linker =
        names(&library).iter().any(|host| library.join(host).join("bin/rust-lld").is_file());
    let linker = if has_linker { None } else { linker.cloned() };
    if !has_linker && linker.is_none() {
        return Err("there is no linker for WebAssembly: neither rust-lld nor wasm-ld".into());
    }
    Ok(Compiler { cargo, rustc: rustc.into(), builds_std: !installed, linker })
}

/// Returns the minor number of a version, such as 96 of `rustc 1.96.0`.
fn minor(version: &str) -> u32 {
    let minor = version.split(['.', '-', ' ']).nth(2);
    minor.and_then(|number| number.parse().ok()).unwrap_or(0)
}

/// Returns the linkers `wasm-ld` and `wasm-ld-14` in a folder.
fn linkers(folder: &Path) -> Vec<PathBuf> {
    let mut found = names(folder);
    found.retain(|name| name.starts_with("wasm-ld"));
    found.sort();
    found.into_iter().map(|name| folder.join(name)).collect()
}

/// Returns the names in a folder; none if there is no such folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.filter_map(|entry| entry.file_name().into_string().ok()).collect()
}

/// Returns the first line that a program prints.
fn printed(program: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    text.lines().next().filter(|_| output.status.success()).map(str::to_owned)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_compared_by_their_minor_number() {
        assert_eq!(minor("rustc 1.96.0 (ac68faa20 2026-05-25)"), 96);
        assert_eq!((minor("rustc 1.89"), minor("rustc 1.100.0-nightly"), minor("")), (89, 100, 0));
    }

    /// A folder that looks like a compiler: what it has decides how it makes WebAssembly.
    #[test]
    #[cfg(unix)]
    fn what_a_compiler_has_decides_how_it_is_used() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (root, rustc) = (folder.path(), folder.path().join("rustc"));
        let says = |version: &str| {
            fs::write(&rustc, format!("#!/bin/sh\necho rustc {version}\n")).unwrap();
            fs::set_permissions(&rustc, fs::Permissions::from_mode(0o755)).unwrap();
        };
        let have = |file: &str| {
            let file = root.join("lib/rustlib").join(file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, "").unwrap();
        };
        let linker = PathBuf::from("wasm-ld");
        let examined = |linker| examine("cargo".into(), &rustc, root, linker);

        says("1.80.0");
        assert!(examined(Some(&linker)).unwrap_err().contains("older than Rust 1.89"));
        says("1.96.0");
        assert!(examined(Some(&linker)).unwrap_err().contains("no standard library"));
        have("src/rust/library/std/Cargo.toml");
        assert!(examined(None).unwrap_err().contains("no linker"));
        let built = examined(Some(&linker)).unwrap();
        assert!(built.builds_std && built.linker == Some(linker.clone()));
        have("wasm32-unknown-unknown/lib/libstd-0123.rlib");
        have("x86_64-unknown-linux-gnu/bin/rust-lld");
        let installed = examined(Some(&linker)).unwrap();
        assert!(!installed.builds_std && installed.linker.is_none());
    }
}
