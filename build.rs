//! `include_dir!` embeds the course but cannot tell cargo, on stable Rust, that a lesson was added or
//! removed: cargo watches the folder instead, and builds the library again when anything in it changes.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=lessons");
}
