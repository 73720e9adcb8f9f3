#!/usr/bin/env bash
# Makes the page: web/dist, static files that any server can send, under any path. `--quick` leaves out what makes it small
# (optimisation of the whole program, wasm-opt): for tests.
set -euo pipefail
cd "$(dirname "$0")"
target=$(realpath -m "${CARGO_TARGET_DIR:-../target}")
dist=${DIST:-dist}
quick=
[ "${1:-}" = --quick ] && quick=yes

note() { printf '\n!!! %s\n\n' "$*" >&2; }

rustup target list --installed 2>/dev/null | grep -qx wasm32-unknown-unknown || rustup target add wasm32-unknown-unknown

# Every browser with WebGL2 of the last years has SIMD; without it the painter of glyphs brings a megabyte that stands in for it.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128"

profile=release
[ -n "$quick" ] && profile=dev
cargo build --locked --profile "$profile" -p clipscope-page --target wasm32-unknown-unknown --target-dir "$target"
cargo build --locked --profile tool -p clipscope-bindgen --target-dir "$target"

made=$target/page
rm -rf "$made" && mkdir -p "$made"
"$target/tool/clipscope-bindgen" "$target/wasm32-unknown-unknown/${profile/dev/debug}/clipscope_page.wasm" "$made"
mv "$made/clipscope_bg.wasm" "$made/clipscope.wasm"

# wasm-opt from npm: Debian's is too old for what rustc writes today. Its version is fixed, so that a page can be made again.
if [ -z "$quick" ]; then
  binaryen=$target/binaryen-132
  if [ ! -x "$binaryen/node_modules/.bin/wasm-opt" ]; then
    command -v npm >/dev/null || { apt-get update -qq && apt-get install -y -qq npm; } || true
    npm install --silent --no-fund --no-audit --prefix "$binaryen" binaryen@132.0.0 || true
  fi
  if [ -x "$binaryen/node_modules/.bin/wasm-opt" ]; then
    # rustc has put functions into others where that pays; a second time makes it larger. Two rounds find more than one.
    "$binaryen/node_modules/.bin/wasm-opt" -O2 -O2 -aimfs 0 -fimfs 0 -ocimfs 0 --enable-reference-types --enable-simd --enable-bulk-memory \
      --enable-nontrapping-float-to-int --enable-multivalue --enable-sign-ext --enable-mutable-globals \
      --vacuum --strip-debug --strip-producers "$made/clipscope.wasm" -o "$made/smaller.wasm"
    mv "$made/smaller.wasm" "$made/clipscope.wasm"
  else
    note "wasm-opt could not be had (npm's binaryen 132): the page works, and is about a fifth larger"
  fi
fi
# Packed, it is nine hundredths smaller with functions that are alike near each other.
if [ -z "$quick" ]; then
  "$target/tool/clipscope-bindgen" order "$made/clipscope.wasm" "$made/smaller.wasm"
  mv "$made/smaller.wasm" "$made/clipscope.wasm"
fi
# A gzip file, and the smallest one.
small() {
  if [ -n "$quick" ]; then gzip -n1 -c "$1" >"$2"; else "$target/tool/clipscope-bindgen" gzip "$1" "$2"; fi
}
small "$made/clipscope.wasm" "$made/clipscope.bin"

# Each file is named by its content, so that no cache shows an old one; what names another comes after it.
rm -rf "$dist" && mkdir -p "$dist/licences"
names=$made/names.sed
: >"$names"
put() {
  local file=$1 name=$2 hash
  case $name in
  *.js | *.css) sed -f "$names" "$file" >"$made/put" ;;
  *) cp "$file" "$made/put" ;;
  esac
  hash=$(sha256sum "$made/put" | cut -c1-12)
  cp "$made/put" "$dist/${name%.*}-$hash.${name##*.}"
  printf 's|@%s@|./%s-%s.%s|g\ns|@%s:bytes@|%d|g\n' \
    "$name" "${name%.*}" "$hash" "${name##*.}" "$name" "$(stat -c %s "$made/put")" >>"$names"
}
put "$made/clipscope.wasm" clipscope.wasm
put "$made/clipscope.bin" clipscope.bin
put "$made/clipscope.js" clipscope.js
put ../assets/icon.png icon.png
# What is fetched when it is first needed: files one after the other, each after its name and its length.
part() {
  local to=$1 file
  shift
  for file in "$@"; do
    printf '%s %d\n' "$(sed 's|.*/messages/[^/]*/||; s|.*/lessons/||; s|.*/glossary/||; s|.*/spot/||' <<<"$file")" "$(stat -c %s "$file")"
    cat "$file"
  done >"$made/part"
  small "$made/part" "$made/$to"
  put "$made/$to" "$to"
}
for lang in zh-CN es pt-BR; do
  messages=$(ls ../assets/messages/"$lang"/*.ftl | grep -v '/cli\.ftl$') # a page has no command line
  part "texts-$lang.bin" $messages "../assets/glossary/$lang.toml" ../lessons/*/"$lang.md"
done
part spot.bin ../assets/meshes/spot/spot.obj ../assets/meshes/spot/spot_texture.png
for weight in Regular Bold; do put "../assets/fonts/NotoSansSC-$weight.otf" "NotoSansSC-$weight.otf"; done
for file in words.js keys.js embed.js platform.js page.css page.js; do put "page/$file" "$file"; done
sed -f "$names" page/index.html >"$dist/index.html"
sed -f "$names" page/example.html >"$dist/example.html"
# For whoever comes back without a network: all but what only old browsers ask for.
files=$(cd "$dist" && printf '"./", ' && ls | grep -v '\.wasm$\|^licences$\|\.html$' | sed 's/.*/".\/&", /' | tr -d '\n')
sed -e "s|@files@|${files%, }|" -e "s|@set@|$(cat "$dist"/*.* | sha256sum | cut -c1-12)|" page/sw.js >"$dist/sw.js"
if grep -n '@[A-Za-z-]*\.[a-z]*\(:bytes\)\?@' "$dist"/*.html "$dist"/page-*.js; then
  note "these names stand for files that there are none of"
  exit 1
fi
cp ../LICENSE-MIT ../LICENSE-APACHE ../assets/fonts/OFL.txt ../assets/fonts/DejaVu-LICENSE.txt "$dist/licences/"

size() { stat -c %s "$made/$1" | awk '{ printf "%.2f MB", $1 / 1e6 }'; }
echo "web/dist: $(size clipscope.wasm), $(size clipscope.bin) gzipped"
