#!/usr/bin/env bash
# Memory and rest of the app in a real window: on a display of its own (Xvfb), drawn by software OpenGL, driven
# with keys (xdotool). Prints Markdown; SCREENSHOT=file.xwd shows that the keys arrived.
#
#   cargo build --release && benches/window.sh [PROGRAM]
set -euo pipefail
program=${1:-$(dirname "$0")/../target/release/clipscope}
home=$(mktemp -d)
export XDG_DATA_HOME=$home XDG_CONFIG_HOME=$home LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY

# A display that nobody has: the server picks its number.
Xvfb -displayfd 7 -screen 0 1280x720x24 -nolisten tcp 7>"$home/display" 2>/dev/null &
server=$!
app=
trap 'kill $app $server 2>/dev/null; wait 2>/dev/null; rm -rf "$home"' EXIT
until [ -s "$home/display" ]; do sleep 0.1; done
DISPLAY=:$(cat "$home/display")
export DISPLAY

"$program" 2>"$home/err" &
app=$!

keys() { xdotool key --delay 60 "$@"; }

memory() {
  awk -v what="$1" '
    /^[0-9a-f]+-[0-9a-f]+ / { gl = $NF ~ /gallium|LLVM|libGL|libEGL|dri|drm|z3/ }
    /^Rss:/ { rss += $2; if (gl) driver += $2 }
    /^Anonymous:/ { anonymous += $2 }
    END {
      printf "| %s | %.0f | %.0f | %.0f | %.0f | ≤ 150 | %s |\n", what, rss / 1024, anonymous / 1024,
        (rss - anonymous) / 1024, driver / 1024, rss / 1024 <= 150 ? "met" : "missed"
    }' "/proc/$app/smaps"
}

# User and system time so far, in ticks of 10 ms.
ticks() { awk '{ print $14 + $15 }' "/proc/$app/stat"; }

echo "| resident memory, MB | in all | anonymous | of files | in the GL driver's libraries | target | |"
echo "|---|--:|--:|--:|--:|--:|---|"
sleep 10
# There is no window manager to give it the keyboard.
xdotool search --sync --onlyvisible --name Clipscope windowfocus --sync
memory "10 s after the start"
xdotool mousemove 600 300
for _ in $(seq 20); do keys Right Right Right Right Right Right Next; done
sleep 2
memory "after 120 steps and 20 lesson steps"
keys ctrl+plus minus F5 F5 F1 Escape
sleep 2
memory "after zoom, presentation and help"

[ -z "${SCREENSHOT-}" ] || xwd -root -silent -out "$SCREENSHOT"
xdotool mousemove 5 5
sleep 3
before=$(ticks)
sleep 20
echo
echo "Processor time: $((before * 10)) ms until then, $((($(ticks) - before) * 10)) ms in 20 s at rest."
