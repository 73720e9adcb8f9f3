//! The labs: each one's scene (the document that a person edits), and scene + trace → figure.

pub mod lines;
