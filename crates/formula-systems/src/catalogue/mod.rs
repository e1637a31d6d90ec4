//! Systems by name: each in a file of its own, and in the list `SystemKind::ALL`.

pub(crate) mod system_kind;
mod body_with_rotors;
mod all;
