//! The suggestion for a misspelt command.

use super::arguments::Arguments;
use crate::vocabulary::suggestion::nearest;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue};

/// Adds to an error about a command that there is not the command most like it, as after `help simulat`, unless the
/// error has a suggestion.
pub(super) fn suggest_command(error: &mut clap::Error) {
    let Some(ContextValue::String(typed)) = error.get(ContextKind::InvalidSubcommand) else {
        return;
    };
    if error.get(ContextKind::SuggestedSubcommand).is_some() {
        return;
    }
    let program = Arguments::command();
    let names = program.get_subcommands().map(clap::Command::get_name);
    let Some(name) = nearest(typed, names) else { return };
    let names = ContextValue::Strings(vec![name.to_owned()]);
    error.insert(ContextKind::SuggestedSubcommand, names);
}
