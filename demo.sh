#!/bin/bash
# Sets the machine up, builds terrview and renders the project's own sample into out/.
set -euo pipefail
cd "$(dirname "$0")"

cmake/build.sh release --target terrview
mkdir -p out
build/release/terrview samples/vosges_like.tif --eye 48.012,7.005,1480 --look-at 48.04,6.968 \
  --pitch -9 --sun 235,28 --sky-view 32 --soft-shadows --overwrite -o out/sample.png
echo "The picture is $PWD/out/sample.png"
