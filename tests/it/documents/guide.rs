//! The guide: every link of a page leads to a file, every formula is LaTeX, all tabs are ended, and every chapter is in
//! the book and runs as a test.

// The program that builds the guide, and is no member of the workspace, typesets the formulas and makes the tabs.
#[path = "../../../docs/guide/builder/src/formulas.rs"]
mod formulas;
#[path = "../../../docs/guide/builder/src/tabs.rs"]
mod tabs;

use pulldown_cmark::{Event, Parser, Tag};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Returns the Markdown pages in a folder of the repository and below.
fn pages(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(pages(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    Ok(found)
}

/// Returns the targets of the links and pictures of a page that are files.
fn targets(markdown: &str) -> Vec<String> {
    let target = |event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => Some(dest_url),
        _ => None,
    };
    let links = Parser::new(markdown).filter_map(target);
    let files = links.filter(|link| !link.contains("://") && !link.starts_with('#'));
    files.map(|link| link.split('#').next().unwrap_or_default().to_owned()).collect()
}

#[test]
fn every_link_leads_to_a_file() -> Result<(), Box<dyn Error>> {
    let mut all = pages(&root().join("docs"))?;
    all.push(root().join("README.md"));
    let mut count = 0;
    for page in all {
        for target in targets(&fs::read_to_string(&page)?) {
            let path = page.with_file_name(&target);
            assert!(path.exists(), "{}: there is no {target}", page.display());
            count += 1;
        }
    }
    assert!(count > 60, "{count}");
    // Control: links and pictures are seen, and addresses are not taken for files.
    let page = "[a](b.md#c) ![d](e/f.png) [g](https://h.org) [i](#j)";
    assert_eq!(targets(page), ["b.md", "e/f.png"]);
    Ok(())
}

/// Returns the paths that a page names, from the root of the repository.
fn named_paths(page: &str) -> impl Iterator<Item = &str> {
    let is_path = |text: &&str| {
        let folders = ["crates/", "tests/", "benches/", "docs/"];
        folders.iter().any(|folder| text.starts_with(folder))
            && !text.contains(|c: char| c.is_whitespace() || "*{<".contains(c))
    };
    page.split('`').skip(1).step_by(2).filter(is_path)
}

#[test]
fn every_file_that_a_page_names_is_there() -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for page in pages(&root().join("docs"))? {
        for path in named_paths(&fs::read_to_string(&page)?) {
            assert!(root().join(path).exists(), "{}: there is no {path}", page.display());
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
    // Control: paths are seen, and commands and patterns are not taken for them.
    let page = "`crates/a/b.rs` and `cargo test`, `tests/*.rs`, `docs/c.md`";
    assert_eq!(named_paths(page).collect::<Vec<_>>(), ["crates/a/b.rs", "docs/c.md"]);
    Ok(())
}

#[test]
fn every_chapter_is_in_the_book_and_runs() -> Result<(), Box<dyn Error>> {
    let book = targets(&fs::read_to_string(root().join("docs/SUMMARY.md"))?);
    // Commands and Python run with the tests of the Python package, which finds the pages itself.
    let tests = fs::read_to_string(root().join("tests/src/lib.rs"))?;
    let chapters = pages(&root().join("docs/guide"))?;
    assert_eq!(chapters.len(), book.iter().filter(|target| target.starts_with("guide/")).count());
    let mut in_rust = 0;
    for chapter in chapters {
        let name = chapter.file_name().ok_or("a chapter without a name")?.to_string_lossy();
        assert!(book.contains(&format!("guide/{name}")), "{name} is not in the book");
        if fs::read_to_string(&chapter)?.contains("```rust") {
            assert!(tests.contains(&format!("docs/guide/{name}\"")), "{name} does not run");
            in_rust += 1;
        }
    }
    assert!(in_rust > 10, "{in_rust}");
    Ok(())
}

#[test]
fn every_formula_is_latex_and_all_tabs_are_ended() -> Result<(), Box<dyn Error>> {
    let (mut typeset, mut labels) = (0, 0);
    for page in pages(&root().join("docs"))? {
        let text = fs::read_to_string(&page)?;
        let rendered = formulas::typeset(&text).and_then(|text| tabs::tabbed(&text, "a chapter"));
        let rendered = rendered.map_err(|message| format!("{}: {message}", page.display()))?;
        typeset += rendered.matches("<math").count();
        labels += rendered.matches("<label").count();
    }
    assert!(typeset > 8 && labels > 4, "{typeset} {labels}");
    Ok(())
}
