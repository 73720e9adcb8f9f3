//! A rendered space has the same bytes here and on wasm32, where node and the target are at hand.

use std::{path::Path, process::Command};

use crate::shared::{say_left_out, space_bytes};

/// Runs a module's `main`, and exits with what it returns.
const RUN: &str = "const fs = require('node:fs');
WebAssembly.instantiate(fs.readFileSync(process.argv[1]), {})
  .then(({ instance }) => process.exit(instance.exports.main(0, 0)))
  .catch((error) => { console.error(error); process.exit(3); });";

const TARGET: &str = "wasm32-unknown-unknown";

#[test]
fn a_space_has_the_same_bytes_on_wasm32() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    if !has("node", &["--version"], "v")
        || !has("rustup", &["target", "list", "--installed"], TARGET)
    {
        say_left_out(&format!(
            "no bytes were compared with wasm32: node or the target {TARGET} is missing"
        ));
        return;
    }
    let manifest = root.join("tests/wasm/Cargo.toml");
    if !manifest.is_file() {
        say_left_out("no bytes were compared with wasm32: the package leaves out tests/wasm");
        return;
    }
    let target = root.join("target/wasm");
    let run_with = |digest: u64| {
        let mut build = Command::new(env!("CARGO"));
        build.args(["build", "--locked", "--target", TARGET]);
        build.arg("--manifest-path").arg(&manifest);
        build.arg("--target-dir").arg(&target);
        build.env("SPACE_BYTES", digest.to_string());
        // Where clippy compiles the tests it looks at the pure half here, which stands outside the built package's workspace.
        if let Some(wrapper) = std::env::var_os("RUSTC_WORKSPACE_WRAPPER") {
            build.env_remove("RUSTC_WORKSPACE_WRAPPER");
            build.env("RUSTC_WRAPPER", wrapper);
        }
        assert!(build.status().expect("cargo").success());
        let module = target.join(TARGET).join("debug/clipscope-wasm.wasm");
        let status = Command::new("node").args(["-e", RUN]).arg(module).status();
        status.expect("node").code()
    };
    let digest = space_bytes::digest();
    assert_eq!(run_with(digest), Some(0), "other bytes than here: {digest}");
    assert_eq!(run_with(digest ^ 1), Some(1), "it tells other bytes");
}

/// Can a command be run, and does it say this?
fn has(command: &str, args: &[&str], word: &str) -> bool {
    let output = Command::new(command).args(args).output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).contains(word))
}
