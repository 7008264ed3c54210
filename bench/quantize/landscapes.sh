#!/bin/bash
# bench/quantize/landscapes.sh DATA OUT [OPTION...]: the five landscapes of docs/quantize.md, as PNG
# in the folder OUT. DATA holds the elevation models of docs/gallery.md and, under their usual names,
# SRTM's N47E009.hgt (Alpstein) and its window on the Rhine valley. Options go to every view.
set -euo pipefail
data=$(realpath "$1")
out=$2
shift 2
terrview=$(dirname "$0")/../../build/release/terrview
mkdir -p "$out"

view() {
  "$terrview" "${@:2}" --size 1600x1000 -q --overwrite -o "$out/$1.png"
}
dem() { find "$data" -name "$1" -print -quit; }

view vosges "$(dem vosges_hohneck_grandballon_256.tif)" --eye 47.9008,7.0986,+2 \
  --look-at 48.0383,7.0158 --fov 40 --sun 250,22 "$@"
view mount_hood "$(dem lf_elev_220_mt_hood_utm.tif)" --eye 45.3050,-121.7550,+700 \
  --look-at 45.3735,-121.6959 --fov 45 --sun 245,30 "$@"
view ben_nevis "$(dem NN16.asc)" "$(dem NN17.asc)" --eye 56.853,-5.062,+150 \
  --look-at 56.7969,-5.0036,1250 --fov 55 --sun 290,25 "$@"
view alpstein "$(dem N47E009.hgt)" --eye 47.33,9.40,+300 --look-at 47.249,9.343,2400 --fov 55 \
  --sun 300,25 "$@"
view rhine "$(dem li_srtm3_filled.tif)" --eye 47.23,9.47,+600 --look-at 47.08,9.55 --fov 60 \
  --sun 240,35 "$@"
