//! Texts of help in so many columns.

use super::blocks::{Block, Line};

/// The least number of columns of a text beside its term.
const LEAST: usize = 24;

/// Returns the text in so many columns. A text that fits stays as it is.
pub(crate) fn fitted(text: &str, columns: usize) -> String {
    if text.lines().all(|line| line.chars().count() <= columns) {
        return text.into();
    }
    let blocks = Block::all_of(text);
    let lines = blocks.iter().flat_map(|block| of_block(block, columns));
    lines.map(|line| line + "\n").collect::<String>()
}

/// Returns the lines of a part of a text in so many columns.
pub(crate) fn of_block(block: &Block, columns: usize) -> Vec<String> {
    match block {
        Block::Blank => vec![String::new()],
        Block::Paragraph(text) => wrapped(text, columns, 0, ""),
        Block::Line(line) => of_line(line, columns),
    }
}

fn of_line(line: &Line, columns: usize) -> Vec<String> {
    let Line { indent, term, column, text, .. } = line;
    let end = indent + term.chars().count();
    let mark = if line.is_comment { "# " } else { "" };
    let own = format!("{}{term}", " ".repeat(*indent));
    if text.is_empty() {
        return of_term(line, columns);
    }
    if end + 2 <= *column && column + LEAST <= columns {
        let mut beside = wrapped(text, columns, *column, mark);
        if let Some(first) = beside.first_mut() {
            first.replace_range(..*column, &format!("{own:<column$}"));
        }
        return beside;
    }
    let mut lines = of_term(line, columns);
    lines.extend(wrapped(text, columns, indent + 4, mark));
    lines
}

/// Returns the lines of a term, which go on farther right.
fn of_term(Line { indent, term, .. }: &Line, columns: usize) -> Vec<String> {
    let line = Line {
        indent: *indent,
        term: term.clone(),
        column: 0,
        text: String::new(),
        is_comment: false,
    };
    if line.is_command() {
        // The sign by which a shell goes on reading on the next line.
        let mut lines = wrapped(term, columns.saturating_sub(2), *indent, "");
        let last = lines.len().saturating_sub(1);
        for (number, line) in lines.iter_mut().enumerate() {
            let deeper = if number > 0 { "    " } else { "" };
            let more = if number < last { " \\" } else { "" };
            *line = format!("{}{deeper}{}{more}", " ".repeat(*indent), line.trim_start());
        }
        if lines.iter().all(|line| line.chars().count() <= columns) {
            return lines;
        }
        return wrapped(term, columns, *indent, "");
    }
    match term.strip_prefix("# ") {
        Some(comment) => wrapped(comment, columns, *indent, "# "),
        None => wrapped(term, columns, *indent, ""),
    }
}

/// Returns lines of at most so many columns, each with an indentation and a mark.
fn wrapped(text: &str, columns: usize, indent: usize, mark: &str) -> Vec<String> {
    let indent = indent.min(columns - LEAST.min(columns / 2));
    let start = format!("{}{mark}", " ".repeat(indent));
    let room = columns.saturating_sub(start.chars().count()).max(1);
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split(' ').filter(|word| !word.is_empty()).flat_map(|word| pieces(word, room))
    {
        let count = word.chars().count();
        match lines.last_mut() {
            Some(line) if line.is_empty() => *line += &word,
            Some(line) if line.chars().count() + 1 + count <= room => {
                *line += " ";
                *line += &word;
            }
            _ => lines.push(word),
        }
    }
    lines.into_iter().map(|line| format!("{start}{line}")).collect()
}

/// Returns a word in pieces of at most so many characters, which end after signs within the word where they can.
fn pieces(word: &str, room: usize) -> Vec<String> {
    let mut rest: Vec<char> = word.chars().collect();
    let mut pieces = Vec::new();
    while rest.len() > room {
        let sign = rest[..room].iter().rposition(|c| "/,=|".contains(*c));
        let after = rest.split_off(sign.map_or(room, |sign| sign + 1));
        pieces.push(rest.into_iter().collect());
        rest = after;
    }
    pieces.push(rest.into_iter().collect());
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_fitted_to_the_columns() {
        let text = "A text that is somewhat longer than that.\n\nNames:\n  name      what it is, in words that go on\n            and on\n  \
                    x = 1     # a comment that goes on and on\n  heavytop simulate top.toml --out a.csv\n";
        let expected = "A text that is somewhat\nlonger than that.\n\nNames:\n  name\n      what it is, in words\n      \
                        that go on and on\n  x = 1\n      # a comment that goes\n      # on and on\n  heavytop simulate \\\n      \
                        top.toml --out a.csv\n";
        assert_eq!(fitted(text, 28), expected);
        assert_eq!(fitted(text, 60), text);
        let beside = "  name      what it is, in words that go\n            on and on\n";
        assert!(fitted(text, 40).contains(beside), "{}", fitted(text, 40));
    }

    /// The texts are written for a terminal of 100 columns, where they stay as they are.
    #[test]
    fn the_texts_fit_100_columns() {
        use crate::interface::help;
        for text in [
            help::REPRODUCE,
            help::REPRODUCE_EXAMPLES,
            help::SIMULATE,
            help::SIMULATE_EXAMPLES,
            help::COMPARE,
            help::COMPARE_EXAMPLES,
            help::ENSEMBLE,
            help::ENSEMBLE_EXAMPLES,
            help::EVENTS,
            help::EVENTS_EXAMPLES,
            help::SECTION,
            help::SECTION_EXAMPLES,
            help::SWEEP,
            help::SWEEP_EXAMPLES,
            help::ANIMATE,
            help::ANIMATE_EXAMPLES,
            help::BENCH,
            help::BENCH_EXAMPLES,
            help::REPORT,
            help::REPORT_EXAMPLES,
            help::INIT_EXAMPLES,
            help::MAN_EXAMPLES,
            help::COMPLETIONS_EXAMPLES,
            help::EXIT_CODES,
        ] {
            let long = text.lines().find(|line| line.chars().count() > 100);
            assert_eq!(long, None);
            assert_eq!(fitted(text, 100), text);
        }
    }

    #[test]
    fn no_line_is_longer_than_the_columns() {
        use crate::interface::help;
        for text in [
            help::SIMULATE,
            help::SIMULATE_EXAMPLES,
            help::SWEEP_EXAMPLES,
            help::COMPLETIONS_EXAMPLES,
        ] {
            for columns in [20, 40, 60, 80] {
                let fitted = fitted(text, columns);
                let longest = fitted.lines().map(|line| line.chars().count()).max();
                assert!(longest <= Some(columns), "{columns}: {fitted}");
                // No word is lost.
                let words = |text: &str| {
                    text.chars()
                        .filter(|c| !c.is_whitespace() && !"#\\".contains(*c))
                        .collect::<String>()
                };
                assert_eq!(words(&fitted), words(text));
            }
        }
    }
}
