#!/usr/bin/env bash
# packaging/make_icons.sh: draws the icon's sizes from its two drawings (needs rsvg-convert, package librsvg2-bin).
set -euo pipefail
cd "$(dirname "$0")/icons"
for size in 16 24 32; do rsvg-convert --width "$size" --height "$size" sinew-small.svg -o "sinew-$size.png"; done
for size in 48 64 128 256; do rsvg-convert --width "$size" --height "$size" sinew.svg -o "sinew-$size.png"; done
