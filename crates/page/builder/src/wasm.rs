//! The library as a WebAssembly module.

use crate::build_error::BuildError;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The name of the platform.
const TARGET: &str = "wasm32-unknown-unknown";

/// The profile in the manifest of the workspace.
const PROFILE: &str = "page";

/// Compiles the library with the cargo that runs this program, and returns the module.
///
/// # Errors
/// Returns [`BuildError`] if the compiler has no standard library for WebAssembly, if cargo cannot be started or fails,
/// or if there is no module afterwards.
pub fn compile(root: &Path, target: &Path) -> Result<Vec<u8>, BuildError> {
    require_library()?;
    let program = env::var_os("CARGO").map_or("cargo".into(), PathBuf::from);
    let mut cargo = Command::new(&program);
    cargo.current_dir(root);
    cargo.args(["build", "--locked", "--lib", "--package", "heavytop-page"]);
    cargo.args(["--profile", PROFILE, "--target", TARGET, "--target-dir"]).arg(target);
    // Flags for the processor of this machine do not suit WebAssembly.
    for flags in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"] {
        cargo.env_remove(flags);
    }
    let status = cargo.status().map_err(|source| BuildError::Start { program, source })?;
    if !status.success() {
        return Err(BuildError::Failed { status });
    }
    let module = target.join(TARGET).join(PROFILE).join("heavytop_page.wasm");
    fs::read(&module).map_err(|source| BuildError::file(&module, source))
}

/// Checks that the compiler has a standard library for WebAssembly.
fn require_library() -> Result<(), BuildError> {
    let program = env::var_os("RUSTC").map_or("rustc".into(), PathBuf::from);
    let printed =
        Command::new(&program).args(["--print", "target-libdir", "--target", TARGET]).output();
    let printed = printed.map_err(|source| BuildError::Start { program, source })?;
    let folder = String::from_utf8_lossy(&printed.stdout);
    let entries = fs::read_dir(folder.trim()).into_iter().flatten().flatten();
    let mut names = entries.map(|entry| entry.file_name());
    if names.any(|name| name.to_string_lossy().starts_with("libstd-")) {
        Ok(())
    } else {
        Err(BuildError::NoLibrary { target: TARGET })
    }
}
