#!/bin/bash
# bench/viewshed.sh [RUNS]: gdal_viewshed, GRASS r.viewshed (where they are installed) and the zone for
# the same point side by side: RUNS (3) runs each, of which the median counts, on a synthetic
# 4096 x 4096, 60 km across, and on real DEMs; then where they differ, and whom brute force bears out.
# On a flat Earth, where all three mean the same. Times are seconds of the processor, one thread:
# of gdal_viewshed's whole process, of r.viewshed's without import, of the zone's without files, and of
# terrview-zone-bench's whole process but for writing.
set -euo pipefail
cd "$(dirname "$0")/.."

runs=${1:-3}
build=$PWD/build/release
data=${TERRVIEW_TEST_DATA:-$PWD/../shared/data}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

median() { sort -n | awk '{ a[NR] = $1 } END { print a[int((NR + 1) / 2)] }'; }
# seconds COMMAND...: of the processor.
seconds() { { TIMEFORMAT='%U %S'; time "$@" >/dev/null 2>&1; } 2>&1 | awk '{ print $1 + $2 }'; }
over() { awk "BEGIN { printf \"%.2f\", $1 / $2 }"; }

zone() { "$build/terrview-zone-bench" time "$1" "$2" "$3" "$4" "$5" 1 flat "${@:6}"; }

gdal() { gdal_viewshed -q -cc 0 -oz "$4" -tz "$5" -md 1000000 -ox "$2" -oy "$3" "$1" "$folder/gdal.tif"; }

# Prints its seconds.
grass_viewshed() {
  cat >"$folder/job" <<JOB
r.in.gdal -o --quiet --overwrite input=$1 output=dem
g.region raster=dem
TIMEFORMAT='%U %S'
time r.viewshed -b --quiet --overwrite input=dem output=seen coordinates=$2,$3 observer_elevation=$4 target_elevation=$5 memory=8000
r.out.gdal --quiet --overwrite -f input=seen output=$folder/grass.tif type=Byte createopt=COMPRESS=DEFLATE
JOB
  grass --tmp-location "$1" --exec bash "$folder/job" 2>&1 >/dev/null |
    awk 'NF == 2 && $1 + 0 > 0 { print $1 + $2 }'
}

judge() { "$build/terrview-zone-bench" judge "${@:2:5}" "$folder/zone.tif" "$folder/$1.tif"; }

# compare NAME DEM X Y HEIGHT OBSERVER: X, Y a post.
compare() {
  local name=$1 gdal_s zone_s whole_s grass_s
  shift
  : >"$folder/gdal_s" && : >"$folder/zone_s" && : >"$folder/whole_s" && : >"$folder/grass_s"
  for ((i = 0; i < runs; ++i)); do
    seconds gdal "$@" >>"$folder/gdal_s"
    zone "$@" | cut -d' ' -f1 >>"$folder/zone_s"
    seconds zone "$@" >>"$folder/whole_s"
  done
  zone "$@" "$folder/zone.tif" >/dev/null
  gdal_s=$(median <"$folder/gdal_s") zone_s=$(median <"$folder/zone_s") whole_s=$(median <"$folder/whole_s")
  echo "$name"
  echo "  zone $zone_s s (process $whole_s s); gdal_viewshed $gdal_s s: the zone takes $(over "$zone_s" "$gdal_s") times as long (process $(over "$whole_s" "$gdal_s"))"
  echo "  gdal_viewshed $(judge gdal "$@")"
  if command -v grass >/dev/null; then
    grass_s=$(grass_viewshed "$@")
    echo "  r.viewshed $grass_s s: $(over "$grass_s" "$zone_s") times as long as the zone (process $(over "$grass_s" "$whole_s"))"
    echo "  r.viewshed $(judge grass "$@")"
  fi
}

echo "$(date +%F), $(nproc) cores, load $(cut -d' ' -f1 /proc/loadavg), $(gdalinfo --version | cut -d, -f1)$(command -v grass >/dev/null && grass --version 2>&1 | awk 'NR == 1 { print ", GRASS", $3 }')"
"$build/terrview" synth --levels 10 --h 0.9 --size 4096x4096 --spacing 14.6484375 --south-west 470000,5200000 \
  --a-srs EPSG:32632 --height 300 --base 1000 --co COMPRESS=NONE -q -o "$folder/synthetic.tif"
compare 'synthetic, 4096 x 4096, 14.6 m' "$folder/synthetic.tif" 500000 5230000 60 1.6
compare 'Mount Hood, 512 x 512, 30 m' "$data/mthood/mthood_512_utm10_30m.tif" 601494.617315754 5022987.406910948 60 1.6
compare 'Essen, city surface, 1000 x 1000, 1 m' "$data/essen/dom1_32_356_5699_1_nw_2020.tif" 356500.5 5699499.5 60 1.6
