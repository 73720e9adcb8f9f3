#!/usr/bin/env bash
# Tests the page in a real browser: builds it (`--quick`) unless SKIP_BUILD says that web/dist is to be taken as it is. Chromium and
# node come from apt where they can; where no Chromium can be had at all, that is said and nothing is tested.
set -euo pipefail
cd "$(dirname "$0")"

install() { { apt-get update -qq && apt-get install -y -qq "$@"; } >/dev/null 2>&1 || true; }
chromium() { command -v chromium || command -v chromium-browser || command -v google-chrome; }
not_tested() { printf '\n!!! %s: NOT tested in a browser\n\n' "$*" >&2; }

[ -n "${SKIP_BUILD:-}" ] || ./build.sh --quick

chromium >/dev/null || install chromium
command -v node >/dev/null || install nodejs
command -v curl >/dev/null || install curl ca-certificates
if ! chromium >/dev/null || ! command -v node >/dev/null; then
  not_tested "No Chromium, or no node, could be had. The page was built, and"
  exit 0
fi
CHROMIUM=$(chromium)
export CHROMIUM

target=$(realpath -m "${CARGO_TARGET_DIR:-../target}")
# What plays a learning platform, for these tests alone.
scorm=$target/scorm-again/3.4.3
if [ ! -d "$scorm" ]; then
  mkdir -p "$scorm.part"
  if curl -fsSL https://registry.npmjs.org/scorm-again/-/scorm-again-3.4.3.tgz -o "$scorm.tgz" &&
    echo "f182724b4614c34a616a92d7e4d8967392013c5fae74116db98a5c5a11db5edb  $scorm.tgz" | sha256sum --check --quiet && tar xzf "$scorm.tgz" -C "$scorm.part"; then
    mv "$scorm.part" "$scorm"
  else
    not_tested "scorm-again could not be had from npm. Packages for learning platforms are"
  fi
fi
export SCORM_AGAIN=$scorm/package
export BINDGEN=$target/tool/clipscope-bindgen

# What the desktop says of the same scenes.
[ -n "${CLIPSCOPE:-}" ] || cargo build --manifest-path ../Cargo.toml --locked --bin clipscope
export CLIPSCOPE=${CLIPSCOPE:-$target/debug/clipscope}
[ -z "$*" ] || exec node tests/run.mjs "$@"
# Two halves beside each other: a page waits more than it works.
PART=1/2 node tests/run.mjs &
other=$!
PART=2/2 node tests/run.mjs && wait "$other"
