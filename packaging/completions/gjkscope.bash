_gjkscope() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "lessons export open trace solve check transcript explain study --help --version" -- "$word"))
  elif [ "$before" = --format ]; then
    COMPREPLY=($(compgen -W "png svg pdf tex gif apng mp4 webm html" -- "$word"))
  elif [[ "$word" == -* ]]; then
    COMPREPLY=($(compgen -W "$(gjkscope "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE -- '--[a-z-]+' | sort -u)" -- "$word"))
  else
    COMPREPLY=($(compgen -W "$(gjkscope lessons 2>/dev/null | awk 'NR > 1 { print $1 }')" -- "$word") $(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _gjkscope gjkscope
