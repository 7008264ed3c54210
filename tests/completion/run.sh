#!/bin/bash
# tests/completion/run.sh PROGRAM: what bash completes, asked of its completion function.
set -uo pipefail
built=$(realpath "$1")
source "$(dirname "$0")/../../packaging/terrview.bash"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/here" "$folder/answers"
cd "$folder/here" || exit
touch dem.tif "two words.tif"
failed=0

# The program, run once for each question.
terrview() {
  local answer="$folder/answers/$*"
  [[ -e $answer ]] || "$built" "$@" >"$answer"
  cat "$answer"
}

# complete_line <words after terrview>: the completions of the last one, in order, a line each.
complete_line() {
  COMP_WORDS=(terrview "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _terrview terrview "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  ((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}" | LC_ALL=C sort
}

# expect <completions parted by commas> <words>...
expect() {
  local found
  found=$(complete_line "${@:2}" | paste -sd,)
  [[ $found == "$1" ]] && return
  echo "terrview ${*:2}: '$found', expected '$1'"
  failed=1
}

# Commands and files come first, and files where a command takes them.
expect 'sky,synth' s
expect 'view' v
expect 'dem.tif' d
expect 'dem.tif,two words.tif' view ''
expect 'dem.tif,two words.tif' dem.tif ''
expect '' sky ''

# Options are the command's; without one, those of view.
expect '--field,--first' synth --fi
expect '--surface' --surf
expect '--surface' dem.tif --surf

# Choices, files, both, neither; also after an equals sign.
expect 'band,bilinear,hyperboloid,triangles' view --surface ''
expect 'hyperboloid' dem.tif --surface h
expect 'fill' view --voids = f
expect 'fill,open' view --voids =
expect 'off,on' view --lod ''
expect 'dem.tif' view --drape d
mkdir studies
expect 'studies' impact -o ''
rmdir studies
expect 'two words.tif' quantize --use-palette tw
expect 'alpine,arid' view --colors a
expect 'dem.tif' view --colors d
expect '' view --eye ''
expect 'dem.tif,two words.tif' view --no-shadows ''
expect 'dem.tif,two words.tif' view --preview ''

# Every option of --help, and nothing else.
options_of() {
  terrview "$1" --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr , '\n' | LC_ALL=C sort | paste -sd,
}
commands=$(terrview --help | sed -n 's/^  terrview \[\{0,1\}\([a-z]*\).*/\1/p')
[[ $commands == *view*quantize* ]] || failed=1
for command in $commands; do expect "$(options_of "$command")" "$command" -; done
exit $failed
