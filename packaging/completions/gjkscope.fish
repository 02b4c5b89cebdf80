complete -c gjkscope -n __fish_use_subcommand -f -a 'lessons export open trace solve check transcript explain study'
complete -c gjkscope -n '__fish_seen_subcommand_from export' -l format -x -a 'png svg pdf tex gif apng mp4 webm html'
complete -c gjkscope -n '__fish_seen_subcommand_from export trace check transcript explain' \
  -a '(gjkscope lessons 2>/dev/null | tail -n +2 | string split -f1 " ")'
