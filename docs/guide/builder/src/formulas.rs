//! Formulas in LaTeX, in blocks of code with the language `math`, as MathML.

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// Returns the page with each block of code in the language `math` as MathML.
///
/// # Errors
/// If a formula is not ended, or is not LaTeX.
pub fn typeset(page: &str) -> Result<String, String> {
    let mut typeset = String::with_capacity(page.len());
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if line != "```math" {
            typeset += line;
            typeset.push('\n');
            continue;
        }
        let mut formula = String::new();
        loop {
            match lines.next() {
                Some("```") => break,
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
    // A blank line would end the block of HTML. Browsers slant the Greek letter mu, and not the micro sign.
    Ok(mathml.replace('\n', " ").replace('\u{b5}', "\u{3bc}"))
}

#[cfg(test)]
mod tests {
    use super::typeset;

    #[test]
    fn a_formula_becomes_mathml() {
        let page = typeset("a\n```math\n\\dot\\Pi = \\mu \\times \\Omega\n```\nb\n").unwrap();
        assert!(page.starts_with("a\n<math display=\"block\">") && page.ends_with("</math>\nb\n"));
        assert!(["Π", "μ", "Ω"].iter().all(|letter| page.contains(letter)));
    }

    #[test]
    fn what_is_no_formula_is_an_error() {
        assert!(typeset("```math\n\\frac{1}\n```\n").is_err());
        assert!(typeset("```math\n\\nonsense\n```\n").is_err());
        assert!(typeset("```math\nx\n").is_err());
        // Negative control
        let code = "no formula\n```rust\nlet x = 1;\n```\n";
        assert_eq!(typeset(code).unwrap(), code);
    }
}
