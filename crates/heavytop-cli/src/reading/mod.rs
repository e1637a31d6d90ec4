//! Reading of configurations: files, standard input and assignments on the command line, and quotations of what is
//! wrong in them.

mod key_path;
mod plain_words;
mod readable_text;
mod hints;
mod formula_place;
mod configuration_text;
mod assignment;
mod repair;
mod sources;

pub use sources::Sources;
