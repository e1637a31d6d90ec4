//! Builds the interactive page: `cargo page [FILE]`. The default is `target/page/heavy-top.html`.
//!
//! It compiles the library to WebAssembly and writes one HTML file that needs neither other files nor a network. The exit
//! code is 2 if the compiler has no standard library for WebAssembly.

mod build_error;
mod page;
mod wasm;

use build_error::BuildError;
use std::error::Error;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    match build(env::args_os().nth(1)) {
        Ok(said) => {
            println!("{said}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            let causes = std::iter::successors(error.source(), |&cause| cause.source());
            eprintln!("{error}{}", causes.map(|cause| format!(": {cause}")).collect::<String>());
            match error {
                BuildError::NoLibrary { .. } => ExitCode::from(2),
                _ => ExitCode::FAILURE,
            }
        }
    }
}

/// Builds the page, and returns what there is to say about it.
fn build(out: Option<OsString>) -> Result<String, BuildError> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let target = env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from);
    let out = out.map_or(target.join("page/heavy-top.html"), PathBuf::from);
    let module = wasm::compile(&root, &target.join("page-wasm"))?;
    let page = page::assemble(&module);
    if let Some(folder) = out.parent() {
        fs::create_dir_all(folder).map_err(|source| BuildError::file(folder, source))?;
    }
    fs::write(&out, &page).map_err(|source| BuildError::file(&out, source))?;
    let [module, page] = [module.len(), page.len()].map(|bytes| bytes.div_ceil(1000));
    let out = out.canonicalize().unwrap_or(out);
    Ok(format!("the page is {}: {page} kB, of which the module is {module} kB", out.display()))
}
