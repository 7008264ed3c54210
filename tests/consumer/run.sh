#!/bin/bash
# tests/consumer/run.sh BUILD [TARGET]: installs the libraries of BUILD, moves them elsewhere, and builds
# and runs tests/consumer against them; or builds its TARGET.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install "$1" --prefix "$folder/first" --component development >"$folder/log"
mv "$folder/first" "$folder/prefix"
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$1/CMakeCache.txt")
cmake -S "$here" -B "$folder/build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$folder/prefix"
cmake --build "$folder/build" --target "${2:-all}"
(($# > 1)) || "$folder/build/consumer" "$here/../../samples/vosges_like.tif"
