//! The command `man`: manual pages.

use super::arguments::Arguments;
use super::help::blocks::Block;
use super::help::layout::of_block;
use super::standard_output::to_stdout;
use crate::errors::Error;
use clap::CommandFactory;
use clap_mangen::Man;
use clap_mangen::roff::{Roff, bold, roman};
use std::io::{self, Write};

/// The columns of examples, beside the margin of a page in a terminal of 80 columns.
const COLUMNS: usize = 72;

/// Prints the manual page of the program, or of one of its commands.
///
/// # Errors
/// If there is no such command, or the page cannot be printed.
pub(super) fn man(command: Option<&str>) -> Result<(), Error> {
    let mut program = Arguments::command();
    // The commands get their full names, `heavytop simulate`, and the options of the whole program.
    program.build();
    let page = match command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            let names = program.get_subcommands().map(|known| known.get_name().to_string());
            Error::NoCommand { name: name.into(), names: names.collect() }
        })?,
    };
    let mut text = Vec::new();
    let rendered = render(page, &mut text);
    to_stdout(rendered.and_then(|()| io::stdout().lock().write_all(&text)))
}

/// Writes the page of a command.
fn render(command: clap::Command, to: &mut Vec<u8>) -> io::Result<()> {
    let text_of = |text: Option<&clap::builder::StyledStr>| text.map(ToString::to_string);
    let description = text_of(command.get_long_about().or_else(|| command.get_about()));
    let notes = text_of(command.get_after_long_help().or_else(|| command.get_after_help()));
    let (has_commands, has_version) = (command.has_subcommands(), command.get_version().is_some());
    let man = Man::new(command);
    man.render_title(to)?;
    // Formulas and options are easier to read where the right margin is ragged and no word is broken.
    writeln!(to, ".ad l\n.nh")?;
    man.render_name_section(to)?;
    man.render_synopsis_section(to)?;
    section("DESCRIPTION", &description.unwrap_or_default()).to_writer(to)?;
    man.render_options_section(to)?;
    if has_commands {
        man.render_subcommands_section(to)?;
    }
    section("NOTES", &notes.unwrap_or_default()).to_writer(to)?;
    if has_version {
        man.render_version_section(to)?;
    }
    Ok(())
}

/// Returns a text of help as sections of a page. A paragraph of one or two words with a colon, such as `Examples:`,
/// begins a section of its own.
fn section(title: &str, text: &str) -> Roff {
    let mut page = Roff::new();
    let blocks = Block::all_of(text);
    let mut is_titled = false;
    for group in blocks.split(|block| *block == Block::Blank) {
        for (number, block) in group.iter().enumerate() {
            if let Some(title) = title_of(block) {
                page.control("SH", [title.to_uppercase().as_str()]);
                is_titled = true;
                continue;
            }
            if !std::mem::replace(&mut is_titled, true) {
                page.control("SH", [title]);
            }
            let is_code =
                |other: Option<&Block>| matches!(other, Some(Block::Line(_))) && is_example(group);
            match block {
                Block::Paragraph(text) => {
                    page.control("PP", []);
                    page.text([roman(text)]);
                }
                Block::Line(_) if is_code(Some(block)) => {
                    let before = number.checked_sub(1).and_then(|before| group.get(before));
                    if !is_code(before) {
                        page.control("PP", []);
                        page.control("nf", []);
                    }
                    of_block(block, COLUMNS)
                        .into_iter()
                        .for_each(|line| _ = page.text([roman(line)]));
                    if !is_code(group.get(number + 1)) {
                        page.control("fi", []);
                    }
                }
                Block::Line(line) => {
                    page.control("TP", []);
                    page.text([bold(line.term.as_str())]);
                    page.text([roman(line.text.as_str())]);
                }
                Block::Blank => {}
            }
        }
    }
    page
}

/// Returns the title of a section, if the part of the text is one.
fn title_of(block: &Block) -> Option<&str> {
    match block {
        Block::Paragraph(text) => {
            text.strip_suffix(':').filter(|title| title.split(' ').count() <= 2)
        }
        _ => None,
    }
}

/// Returns whether the lines of a group are those of an example, and not of a table.
fn is_example(group: &[Block]) -> bool {
    group.iter().any(|block| matches!(block, Block::Line(line) if line.is_code()))
}
