//! The program: hands over to the command line, which opens the app where no command is given.

#[cfg(all(feature = "gui", not(target_arch = "wasm32")))]
fn main() -> std::process::ExitCode {
    clipscope::cli::run()
}

/// The pure half has no program of its own.
#[cfg(not(all(feature = "gui", not(target_arch = "wasm32"))))]
fn main() {}
