//! Texts, as UTF-8 in memory.
#![allow(unsafe_code, reason = "names without mangling are the interface of a WebAssembly module")]

use crate::exports::desk::with;
use crate::motions::page_method::PageMethod;

/// Returns the address of the text.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn text() -> *const u8 {
    with(std::ptr::null(), |desk| desk.text.as_ptr())
}

/// Returns the length of the text, in bytes.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn text_length() -> usize {
    with(0, |desk| desk.text.len())
}

/// Sets the text to the symbols and units of the invariants, one a line.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn describe_invariants() {
    with((), |desk| {
        let invariants = desk.simulation.iter().flat_map(|top| top.invariants());
        let lines = invariants.map(|i| format!("{} {}", i.symbol(), i.unit()));
        desk.text = lines.collect::<Vec<_>>().join("\n");
    });
}

/// Sets the text to the names of the methods, one a line.
#[cfg_attr(target_arch = "wasm32", unsafe(no_mangle))]
pub extern "C" fn describe_methods() {
    with((), |desk| desk.text = PageMethod::ALL.map(PageMethod::name).join("\n"));
}
