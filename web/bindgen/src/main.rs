//! `wasm-bindgen`, as much of it as the page needs: `clipscope-bindgen IN.wasm OUT`. As a program of this workspace it has the
//! version that the page was compiled with, and a third of what `cargo install wasm-bindgen-cli` compiles.

use std::env;

use anyhow::Context;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> anyhow::Result<()> {
    let mut args = env::args().skip(1);
    let [input, out] = [args.next(), args.next()].map(|arg| arg.context("IN.wasm OUT"));
    Bindgen::new()
        .input_path(input?)
        .out_name("clipscope")
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(out?)
}
