#!/bin/sh
# docs/figures.sh: makes docs/figures/*.png, the paper's figures 1 to 5 and 7 (left), on the body of assets/wrapped.
# Usage: docs/figures.sh [SINEW]     SINEW: the program; without it, the newest one under build/. Needs imagemagick.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
sinew=${1:-$(ls -t "$root"/build/*/app/sinew "$root"/build/app/sinew 2>/dev/null | head -n 1)}
[ -x "$sinew" ] || { echo "figures.sh: no program: build it, or name it" >&2; exit 1; }
command -v convert >/dev/null || { echo "figures.sh: imagemagick's convert is missing" >&2; exit 1; }
out=$root/docs/figures
rigs=$(mktemp -d)
trap 'rm -rf "$rigs"' EXIT
mkdir -p "$out"

# Two relatives of the bundled rig: one whose muscles may move no skin, one in which none of them blend.
python3 - "$root/assets" "$rigs" <<'END'
import json, pathlib, sys
assets, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
for name in ("apart", "unblended"):
    rig = json.loads((assets / "wrapped.rig.json").read_text())
    rig["character"] = str(assets / "wrapped.glb")
    for p in rig["primitives"]:
        if name == "apart":
            p["territory"] = []
        else:
            p["group"] = p["name"]
    if name == "unblended":
        rig["groups"], rig["links"] = [{"name": p["name"]} for p in rig["primitives"]], []
    (folder / (name + ".rig.json")).write_text(json.dumps(rig))
END
wrapped=$root/assets/wrapped.rig.json

# picture NAME CROP FILE OPTION...: CROP of a picture of 1600x1200, brought to 800x600 on grey, in 128 colours.
picture() {
  name=$1 crop=$2 file=$3
  shift 3
  "$sinew" render "$file" "$@" --no-ground --transparent --size 1600x1200 -o "$rigs/$name.png" >/dev/null 2>"$rigs/log" || {
    cat "$rigs/log" >&2
    exit 1
  }
  convert "$rigs/$name.png" -background '#34363b' -flatten -crop "$crop" +repage -resize 800x600 -dither None -colors 128 -strip \
    -define png:compression-level=9 -define png:exclude-chunks=date,time "$out/$name.png"
  echo "$out/$name.png"
}

whole=1600x1200+0+0
# 1: implicit primitives put into the control mesh.
picture figure-1-primitives-in-the-control-mesh $whole "$rigs/apart.rig.json" --view 25,8 --patch flat --depth 1 \
  --shading clay --show wire,primitives
# 2: implicit, straddling and normal triangles.
picture figure-2-triangle-classes $whole "$wrapped" --view 25,8 --shading classes --show wire --depth 2
# 3: implicit triangles smoothed; the regions of influence are dashed.
picture figure-3-implicit-triangles 1040x780+280+30 "$wrapped" --view 25,8 --shading clay --show wire,influence --depth 3
# 4: triadic smoothing of normal triangles by curved patches.
picture figure-4-triadic-patches 800x600+400+50 "$root/assets/wrapped.glb" --view 25,8 --patch pn --depth 3 --shading clay \
  --show wire,control
# 5: where the segments run: from the control mesh to the skeleton, through the surface between them.
picture figure-5-mesh-surface-skeleton 800x600+400+50 "$wrapped" --view 25,8 --projection bisection --depth 4 \
  --shading clay --show control,skeleton
# 7, left: the same primitives, none of which blend.
picture figure-7-left-unblended $whole "$rigs/unblended.rig.json" --view 25,8 --depth 6 --shading clay
