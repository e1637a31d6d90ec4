//! Macros for structures of vectors, in this crate and in others.

mod inlined;
mod operators;
mod parts;
