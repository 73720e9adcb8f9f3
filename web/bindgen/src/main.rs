//! `wasm-bindgen`, as much of it as the page needs: `clipscope-bindgen IN.wasm OUT`. As a program of this workspace it has the
//! version that the page was compiled with, and a third of what `cargo install wasm-bindgen-cli` compiles.
//!
//! `clipscope-bindgen order IN.wasm OUT.wasm` puts functions that are alike near each other, which makes it smaller once it is
//! packed; `clipscope-bindgen gzip FILE OUT` makes a file for every browser as small as gzip's format allows, in half a minute.

mod order;

use std::{
    env,
    fs::{self, File},
    num::NonZero,
};

use anyhow::Context;
use wasm_bindgen_cli_support::Bindgen;
use zopfli::{Format, Options};

/// More rounds make it smaller by less than a thousandth.
const ROUNDS: NonZero<u64> = NonZero::new(15).expect("more than none");
/// Code, names, texts and fonts are packed each by letters of its own.
const SPLITS: u16 = 400;

fn main() -> anyhow::Result<()> {
    let args: Vec<String> = env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match args[..] {
        ["gzip", file, out] => squeeze(file, out),
        ["order", input, out] => order(input, out),
        [input, out] => bind(input, out),
        _ => anyhow::bail!("IN.wasm OUT, order IN.wasm OUT.wasm, or gzip FILE OUT"),
    }
}

fn bind(input: &str, out: &str) -> anyhow::Result<()> {
    Bindgen::new()
        .input_path(input)
        .out_name("clipscope")
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(out)
}

fn order(input: &str, out: &str) -> anyhow::Result<()> {
    let program = fs::read(input).with_context(|| input.to_owned())?;
    let sorted = order::sorted(&program).with_context(|| input.to_owned())?;
    Ok(fs::write(out, sorted)?)
}

fn squeeze(file: &str, out: &str) -> anyhow::Result<()> {
    let bytes = fs::read(file).with_context(|| file.to_owned())?;
    let to = File::create(out).with_context(|| out.to_owned())?;
    let options = Options {
        iteration_count: ROUNDS,
        maximum_block_splits: SPLITS,
        ..Options::default()
    };
    Ok(zopfli::compress(options, Format::Gzip, &*bytes, to)?)
}
