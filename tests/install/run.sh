#!/bin/bash
# tests/install/run.sh BUILD: installs the program of BUILD, and looks for its licence and for every
# picture that its pages show.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cmake --install "$1" --prefix "$folder" --component program >"$folder/log"
cd "$folder/share/doc/terrview"
test -s LICENSE
pictures=$(sed -n 's/.*](\(images\/[^) ]*\)).*/\1/p' ./*.md | sort -u)
test "$(wc -w <<<"$pictures")" -gt 20
for picture in $pictures; do test -s "$picture"; done
