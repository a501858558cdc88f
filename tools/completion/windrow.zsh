#compdef windrow windrow-draw
# Completion of windrow and windrow-draw for zsh. Words come from the program's own --help, so that none can be out of date.
local command= help
[[ ${words[1]:t} == windrow && ${words[2]} != -* && CURRENT -gt 2 ]] && command=${words[2]}
help=$(${words[1]} ${=command} --help 2>/dev/null) || return 1
if [[ ${words[CURRENT]} == -* ]]; then
    compadd -- ${(f)"$(grep -oE '^  (-[a-z],)?--[a-z-]+' <<<$help | grep -oE -- '--[a-z-]+')"}
elif [[ ${words[1]:t} == windrow && CURRENT -eq 2 ]]; then
    compadd -- ${(f)"$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p' <<<$help)"}
else
    _files -g '*.json'
fi
