#!/bin/bash
# bench/batch.sh [VIEWS [SEPARATE]]: VIEWS (1000) random views of the Vosges, 640 x 360, by one batch in
# five parts, and after each part a fifth of SEPARATE (60) of them by a run of terrview each. Prints
# the median time of a view, and the quotient.
set -euo pipefail
cd "$(dirname "$0")/.."

views=${1:-1000}
separate=${2:-60}
terrview=$PWD/build/release/terrview
data=${TERRVIEW_TEST_DATA:-$PWD/../shared/data}/vosges
dems=("$data/N47E007.hgt" "$data/N48E007.hgt")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"

RANDOM=1
echo 'name,eye,heading' >jobs.csv
for ((i = 1; i <= views; ++i)); do
  eye=$(printf '47.%05d,7.%05d,+%d' $((60000 + RANDOM % 39999)) $((RANDOM % 30000)) $((30 + RANDOM % 300)))
  echo "v$i,\"$eye\",$((RANDOM % 360))" >>jobs.csv
done

now_ms() { date +%s%3N; }
median() { sort -n | awk '{ a[NR] = $1 } END { print a[int((NR + 1) / 2)] }'; }

for part in 0 1 2 3 4; do
  before=$(now_ms)
  "$terrview" batch jobs.csv --dem "${dems[@]}" --size 640x360 -q -o '{name}.png' --shard "$part/5"
  echo $((5 * ($(now_ms) - before) / views)) >>batch_ms
  for ((i = 1; i <= separate / 5; ++i)); do
    IFS='"' read -r _ eye heading < <(sed -n "$((1 + part + 5 * i))p" jobs.csv)
    before=$(now_ms)
    "$terrview" "${dems[@]}" --eye "$eye" --heading "${heading#,}" --size 640x360 -q -o alone.png --overwrite
    echo $(($(now_ms) - before)) >>alone_ms
  done
done
batch=$(median <batch_ms)
alone=$(median <alone_ms)
echo "$(nproc) cores: batch $batch ms a view, alone $alone ms: $(awk "BEGIN { printf \"%.2f\", $alone / $batch }") times"
