//! The switch of the changes: `CHANGE` is the number of one, or `note`, to append those that are reached to `CHANGES_REACHED`.
#![allow(missing_docs, dead_code)]

extern crate std;
use core::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};
use std::io::Write;

const UNREAD: u32 = u32::MAX;
const NOTE: u32 = u32::MAX - 1;
const NONE: u32 = u32::MAX - 2;
const MOST: usize = 1 << 16;

static CHANGE: AtomicU32 = AtomicU32::new(UNREAD);
static REACHED: [AtomicBool; MOST] = [const { AtomicBool::new(false) }; MOST];

#[inline(always)]
pub fn on(number: u32) -> bool {
    let change = CHANGE.load(Relaxed);
    if change < NONE { change == number } else { rarely(number, change) }
}

#[cold]
#[inline(never)]
fn rarely(number: u32, change: u32) -> bool {
    match change {
        UNREAD => {
            let word = std::env::var("CHANGE").unwrap_or_default();
            let change = if word == "note" { NOTE } else { word.parse().unwrap_or(NONE) };
            CHANGE.store(change, Relaxed);
            on(number)
        }
        NOTE => {
            if !REACHED[number as usize].swap(true, Relaxed) {
                let path = std::env::var("CHANGES_REACHED").unwrap_or_default();
                if let Ok(mut file) = std::fs::OpenOptions::new().append(true).create(true).open(path) {
                    let _ = file.write_all(std::format!("{number}\n").as_bytes());
                }
            }
            false
        }
        _ => false,
    }
}
