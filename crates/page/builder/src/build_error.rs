//! Errors of the builder.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use thiserror::Error;

/// The reason why there is no page.
#[derive(Debug, Error)]
pub enum BuildError {
    /// The compiler has no standard library for WebAssembly.
    #[error(
        "the page needs a Rust compiler for WebAssembly; this installs what is missing:\n  \
         rustup target add {target}"
    )]
    NoLibrary {
        /// The name of the platform.
        target: &'static str,
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
