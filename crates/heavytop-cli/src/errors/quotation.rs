//! A quotation of a configuration: a place, its line, and a mark under the value.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::fmt;
use std::ops::Range;

/// The width to which quoted lines are cut.
const WIDTH: usize = 80;

/// A place in a configuration, and the quoted line with a mark under the value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quotation {
    /// The name of the text: a path, or the option or stream from which it comes.
    name: String,
    /// The line, from 1.
    line: usize,
    /// The column in characters, from 1.
    column: usize,
    /// The quoted line, the mark and the note beside it.
    excerpt: String,
}

impl Quotation {
    /// Quotes the line in which a span of the text begins. The note stands beside the mark.
    ///
    /// # Example
    /// ```
    /// use heavytop_cli::errors::Quotation;
    /// let quotation = Quotation::new("top.toml", "[body]\nmass = -1", 14..16, "write 1");
    /// assert_eq!(quotation.to_string(), "top.toml, line 2, column 8");
    /// let lines: Vec<&str> = quotation.excerpt().lines().collect();
    /// assert_eq!(lines, ["  |", "2 | mass = -1", "  |        ^^ write 1"]);
    /// ```
    #[must_use]
    pub fn new(name: &str, text: &str, span: Range<usize>, note: &str) -> Self {
        let before = text.get(..span.start).unwrap_or(text);
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let rest = text.get(line_start..).unwrap_or_default();
        let quoted = rest.split('\n').next().unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        // A value that goes on after the line, or is missing at its end, is marked on the line alone.
        let start = before.len() - line_start;
        let end = span.end.saturating_sub(line_start).clamp(start, quoted.len().max(start));
        Self {
            name: name.into(),
            line,
            column: before.get(line_start..).unwrap_or_default().chars().count() + 1,
            excerpt: excerpt(quoted, line, start..end, note),
        }
    }

    /// Returns the name of the text, the line and the column, both from 1.
    #[must_use]
    pub fn place(&self) -> (&str, usize, usize) {
        (&self.name, self.line, self.column)
    }

    /// Returns the quoted line, the mark under the value and the note beside it, as lines of text.
    #[must_use]
    pub fn excerpt(&self) -> &str {
        &self.excerpt
    }
}

impl fmt::Display for Quotation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name.starts_with("--") {
            // An option has one line, which is quoted.
            true => write!(f, "{}", self.name),
            false => write!(f, "{}, line {}, column {}", self.name, self.line, self.column),
        }
    }
}

fn excerpt(quoted: &str, line: usize, span: Range<usize>, note: &str) -> String {
    let note = (!note.is_empty()).then_some(note);
    let mark = AnnotationKind::Primary.span(span).label(note);
    let snippet = Snippet::source(quoted).line_start(line).annotation(mark);
    let group = Group::with_level(Level::ERROR).element(snippet);
    let rendered =
        Renderer::plain().decor_style(DecorStyle::Ascii).term_width(WIDTH).render(&[group]);
    rendered.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
}
