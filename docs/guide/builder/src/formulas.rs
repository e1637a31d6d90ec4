//! Formulas in LaTeX, between lines of `$$`, as MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// Returns the page with each formula between two lines `$$` as MathML.
///
/// # Errors
/// If a formula is not ended, or is not LaTeX.
pub fn typeset(page: &str) -> Result<String, String> {
    let mut typeset = String::with_capacity(page.len());
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if line != "$$" {
            typeset += line;
            typeset.push('\n');
            continue;
        }
        let mut formula = String::new();
        loop {
            match lines.next() {
                Some("$$") => break,
                Some(line) => formula = formula + line + "\n",
                None => return Err(format!("a formula is not ended: {formula}")),
            }
        }
        typeset += &mathml(&formula)?;
        typeset.push('\n');
    }
    Ok(typeset)
}

fn mathml(formula: &str) -> Result<String, String> {
    let storage = Storage::new();
    // The renderer would draw an error into the page.
    let events = Parser::new(formula, &storage)
        .collect::<Result<Vec<_>, _>>()
        .map_err(|error| format!("{formula}{error}"))?;
    let config = RenderConfig { display_mode: DisplayMode::Block, ..RenderConfig::default() };
    let mut mathml = String::new();
    push_mathml(&mut mathml, events.into_iter().map(Ok::<_, std::fmt::Error>), config)
        .map_err(|error| format!("{formula}{error}"))?;
    // A blank line would end the block of HTML.
    Ok(mathml.replace('\n', " "))
}

#[cfg(test)]
mod tests {
    use super::typeset;

    #[test]
    fn a_formula_becomes_mathml() {
        let page = typeset("a\n$$\n\\dot\\Pi = \\Pi \\times \\Omega\n$$\nb\n").unwrap();
        assert!(page.starts_with("a\n<math display=\"block\">") && page.ends_with("</math>\nb\n"));
        assert!(page.contains("Π") && page.contains("Ω"));
    }

    #[test]
    fn what_is_no_formula_is_an_error() {
        assert!(typeset("$$\n\\frac{1}\n$$\n").is_err());
        assert!(typeset("$$\n\\nonsense\n$$\n").is_err());
        assert!(typeset("$$\nx\n").is_err());
        // Negative control
        assert_eq!(typeset("no formula\n").unwrap(), "no formula\n");
    }
}
