//! One file a method: its sentences, marks and watched values.

mod brute_force;
mod codes;
mod cohen_sutherland;
mod cyrus_beck;
mod liang_barsky;
mod nicholl_lee_nicholl;
mod parametric;
mod sectors;
mod shared;
