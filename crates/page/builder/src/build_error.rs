//! Errors of the builder.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use thiserror::Error;

/// The reason why there is no page.
#[derive(Debug, Error)]
pub enum BuildError {
    /// No compiler can make WebAssembly.
    #[error(
        "The page needs a Rust compiler for WebAssembly, and there is none here.\n{tried}\
         One of these helps:\n  \
         rustup target add wasm32-unknown-unknown\n  \
         apt-get install rustc-web cargo-web rust-web-src lld    (on Debian, where rustup has no network)"
    )]
    NoCompiler {
        /// A line for each compiler: where it is, and what it lacks.
        tried: String,
    },
    /// A program cannot be started.
    #[error("cannot start {}", program.display())]
    Start {
        /// The path of the program.
        program: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// The compiler failed, and has said why.
    #[error(
        "the library was not compiled to WebAssembly ({status}); the messages of the compiler are above"
    )]
    Failed {
        /// How the compiler ended.
        status: ExitStatus,
    },
    /// A file cannot be read or written.
    #[error("cannot read or write {}", path.display())]
    File {
        /// The path of the file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
}

impl BuildError {
    /// Creates the error of a file.
    pub fn file(path: &Path, source: io::Error) -> Self {
        Self::File { path: path.into(), source }
    }
}
