# Completion of lineatlas for bash: what --help says.
_lineatlas() {
    local word=${COMP_WORDS[COMP_CWORD]} help
    if ((COMP_CWORD == 1)); then
        help=$(lineatlas --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p')
        mapfile -t COMPREPLY < <(compgen -W "$help --help" -- "$word")
    elif [[ $word == -* ]]; then
        help=$(lineatlas "${COMP_WORDS[1]}" --help 2>/dev/null | grep -oE -- '--[a-z-]+')
        mapfile -t COMPREPLY < <(compgen -W "$help" -- "$word")
    fi
}
complete -o default -F _lineatlas lineatlas
