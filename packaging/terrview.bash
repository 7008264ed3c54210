# bash completion of terrview. It asks the program: the options, and what stands for their values, are
# those of `terrview COMMAND --help`. Of a value such as small|large|FILE the words in small letters are
# choices; FILE, or another name for one, means the names of files, and DIR those of folders.

_terrview_values() {  # <what stands for a value> <its beginning>
  local word
  for word in ${1//|/ }; do
    case $word in
      FILE | IMAGE | DEM | IN | JOBS)
        compopt -o filenames 2>/dev/null
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$2")
        ;;
      DIR)
        compopt -o filenames 2>/dev/null
        mapfile -t COMPREPLY < <(compgen -d -- "$2")
        ;;
      *[A-Z]*) ;;
      *) [[ $1 == *'|'* && $word == "$2"* ]] && COMPREPLY+=("$word") ;;
    esac
  done
}

_terrview() {
  local program=${1/#\~/$HOME} current=$2 previous=$3 command=view
  local line names options= value= arguments=
  COMPREPLY=()
  # --option=value comes as three words.
  [[ $current == '=' ]] && current=
  [[ $previous == '=' ]] && previous=${COMP_WORDS[COMP_CWORD - 2]}
  ((COMP_CWORD > 1)) && [[ ${COMP_WORDS[1]} != -* ]] && command=${COMP_WORDS[1]}

  while IFS= read -r line; do
    [[ ${line/ Excludes: *} =~ ^'  '([^ ]+)(' '([^ :]+))? ]] || continue
    names=${BASH_REMATCH[1]//,/ }
    if [[ $names != -* ]]; then
      arguments+="|$names"
    else
      options+=" $names"
      [[ " $names " == *" $previous "* ]] && value=${BASH_REMATCH[3]}
    fi
  done < <("$program" "$command" --help 2>/dev/null)

  if [[ $value ]]; then
    _terrview_values "$value" "$current"
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  else
    # Commands are the second word of a line of usage, where [view] may be left out.
    ((COMP_CWORD == 1)) && while read -r _ command _; do
      command=${command//[][]/}
      [[ $command =~ ^[a-z]+$ ]] && arguments+="|$command"
    done < <("$program" --help 2>/dev/null | grep '^  terrview ')
    _terrview_values "$arguments" "$current"
  fi
}
complete -F _terrview terrview
