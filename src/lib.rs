//! Clipscope shows, step by step and with the real numbers, how graphics programs decide what is visible.
//!
//! The order of the modules is the order to read them in; each knows only those above it.

pub mod geom;
pub mod trace;

pub mod algo;

pub mod text;

pub mod figure;

pub mod labs;

pub mod input;

pub mod lesson;

pub mod case;

#[cfg(feature = "gui")]
pub mod paint;

#[cfg(feature = "gui")]
pub mod widgets;

#[cfg(feature = "gui")]
pub mod panels;

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
pub mod export;

#[cfg(feature = "gui")]
pub mod app;

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
pub mod cli;
