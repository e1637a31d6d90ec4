//! The parts of a text of help: paragraphs, the lines of tables and of examples, and empty lines.
//!
//! The texts are written for a terminal of 100 columns. Narrower ones and manual pages need their parts.

/// A part of a text of help.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Block {
    /// An empty line.
    Blank,
    /// Lines without indentation, joined.
    Paragraph(String),
    /// A line of a table or of an example, in two columns if it has `text`.
    Line(Line),
}

/// An indented line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    /// The number of spaces before the term.
    pub indent: usize,
    /// The first column: a name, a line of a configuration, or a command.
    pub term: String,
    /// The column in which the text begins; 0 if there is none.
    pub column: usize,
    /// The second column, with its continuation on the lines below; a comment without the sign `#`.
    pub text: String,
    /// Whether the text is a comment.
    pub is_comment: bool,
}

/// The number of columns by which the continuation of a line is indented more, at least.
const CONTINUED: usize = 10;

impl Block {
    /// Returns the parts of a text.
    pub(crate) fn all_of(text: &str) -> Vec<Self> {
        let mut blocks: Vec<Self> = Vec::new();
        for line in text.lines() {
            let content = line.trim();
            let indent = line.chars().take_while(|c| *c == ' ').count();
            match blocks.last_mut() {
                _ if content.is_empty() => blocks.push(Self::Blank),
                Some(Self::Paragraph(before)) if indent == 0 && !before.ends_with(':') => {
                    *before += " ";
                    *before += content;
                }
                _ if indent == 0 => blocks.push(Self::Paragraph(content.into())),
                Some(Self::Line(before)) if before.goes_on(indent) => before.add(indent, content),
                _ => blocks.push(Self::Line(Line::of(indent, content))),
            }
        }
        blocks
    }
}

impl Line {
    fn of(indent: usize, content: &str) -> Self {
        let (term, rest) = content.split_once("  ").unwrap_or((content, ""));
        let text = rest.trim_start();
        let column = match text.is_empty() {
            true => 0,
            false => indent + content.chars().count() - text.chars().count(),
        };
        let is_comment = text.starts_with('#');
        let text = text.trim_start_matches('#').trim_start().to_owned();
        Self { indent, term: term.into(), column, text, is_comment }
    }

    /// Returns whether a line with so much indentation belongs to this one.
    fn goes_on(&self, indent: usize) -> bool {
        if self.text.is_empty() { indent >= self.indent + CONTINUED } else { indent == self.column }
    }

    fn add(&mut self, indent: usize, content: &str) {
        if self.text.is_empty() {
            self.column = indent;
            self.is_comment = content.starts_with('#');
        } else {
            self.text += " ";
        }
        self.text += content.trim_start_matches('#').trim_start();
    }

    /// Returns whether the line is of an example: a command, or a line of a configuration with a comment.
    pub(crate) fn is_code(&self) -> bool {
        self.is_comment || self.is_command() || self.term.starts_with(['[', '#', '{', '\''])
    }

    /// Returns whether the line is a command for a shell.
    pub(crate) fn is_command(&self) -> bool {
        let first = self.term.split(' ').next().unwrap_or_default();
        ["heavytop", "sed", "mpirun"].contains(&first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parts_of_a_text_are_told_apart() {
        let text = "One\ntwo.\n\nNames:\n  a    first\n       second\n  b.toml\n              third\n\
                    Examples:\n  x = 1       # one\n              # two\n  heavytop help";
        let line = |term: &str, column, text: &str, is_comment| {
            let (term, text) = (term.into(), text.into());
            Block::Line(Line { indent: 2, term, column, text, is_comment })
        };
        let expected = [
            Block::Paragraph("One two.".into()),
            Block::Blank,
            Block::Paragraph("Names:".into()),
            line("a", 7, "first second", false),
            line("b.toml", 14, "third", false),
            Block::Paragraph("Examples:".into()),
            line("x = 1", 14, "one two", true),
            line("heavytop help", 0, "", false),
        ];
        assert_eq!(Block::all_of(text), expected);
    }
}
