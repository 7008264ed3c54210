#!/bin/bash
# tests/report/run.sh [TERRVIEW [FOLDER]]: a report of `terrview impact`, opened in a real browser:
# its sliders move, it asks nothing of the network, its console stays empty, and it prints. FOLDER
# (default: a temporary one) keeps what the browser shows.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
terrview=$(realpath "${1:-$here/../../build/release/terrview}")
kept=${2:-}
folder=$(realpath -m "${kept:-$(mktemp -d)}")
mkdir -p "$folder"
[[ $kept ]] || trap 'rm -rf "$folder"' EXIT

for tool in chromium chromedriver python3; do
  command -v "$tool" >/dev/null || { echo "report: there is no $tool here: install chromium, chromium-driver and python3, as ./test.sh does"; exit 1; }
done

cd "$folder"
cat >project.geojson <<'END'
{"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "<script>document.title = 'broken'</script>", "height": 80},
   "geometry": {"type": "Polygon", "coordinates":
     [[[6.9998, 48.0], [7.0002, 48.0], [7.0002, 48.0003], [6.9998, 48.0003], [6.9998, 48.0]]]}}]}
END
cat >points.geojson <<'END'
{"type": "FeatureCollection", "features": [
  {"type": "Feature", "properties": {"name": "Near \" onload=\"alert(1)", "eye_height": 40},
   "geometry": {"type": "Point", "coordinates": [7.0, 47.993]}},
  {"type": "Feature", "properties": {"name": "Nowhere"},
   "geometry": {"type": "Point", "coordinates": [17, 48]}}]}
END
status=0
"$terrview" impact "$here/../../samples/vosges_like.tif" --buildings project.geojson --viewpoints points.geojson \
  --size 320x180 -q -o study 2>messages.txt || status=$?
((status == 3)) || { cat messages.txt; echo "report: the study ended with $status, expected 3"; exit 1; }
python3 "$here/browser.py" "$folder/study/report.html" "$folder"
