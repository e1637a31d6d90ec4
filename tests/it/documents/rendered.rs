//! The documentation as a browser shows it: no combining marks, which fonts displace, no raw TeX, and no subscript
//! that Markdown takes for emphasis.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Returns the files with this extension under the folders of the repository, by their paths from its root.
fn files(folders: &[&str], extension: &str) -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    let mut rest: Vec<PathBuf> = folders.iter().map(|folder| root.join(folder)).collect();
    while let Some(path) = rest.pop() {
        if path.is_dir() {
            let inside = fs::read_dir(path)?.map(|entry| Ok(entry?.path()));
            rest.extend(inside.collect::<Result<Vec<_>, std::io::Error>>()?);
        } else if path.extension().is_some_and(|found| found == extension) {
            let name = path.strip_prefix(&root)?.to_string_lossy().into_owned();
            found.push((name, fs::read_to_string(path)?));
        }
    }
    Ok(found)
}

/// Returns the sources of the crates and of the library of these tests.
fn sources() -> Result<Vec<(String, String)>, Box<dyn Error>> {
    let mut sources = files(&["crates", "tests/src"], "rs")?;
    sources.retain(|(name, _)| name.contains("src/"));
    Ok(sources)
}

/// Returns every Markdown page.
fn pages() -> Result<Vec<(String, String)>, Box<dyn Error>> {
    files(&["README.md", "CHANGELOG.md", "docs", "crates"], "md")
}

/// Returns the rustdoc comments of a file as Markdown, one for each run of lines.
fn comments(source: &str) -> Vec<String> {
    let mut comments = vec![String::new()];
    for line in source.lines().map(str::trim_start) {
        match line.strip_prefix("///").or_else(|| line.strip_prefix("//!")) {
            Some(text) => {
                if let Some(comment) = comments.last_mut() {
                    comment.push_str(text.strip_prefix(' ').unwrap_or(text));
                    comment.push('\n');
                }
            }
            None if comments.last().is_some_and(|comment| !comment.is_empty()) => {
                comments.push(String::new());
            }
            None => {}
        }
    }
    comments
}

fn events(markdown: &str) -> impl Iterator<Item = Event<'_>> {
    Parser::new_ext(markdown, Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH)
}

/// Returns the lines with a combining mark.
fn combining_marks(text: &str) -> Vec<&str> {
    let combining = |c| matches!(c, '\u{300}'..='\u{36f}' | '\u{20d0}'..='\u{20ff}');
    text.lines().filter(|line| line.contains(combining)).collect()
}

/// Returns the paragraphs, cells and formulas in `text` blocks with a raw subscript or superscript of TeX, outside code.
fn raw_tex(markdown: &str) -> Vec<String> {
    let (mut found, mut text, mut code) = (Vec::new(), String::new(), false);
    for event in events(markdown) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                code = *language != *"text"
            }
            Event::Start(Tag::CodeBlock(_)) => code = true,
            Event::Text(part) if !code => text.push_str(&part),
            // An element between two pieces of text keeps them apart.
            Event::Code(_) => text.push('`'),
            Event::SoftBreak | Event::HardBreak => text.push('\n'),
            Event::End(
                TagEnd::Paragraph
                | TagEnd::TableCell
                | TagEnd::Item
                | TagEnd::Heading(_)
                | TagEnd::CodeBlock,
            ) => {
                code = false;
                if text.contains("_{") || text.contains("^{") {
                    found.push(text.clone());
                }
                text.clear();
            }
            _ => {}
        }
    }
    found
}

/// Returns the rows of tables in which Markdown finds emphasis, strong emphasis where that counts too, deleted text
/// or HTML: their markers are not shown.
fn emphasised_rows(markdown: &str, strong: bool) -> Vec<String> {
    let (mut found, mut row, mut inside, mut lost) = (Vec::new(), String::new(), false, false);
    for event in events(markdown) {
        match event {
            Event::Start(Tag::TableRow | Tag::TableHead) => inside = true,
            Event::End(TagEnd::TableRow | TagEnd::TableHead) => {
                if lost {
                    found.push(row.clone());
                }
                row.clear();
                (inside, lost) = (false, false);
            }
            Event::Text(part) | Event::Code(part) if inside => row.push_str(&part),
            Event::End(TagEnd::TableCell) => row.push_str(" | "),
            Event::Start(Tag::Emphasis | Tag::Strikethrough) | Event::InlineHtml(_) => {
                lost |= inside
            }
            Event::Start(Tag::Strong) => lost |= inside && strong,
            _ => {}
        }
    }
    found
}

