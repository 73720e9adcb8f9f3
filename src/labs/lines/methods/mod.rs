//! One file a method: its sentences, marks and watched values.

mod brute_force;
mod cohen_sutherland;
mod liang_barsky;
mod shared;
