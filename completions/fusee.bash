# bash completion for fusee; `source <(fusee completion bash)`

# Profiles (*.toml) and folders that may hold some.
_fusee_profiles() {
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    # shellcheck disable=SC2207  # one word per line, whatever spaces it holds
    COMPREPLY+=($(compgen -f -X '!*.toml' -- "$1") $(compgen -d -- "$1"))
}

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
            make | keys | rules | completion) command=${COMP_WORDS[i]} && break ;;
        esac
    done
    local choices=
    case $command:$before in
        make:--out | make:-o)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -d -- "$word")
            return ;;
        make:--via) choices='cgal openscad' ;;
        make:--jobs | make:-j) return ;;
        make:*)
            case $word in
                -*) choices='--out --via --jobs --help' ;;
                *) _fusee_profiles "$word"; return ;;
            esac ;;
        completion:completion) choices='bash zsh fish' ;;
        :*) choices='make keys rules completion --help --version' ;;
        *) choices='--help' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
}

complete -F _fusee fusee
