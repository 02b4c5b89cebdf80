# Commands, options and their values are read from --help, so none can be missing.
function __gjkscope_help
    # "study" has commands of its own.
    set -l run (commandline -opc)
    test "$run[2]" = study; and set run $run[1..3]; or set run $run[1..2]
    $run --help 2>/dev/null
end
function __gjkscope_words
    set -l before (commandline -opc)[-1]
    set -l help (__gjkscope_help)
    set -l values (string replace -rf -- "^  $before ([A-Z]+:)?\{?([a-z0-9-]+([,|][a-z0-9-]+)+)\}?.*" '$2' $help)
    if test -n "$values"
        string split , (string replace -a '|' , $values)
    else if string match -q -- '-*' (commandline -ct)
        string replace -rf -- '^  (-.,)?(--[a-z-]+).*' '$2' $help
    else if contains Subcommands: $help
        printf '%s\n' $help | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z-]+) .*/\1/p'
    else
        gjkscope lessons 2>/dev/null | tail -n +2 | string split -f1 ' '
        __fish_complete_path (commandline -ct)
    end
end
complete -c gjkscope -f -a '(__gjkscope_words)'
