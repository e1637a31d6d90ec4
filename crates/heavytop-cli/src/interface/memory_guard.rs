//! What happens where there is no more memory.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// The system's memory, to be made the program's allocator. A run that can have no more of it ends with a message and exit code 1, as if a
/// disk were full. Without this allocator Rust would abort, whoever had asked for the memory.
///
/// Files are left as by a kill: what was complete is whole, and what was kept can be resumed.
#[derive(Debug)]
pub struct MemoryGuard;

impl MemoryGuard {
    /// Passes on what the system has given, unless that is nothing.
    fn given(pointer: *mut u8, bytes: usize) -> *mut u8 {
        if pointer.is_null() {
            end(bytes);
        }
        pointer
    }
}

/// Ends the process; once, for the end may itself ask for memory.
#[cold]
fn end(bytes: usize) {
    static ENDING: AtomicBool = AtomicBool::new(false);
    if !ENDING.swap(true, Ordering::Relaxed) {
        // Neither formatting nor stderr asks for memory.
        let _ = writeln!(
            io::stderr(),
            "heavytop: out of memory: {bytes} more bytes cannot be had; what simulate, section and \
             sweep have kept can be resumed with --resume"
        );
        std::process::exit(1);
    }
}

// SAFETY: every call is passed to the system's allocator as it is, and so is what that returns.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for MemoryGuard {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise is the one asked for.
        Self::given(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        Self::given(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, bytes: usize) -> *mut u8 {
        // SAFETY: as above.
        Self::given(unsafe { System.realloc(pointer, layout, bytes) }, bytes)
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}
