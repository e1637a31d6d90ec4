//! The page, with all that it needs inside it.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

const PAGE: &str = include_str!("../../web/page.html");

/// The style. Its colours are those of the pages of `heavytop animate`.
const STYLE: &str = concat!(
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/palette.css"),
    include_str!("../../web/page.css"),
);

/// The script that runs before anything is drawn.
const THEME: &str = include_str!("../../../heavytop-cli/src/commands/animate/page/common/theme.js");

/// The other scripts, in the order in which they need each other. The first ones are those of `heavytop animate`.
const SCRIPTS: &[&str] = &[
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/numbers.js"),
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/vectors.js"),
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/camera.js"),
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/ellipsoid.js"),
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/scene.js"),
    include_str!("../../../heavytop-cli/src/commands/animate/page/common/pointers.js"),
    include_str!("../../web/library.js"),
    include_str!("../../web/catalogue.js"),
    include_str!("../../web/charts/canvas.js"),
    include_str!("../../web/charts/deviation_chart.js"),
    include_str!("../../web/charts/section_chart.js"),
    include_str!("../../web/charts/invariant_table.js"),
    include_str!("../../web/form.js"),
    include_str!("../../web/frame_counter.js"),
    include_str!("../../web/player.js"),
    include_str!("../../web/main.js"),
];

/// Returns the page with the module in it.
pub fn assemble(module: &[u8]) -> String {
    let script = SCRIPTS.concat();
    let texts = [("style", STYLE), ("theme", THEME), ("script", &script)];
    let page = texts
        .iter()
        .fold(PAGE.to_owned(), |page, (name, text)| page.replace(&format!("{{{{{name}}}}}"), text));
    page.replace("{{module}}", &BASE64_STANDARD.encode(module))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_complete_and_loads_nothing() {
        let page = assemble(b"\0asm");
        assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
        assert!(page.contains("AGFzbQ=="));
        for loading in ["{{", "http:", "https:", "//cdn", " src=", "@import", "url(", "fetch("] {
            assert_eq!(page.matches(loading).count(), 0, "{loading}");
        }
        // Control: the search finds a reference where there is one.
        assert!(page.replace("<style>", "<style>@import").contains("@import"));
    }
}
