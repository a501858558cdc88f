# Completion of windrow and windrow-draw for bash. Words come from the program's own --help, so that none can be out of date.
_windrow() {
    local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} command= help i
    if [[ ${program##*/} == windrow ]]; then
        for ((i = 1; i < COMP_CWORD; ++i)); do
            [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
        done
    fi
    help=$("$program" $command --help 2>/dev/null) || return
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$(grep -oE '^  (-[a-z],)?--[a-z-]+' <<<"$help" | grep -oE -- '--[a-z-]+')" -- "$word"))
    elif [[ ${program##*/} == windrow && -z $command ]]; then
        COMPREPLY=($(compgen -W "$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' <<<"$help")" -- "$word"))
    else # scenes and the folders above them
        compopt -o filenames
        COMPREPLY=($(compgen -f -X '!*.json' -- "$word") $(compgen -d -- "$word"))
    fi
}
complete -F _windrow windrow windrow-draw
