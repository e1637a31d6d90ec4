//! The library as a WebAssembly module.

use crate::build_error::BuildError;
use crate::compilers::{Compiler, TARGET};
use std::fs;
use std::path::Path;
use std::process::Command;

/// The profile in the manifest of the workspace.
const PROFILE: &str = "page";

/// Compiles the library, and returns the module.
///
/// # Errors
/// Returns [`BuildError`] if cargo cannot be started or fails, or if there is no module afterwards.
pub fn compile(compiler: &Compiler, root: &Path, target: &Path) -> Result<Vec<u8>, BuildError> {
    let mut cargo = Command::new(&compiler.cargo);
    cargo.current_dir(root);
    cargo.args(["build", "--locked", "--lib", "--package", "heavytop-page"]);
    cargo.args(["--profile", PROFILE, "--target", TARGET, "--target-dir"]).arg(target);
    cargo.env("RUSTC", &compiler.rustc);
    // Flags for the processor of this machine do not suit WebAssembly.
    for flags in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"] {
        cargo.env_remove(flags);
    }
    if compiler.builds_std {
        // The sources of the standard library belong to the compiler; cargo calls this use of them unstable.
        cargo.arg("-Zbuild-std=std,panic_abort").env("RUSTC_BOOTSTRAP", "1");
    }
    if let Some(linker) = &compiler.linker {
        cargo.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker);
    }
    let status = cargo.status();
    let status =
        status.map_err(|source| BuildError::Start { program: compiler.cargo.clone(), source })?;
    if !status.success() {
        return Err(BuildError::Failed { status });
    }
    let module = target.join(TARGET).join(PROFILE).join("heavytop_page.wasm");
    fs::read(&module).map_err(|source| BuildError::file(&module, source))
}
