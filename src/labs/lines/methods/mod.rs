//! One file a method: its sentences, marks and watched values.

mod cohen_sutherland;
mod shared;
