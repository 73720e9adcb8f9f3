//! Draws spaces and says by its exit status whether they have the bytes that `SPACE_BYTES` named when this was built:
//! WebAssembly by itself can say no more than that.

#[path = "../../shared/space_bytes.rs"]
mod space_bytes;

use std::process::ExitCode;

fn main() -> ExitCode {
    let expected = option_env!("SPACE_BYTES").and_then(|digits| digits.parse().ok());
    let is_so = expected == Some(space_bytes::digest());
    ExitCode::from(u8::from(!is_so))
}
