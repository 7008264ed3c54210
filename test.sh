#!/bin/bash
# ./test.sh [--long] [--shards] [--preset NAME] [CTEST ARGUMENT...]
# Sets the machine up, builds the release preset (or NAME) and runs every test, with --long the long
# ones and that of Slurm too. --shards spares most tests a process of their own: faster, but ctest
# no longer knows them by name. Other arguments go to ctest: ./test.sh -R Tracer
# Random cases are the same in each run, but with --long, or where RC_PARAMS says otherwise.
set -euo pipefail
cd "$(dirname "$0")"

preset=release
shards=OFF
which_tests=(--label-exclude '^(long|slurm)$')
arguments=()
while (($#)); do
  case $1 in
    --long) which_tests=() ;;
    --shards) shards=ON ;;
    --preset) preset=${2:?which preset? see CMakePresets.json}; shift ;;
    -h | --help) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    *) arguments+=("$1") ;;
  esac
  shift
done

if [[ ${#which_tests[@]} -gt 0 ]]; then export RC_PARAMS=${RC_PARAMS:-seed=1984}; fi

cmake/setup.sh chromium chromium-driver python3  # tests/report
cmake/build.sh "$preset" "-DTERRVIEW_TEST_SHARDS=$shards"
ctest --test-dir "build/$preset" --output-on-failure --no-tests=error --parallel "$(nproc)" \
  "${which_tests[@]}" "${arguments[@]}"
