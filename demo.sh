#!/bin/bash
# Sets the machine up, builds terrview and renders the project's own sample into out/.
set -euo pipefail
cd "$(dirname "$0")"

cmake/build.sh release --target terrview
mkdir -p out
build/release/terrview samples/vosges_like.tif --eye 48.0,7.0,+200 --overwrite -o out/sample.png
echo "The picture is $PWD/out/sample.png"
