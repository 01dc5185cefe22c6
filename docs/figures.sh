#!/bin/sh
# docs/figures.sh: makes docs/figures/*.png, the paper's figures, on characters of our own.
# Usage: docs/figures.sh [SINEW]     SINEW: the program; without it, the newest one under build/. Needs imagemagick.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
sinew=${1:-$(ls -t "$root"/build/*/app/sinew "$root"/build/app/sinew 2>/dev/null | head -n 1)}
[ -x "$sinew" ] || { echo "figures.sh: no program: build it, or name it" >&2; exit 1; }
for tool in convert montage; do
  command -v "$tool" >/dev/null || { echo "figures.sh: imagemagick's $tool is missing" >&2; exit 1; }
done
assets=$root/assets
out=$root/docs/figures
rigs=$(mktemp -d)
trap 'rm -rf "$rigs"' EXIT
mkdir -p "$out"

# Relatives of the bundled rigs: "apart", whose muscles may move no skin, and "unblended", in which none of them blend.
python3 - "$assets" "$rigs" <<'END'
import json, pathlib, sys
assets, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
for name in ("wrapped", "humanoid", "humanoid-wrapped", "horse-wrapped"):
    for relative in ("apart", "unblended"):
        rig = json.loads((assets / (name + ".rig.json")).read_text())
        rig["character"] = str(assets / rig["character"])
        for p in rig["primitives"]:
            if relative == "apart":
                p["territory"] = []
            else:
                p["group"] = p["name"]
        if relative == "unblended":
            rig["groups"], rig["links"] = [{"name": p["name"]} for p in rig["primitives"]], []
        (folder / (name + "-" + relative + ".rig.json")).write_text(json.dumps(rig))
END

# part NAME WIDTHxHEIGHT CROP FILE OPTION...: CROP of a picture on grey, in the temporary folder.
part() {
  name=$1 size=$2 crop=$3 file=$4
  shift 4
  "$sinew" render "$file" "$@" --no-ground --transparent --size "$size" -o "$rigs/$name.png" >/dev/null 2>"$rigs/log" || {
    cat "$rigs/log" >&2
    exit 1
  }
  convert "$rigs/$name.png" -background '#34363b' -flatten -crop "$crop" +repage "$rigs/$name.png"
}

# finish NAME SIZE: the part of that name, at that size, in 128 colours, as a figure.
finish() {
  convert "$rigs/$1.png" -resize "$2" -dither None -colors 128 -strip \
    -define png:compression-level=9 -define png:exclude-chunks=date,time "$out/$1.png"
  echo "$out/$1.png"
}

# picture NAME CROP FILE OPTION...: one figure from one picture of 1600x1200.
picture() {
  figure=$1 crop=$2
  shift 2
  part "$figure" 1600x1200 "$crop" "$@"
  finish "$figure" 800x600
}

# row NAME SIZE PART...: parts side by side as one figure.
row() {
  figure=$1 size=$2
  shift 2
  pictures=
  for each in "$@"; do pictures="$pictures $rigs/$each.png"; done
  # shellcheck disable=SC2086  # one word each
  montage $pictures -tile "$#x1" -geometry +0+0 -background '#34363b' "$rigs/$figure.png"
  finish "$figure" "$size"
}

whole=1600x1200+0+0
wrapped=$assets/wrapped.rig.json

# 1: implicit primitives put into the control mesh.
part f1 900x1400 900x900+0+130 "$rigs/humanoid-wrapped-apart.rig.json" --view 25,8 --patch flat --depth 1 --shading clay \
  --show wire,primitives
row figure-1-primitives-in-the-control-mesh 800x800 f1

# 2: implicit, straddling and normal triangles.
picture figure-2-triangle-classes $whole "$wrapped" --view 25,8 --shading classes --show wire --depth 2
# 3: implicit triangles smoothed; the regions of influence are dashed.
picture figure-3-implicit-triangles 1040x780+280+30 "$wrapped" --view 25,8 --shading clay --show wire,influence --depth 3
# 4: triadic smoothing of normal triangles by curved patches.
picture figure-4-triadic-patches 800x600+400+50 "$assets/wrapped.glb" --view 25,8 --patch pn --depth 3 --shading clay \
  --show wire,control
# 5: the segments from the control mesh to their anchors on the skeleton, through the surface between them.
picture figure-5-segments-to-the-skeleton 800x600+400+50 "$wrapped" --view 25,8 --projection bisection --depth 4 \
  --shading clay --show control,skeleton,anchors

# 6: the walking humanoid: animation skeleton; control mesh and primitives; final smooth mesh.
step="--clip Walk --time 0.05 --view 32,6"
# shellcheck disable=SC2086  # options, one word each
{
  part f6a 700x1400 700x1400+0+0 "$rigs/humanoid-wrapped-apart.rig.json" $step --show skeleton,control --no-surface
  part f6b 700x1400 700x1400+0+0 "$rigs/humanoid-wrapped-apart.rig.json" $step --patch flat --depth 1 --shading clay \
    --show wire,primitives
  part f6c 700x1400 700x1400+0+0 "$assets/humanoid-wrapped.rig.json" $step --depth 5
}
row figure-6-walking-humanoid 1050x700 f6a f6b f6c

# 7: unblended primitives, and the horse they make.
part f7a 1400x1100 1400x1100+0+0 "$rigs/horse-wrapped-unblended.rig.json" --view 62,8 --depth 6 --shading clay
part f7b 1400x1100 1400x1100+0+0 "$assets/horse-wrapped.rig.json" --view 62,8 --depth 5
row figure-7-unblended-primitives-and-horse 1400x550 f7a f7b

# 8: eight frames of the dance.
for i in 0 1 2 3 4 5 6 7; do
  part "f8$i" 500x800 500x800+0+0 "$assets/humanoid.rig.json" --clip Dance --time "$((4 + 105 * i / 10))e-1" --view 15,6 \
    --depth 5
done
row figure-8-dancing 1600x320 f80 f81 f82 f83 f84 f85 f86 f87
