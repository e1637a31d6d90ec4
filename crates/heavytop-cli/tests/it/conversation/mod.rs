//! What the program says while it works: its closing line, its progress, and its manners towards other programs.

mod closing;
mod events;
mod manners;
mod progress;
mod report;
