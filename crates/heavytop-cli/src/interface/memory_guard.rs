//! The allocator that ends the program with a message when memory runs out.

use std::alloc::{GlobalAlloc, Layout, System};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// An allocator for the program that uses the system's memory and, when there is no more, ends the process with a
/// message.
///
/// The exit code is then 1, as if a disk were full. Rust's default is to abort the process.
///
/// Files are left as by a kill: what was complete stays complete, and what was kept can be resumed.
#[derive(Debug)]
pub struct MemoryGuard;

impl MemoryGuard {
    /// Passes on the system's answer, unless the system has no memory left.
    fn given(pointer: *mut u8, bytes: usize) -> *mut u8 {
        if pointer.is_null() {
            end(bytes);
        }
        pointer
    }
}

/// Ends the process with a message, once only, since ending may itself ask for memory.
#[cold]
fn end(bytes: usize) {
    static ENDING: AtomicBool = AtomicBool::new(false);
    if !ENDING.swap(true, Ordering::Relaxed) {
        // Neither formatting nor stderr allocates memory.
        let _ = writeln!(
            io::stderr(),
            "heavytop: out of memory: {bytes} more bytes cannot be had; what simulate, section and \
             sweep have kept can be resumed with --resume"
        );
        std::process::exit(1);
    }
}

// SAFETY: every call is passed to the system's allocator unchanged, and so is what that returns.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for MemoryGuard {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promise is the one that the system's allocator requires.
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
