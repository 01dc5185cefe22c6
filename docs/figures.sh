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
for name in ("humanoid-wrapped", "horse-wrapped"):
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

# part NAME WIDTHxHEIGHT CROP FILE OPTION...: CROP of a picture on grey, in the temporary folder. Several pictures, if the
# options ask for them, go to NAME0.png, NAME1.png and so on.
part() {
  name=$1 size=$2 crop=$3 file=$4
  shift 4
  case " $* " in *" --frames "*) target=$rigs/$name%d.png ;; *) target=$rigs/$name.png ;; esac
  "$sinew" render "$file" "$@" --no-ground --transparent --size "$size" -o "$target" >/dev/null 2>"$rigs/log" || {
    cat "$rigs/log" >&2
    exit 1
  }
  for made in "$rigs/$name"*.png; do convert "$made" -background '#34363b' -flatten -crop "$crop" +repage "$made"; done
}

# finish NAME SIZE: the part of that name, at that size, in 256 colours, as a figure.
finish() {
  convert "$rigs/$1.png" -resize "$2" -colors 256 -strip \
    -define png:compression-level=9 -define png:exclude-chunks=date,time "$out/$1.png"
  echo "$out/$1.png"
}

# picture NAME SIZE CROP FILE OPTION...: one figure from one picture of 2000x2600.
picture() {
  figure=$1 finished=$2
  shift 2
  part "$figure" 2000x2600 "$@"
  finish "$figure" "$finished"
}

# tiles NAME SIZE COLUMNS PART...: parts side by side, in rows of so many, as one figure.
tiles() {
  figure=$1 finished=$2 columns=$3
  shift 3
  pictures=
  for each in "$@"; do pictures="$pictures $rigs/$each.png"; done
  # shellcheck disable=SC2086  # one word each
  montage $pictures -tile "${columns}x" -geometry +0+0 -background '#34363b' "$rigs/$figure.png"
  finish "$figure" "$finished"
}

body=$assets/humanoid-wrapped.rig.json
apart=$rigs/humanoid-wrapped-apart.rig.json
view="--view 25,8"

# shellcheck disable=SC2086  # $view and $step: options, one word each
{
# 1: implicit primitives put into the control mesh.
picture figure-1-primitives-in-the-control-mesh 800x800 1800x1800+100+200 "$apart" $view --patch flat --depth 1 --shading clay \
  --show wire,primitives
# 2: implicit, straddling and normal triangles.
picture figure-2-triangle-classes 600x825 1600x2200+200+200 "$body" $view --shading classes --show wire --depth 2
# 3: implicit triangles smoothed; the regions of influence are dashed.
picture figure-3-implicit-triangles 800x600 1680x1260+180+180 "$body" $view --shading clay --show wire,influence --depth 3
# 4: triadic smoothing of normal triangles by curved patches.
picture figure-4-triadic-patches 800x600 1200x900+450+170 "$assets/humanoid.glb" $view --patch pn --depth 3 --shading clay \
  --show wire,control

# 5: the segments from the control mesh to their anchors on the skeleton, seen through the surface between them.
part f5a 2000x2600 1120x840+760+420 "$body" $view --depth 6 --shading clay
part f5b 2000x2600 1120x840+760+420 "$body" $view --no-surface --show skeleton,anchors
convert "$rigs/f5a.png" "$rigs/f5b.png" -compose blend -define compose:args=65 -composite \
  "$rigs/figure-5-segments-to-the-skeleton.png"
finish figure-5-segments-to-the-skeleton 800x600

# 6: the walking humanoid: animation skeleton; control mesh and primitives; final smooth mesh.
step="--clip Walk --time 0.05 --view 32,6"
part f6a 700x1400 640x1280+30+60 "$apart" $step --show skeleton,control --no-surface
part f6b 700x1400 640x1280+30+60 "$apart" $step --patch flat --depth 1 --shading clay --show wire,primitives
part f6c 700x1400 640x1280+30+60 "$body" $step --depth 5
tiles figure-6-walking-humanoid 1200x800 3 f6a f6b f6c

# 7: unblended primitives, and the horse they make.
part f7a 1400x1100 1020x1020+210+45 "$rigs/horse-wrapped-unblended.rig.json" --view 62,8 --depth 12 --shading clay
part f7b 1400x1100 1020x1020+210+45 "$assets/horse-wrapped.rig.json" --view 62,8 --depth 5
tiles figure-7-unblended-primitives-and-horse 1200x600 2 f7a f7b

# 8: eight frames of the dance, a second apart, from one place.
part f8 1000x1400 960x1300+20+70 "$assets/humanoid.rig.json" --clip Dance --frames 0:7 --fps 1 --view 15,6 --depth 5
tiles figure-8-dancing 1280x868 4 f80 f81 f82 f83 f84 f85 f86 f87
}
