#!/usr/bin/env bash
# Tests the page in a real browser: builds it (`--quick`) unless SKIP_BUILD says that web/dist is to be taken as it is. Chromium and
# node come from apt where they can; where no Chromium can be had at all, that is said and nothing is tested.
set -euo pipefail
cd "$(dirname "$0")"

install() { { apt-get update -qq && apt-get install -y -qq "$@"; } >/dev/null 2>&1 || true; }
chromium() { command -v chromium || command -v chromium-browser || command -v google-chrome; }

chromium >/dev/null || install chromium
command -v node >/dev/null || install nodejs
if ! chromium >/dev/null || ! command -v node >/dev/null; then
  printf '\n!!! NO CHROMIUM, OR NO NODE, COULD BE HAD: the page was NOT tested in a browser\n\n' >&2
  exit 0
fi
CHROMIUM=$(chromium)
export CHROMIUM
# What plays a learning platform, for these tests alone.
target=$(realpath -m "${CARGO_TARGET_DIR:-../target}")
scorm=$target/scorm-again-3.4.3
[ -d "$scorm" ] || { command -v npm || install npm; npm install --silent --no-fund --no-audit --prefix "$scorm" scorm-again@3.4.3; } >&2
export SCORM_AGAIN=$scorm/node_modules/scorm-again

[ -n "${SKIP_BUILD:-}" ] || ./build.sh --quick
# What the desktop says of the same scenes.
[ -n "${CLIPSCOPE:-}" ] || cargo build --manifest-path ../Cargo.toml --locked --bin clipscope
export CLIPSCOPE=${CLIPSCOPE:-$target/debug/clipscope}
exec node tests/run.mjs "$@"
