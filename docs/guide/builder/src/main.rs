//! Builds the guide in `target/guide`: mdBook, with the formulas typeset as MathML, with the font that browsers draw
//! them with, and with tabs. The pages need no network.

mod formulas;
mod tabs;

use mdbook_driver::MDBook;
use mdbook_preprocessor::book::{Book, Chapter};
use mdbook_preprocessor::errors::{Error, Result};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The font of the formulas, in the crate that typesets them and below the pages.
const FONT: &str = "font/latinmodern-math.woff2";

/// Typesets the formulas of all chapters, and makes tabs.
struct Rendering;

impl Preprocessor for Rendering {
    fn name(&self) -> &str {
        "rendering"
    }

    fn run(&self, _: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let mut wrong = None;
        let rendered =
            |chapter: &Chapter| tabs::tabbed(&formulas::typeset(&chapter.content)?, &chapter.name);
        book.for_each_chapter_mut(|chapter| match rendered(chapter) {
            Ok(content) => chapter.content = content,
            Err(message) => wrong = Some(Error::msg(format!("{}: {message}", chapter.name))),
        });
        wrong.map_or(Ok(book), Err)
    }
}

/// Returns the font in the source of the crate that typesets the formulas.
fn font() -> Result<PathBuf> {
    let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let mut metadata = Command::new(cargo);
    metadata.args(["metadata", "--format-version=1", "--locked", "--manifest-path", manifest]);
    // The packages of other platforms need not be here.
    let output = metadata.args(["--filter-platform", env!("TARGET")]).output()?;
    if !output.status.success() {
        return Err(Error::msg(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout)?;
    let mut packages = metadata["packages"].as_array().into_iter().flatten();
    let package = packages.find(|package| package["name"] == "pulldown-latex");
    let manifest = package.and_then(|package| package["manifest_path"].as_str());
    let manifest = manifest.ok_or_else(|| Error::msg("cargo does not know pulldown-latex"))?;
    Ok(Path::new(manifest).with_file_name(FONT))
}

fn main() -> Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut book = MDBook::load(&root)?;
    book.with_preprocessor(Rendering).build()?;
    let pages = book.build_dir_for("html");
    // mdBook copies all of docs/ that is no page; this program is not part of the book.
    fs::remove_dir_all(pages.join("guide/builder"))?;
    fs::create_dir_all(pages.join(FONT).with_file_name(""))?;
    fs::copy(font()?, pages.join(FONT))?;
    println!("the guide is in {}", pages.canonicalize()?.join("guide/first-top.html").display());
    Ok(())
}