#[test]
fn no_combining_marks_in_the_documentation() -> Result<(), Box<dyn Error>> {
    let pages = pages()?;
    assert!(pages.len() > 12, "only {} pages", pages.len());
    for (name, text) in &pages {
        assert_eq!(combining_marks(text), [""; 0], "{name}");
    }
    for (name, text) in sources()? {
        for comment in comments(&text) {
            assert_eq!(combining_marks(&comment), [""; 0], "{name}");
        }
    }
    // Negative control: a dot, a bar and a hat above, and letters that contain such marks.
    for mark in ['\u{307}', '\u{304}', '\u{302}', '\u{20d7}'] {
        let source = format!("/// dΓ/dt,\n/// not Γ{mark}\nfn f() {{}}\n");
        assert_eq!(comments(&source).iter().map(|c| combining_marks(c).len()).sum::<usize>(), 1);
    }
    assert!(combining_marks("Störmer, Poincaré, â").is_empty());
    Ok(())
}

#[test]
fn no_raw_tex_in_the_documentation() -> Result<(), Box<dyn Error>> {
    for (name, text) in pages()? {
        assert_eq!(raw_tex(&text), [""; 0], "{name}");
    }
    let sources = sources()?;
    let all: usize = sources.iter().map(|(_, text)| comments(text).len()).sum();
    assert!(sources.len() > 60 && all > 300, "only {all} comments of {} files", sources.len());
    for (name, text) in sources {
        for comment in comments(&text) {
            assert_eq!(raw_tex(&comment), [""; 0], "{name}");
        }
    }
    // Negative control: text, a cell, a list and a formula; and code, in which braces are allowed.
    let shown = "//! Φ_{gh} = id\n\nfn f() {}\n/// * δ_k/δ_{k−1}\n/// | e^{is} |\n/// |---|\n/// | X_{h∘M} |\n";
    assert_eq!(comments(shown).iter().map(|comment| raw_tex(comment).len()).sum::<usize>(), 2);
    let cells = "| e^{is} |\n|---|\n| X_{h∘M} |\n";
    assert_eq!(raw_tex(cells).len(), 2);
    assert_eq!(raw_tex("Φ is\n\n```text\nΦ_{gh}\n```\n").len(), 1);
    let code = "`Φ_{gh}`\n\n```rust\nformat!(\"Φ_{gh}\");\n```\n\nΦ_gh, Φ(e^(is))\n";
    assert_eq!(raw_tex(code), [""; 0]);
    Ok(())
}

#[test]
fn no_row_of_a_table_loses_its_subscripts() -> Result<(), Box<dyn Error>> {
    let mut rows = 0;
    for (name, text) in files(&["docs"], "md")? {
        // Elsewhere strong text is intended: our own names among those of peers.
        assert_eq!(emphasised_rows(&text, name.ends_with("notation.md")), [""; 0], "{name}");
        rows += events(&text).filter(|event| matches!(event, Event::Start(Tag::TableRow))).count();
    }
    assert!(rows > 400, "only {rows} rows");
    // Negative control: a star and underscores that are not escaped, and the same where they are.
    let table = |cell: &str| format!("| a | b |\n|---|---|\n| {cell} | c |\n");
    for lost in ["−ad\\*_{dh} μ, +ad\\*_{dh} μ", "T*Φ, Ad*Φ", "V<T>", "~~x~~"] {
        assert_eq!(emphasised_rows(&table(lost), false).len(), 1, "{lost}");
    }
    assert_eq!(emphasised_rows(&table("**minus**"), true).len(), 1);
    for kept in
        ["ad∗\\_[ξ,η] = −[ad∗\\_ξ, ad∗\\_η]", "Φ_g ∘ Φ_h = Φ_gh", "`ad*_ξ ad*_η`", "**minus**"]
    {
        assert_eq!(emphasised_rows(&table(kept), false), [""; 0]);
    }
    Ok(())
}
