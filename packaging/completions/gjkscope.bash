# Commands, options and their values are read from --help, so none can be missing.
_gjkscope() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} help values=
  local command=("${COMP_WORDS[@]:0:COMP_CWORD}")
  # "study" has commands of its own.
  [ "${command[1]}" = study ] && command=("${command[@]:0:3}") || command=("${command[@]:0:2}")
  help=$("${command[@]}" --help 2>/dev/null)
  [[ "$before" == --* ]] && values=$(sed -nE "s/^  $before ([A-Z]+:)?\{?([a-z0-9-]+([,|][a-z0-9-]+)+)\}?.*/\2/p" <<<"$help")
  if [ -n "$values" ]; then
    COMPREPLY=($(compgen -W "${values//[,|]/ }" -- "$word"))
  elif [[ "$word" == -* ]]; then
    COMPREPLY=($(compgen -W "$(sed -nE 's/^  (-.,)?(--[a-z-]+).*/\2/p' <<<"$help")" -- "$word"))
  elif [[ "$help" == *Subcommands:* ]]; then
    COMPREPLY=($(compgen -W "$(sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+) .*/\1/p' <<<"$help")" -- "$word"))
  else
    COMPREPLY=($(compgen -W "$("${command[0]}" lessons 2>/dev/null | awk 'NR > 1 { print $1 }')" -- "$word")
               $(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _gjkscope gjkscope
