//! The same in several languages: the blocks of code between two comments, as tabs.

const BEGIN: &str = "<!-- tabs -->\n";
const END: &str = "<!-- end of tabs -->\n";

/// Returns the page with the blocks of code between the comments as tabs, of which a browser shows one. `chapter` tells
/// the tabs of one chapter from those of others.
///
/// # Errors
/// If the tabs are not ended, or are in a language that has no title.
pub fn tabbed(page: &str, chapter: &str) -> Result<String, String> {
    let mut parts = page.split(BEGIN);
    let mut tabbed = parts.next().unwrap_or_default().to_owned();
    for (group, part) in parts.enumerate() {
        let (blocks, rest) = part.split_once(END).ok_or("tabs are not ended")?;
        tabbed += "<div class=\"tabs\">\n";
        for (tab, block) in blocks.trim().split_inclusive("\n```\n").map(str::trim).enumerate() {
            let language = block.lines().next().unwrap_or_default();
            let title = match language {
                "```sh" => "Terminal",
                "```python" => "Python",
                "```rust" => "Rust",
                _ => return Err(format!("a tab has the language {language}")),
            };
            let name =
                format!("tabs-{chapter}-{group}").replace(|c: char| !c.is_alphanumeric(), "-");
            let checked = if tab == 0 { " checked" } else { "" };
            tabbed += &format!(
                "<input type=\"radio\" name=\"{name}\" id=\"{name}-{tab}\"{checked}>\n\
                 <label for=\"{name}-{tab}\">{title}</label>\n<div>\n\n{block}\n\n</div>\n"
            );
        }
        tabbed = tabbed + "</div>\n" + rest;
    }
    Ok(tabbed)
}

#[cfg(test)]
mod tests {
    use super::tabbed;

    #[test]
    fn blocks_of_code_become_tabs() {
        let page = "a\n<!-- tabs -->\n```sh\nb\n```\n\n```rust\nc\n```\n<!-- end of tabs -->\nd\n";
        let page = tabbed(page, "A top").unwrap();
        assert_eq!(page.matches("<input").count(), 2);
        assert_eq!(page.matches("checked").count(), 1);
        assert!(
            page.contains(">Terminal<")
                && page.contains("\n```rust\nc\n```\n\n</div>\n</div>\nd\n")
        );
        assert!(page.contains("\"tabs-A-top-0-1\""));
        // Negative controls
        assert!(tabbed("<!-- tabs -->\n```sh\n```\n", "A top").is_err());
        assert!(tabbed("<!-- tabs -->\n```c\n```\n<!-- end of tabs -->\n", "A top").is_err());
        assert_eq!(tabbed("```sh\nb\n```\n", "A top").unwrap(), "```sh\nb\n```\n");
    }
}
