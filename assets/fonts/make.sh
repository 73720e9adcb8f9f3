#!/bin/sh
# Remakes the font files beside this script, cut down to the characters that are used.
#
#   apt-get install fonts-inter fonts-jetbrains-mono fonts-noto-cjk fonts-dejavu-core python3-fonttools
#   assets/fonts/make.sh
#
# The characters: those of assets/messages/*.ftl, assets/glossary/*.toml, lessons/**/*.md, lessons/**/*.toml and src/**/*.rs
# (comment lines apart), extra-chars.txt, ASCII and Latin-1. tests/glyphs.rs fails on a character
# that no font here has. The result depends on those files and Debian's packages alone (made with
# Debian 12), so running it twice changes nothing.
set -eu
cd "$(dirname "$0")"
exec /usr/bin/python3 make.py
