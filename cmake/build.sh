#!/bin/bash
# cmake/build.sh PRESET [ARGUMENT...]: sets the machine up and builds a preset into build/PRESET.
# Arguments that begin with -D go to the configuration, the others to the build (--target NAME).
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
definitions=()
arguments=()
for argument in "$@"; do
  if [[ $argument == -D* ]]; then definitions+=("$argument"); else arguments+=("$argument"); fi
done

case $preset in
  asan | fuzz) cmake/setup.sh clang libclang-rt-dev lld llvm ;;  # llvm names the lines of a report
  *) cmake/setup.sh ;;
esac
if [[ -z ${CCACHE_DISABLE:-} ]] && command -v ccache >/dev/null; then
  definitions+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DTERRVIEW_PRECOMPILE=OFF)
else
  definitions+=(-DTERRVIEW_PRECOMPILE=ON)
fi
cmake --preset "$preset" "${definitions[@]}"

# A compiler takes up to 1.5 GiB: as many at once as there are cores, and memory.
cores=$(nproc)
fitting=$(awk '/^MemAvailable:/ { print int($2 / 1024 / 1536) }' /proc/meminfo)
jobs=$((fitting < cores ? fitting : cores))
cmake --build --preset "$preset" --parallel $((jobs > 0 ? jobs : 1)) "${arguments[@]}"
