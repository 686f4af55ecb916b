# bash completion for fusee; `source <(fusee completion bash)`

# Files with an ending (*.toml, *.csv) and folders that may hold some.
_fusee_files() {
    local IFS=$'\n'
    compopt -o filenames 2>/dev/null
    # shellcheck disable=SC2207  # one word per line, whatever spaces it holds
    COMPREPLY+=($(compgen -f -X "!*.$2" -- "$1") $(compgen -d -- "$1"))
}

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
            make | simulate | design | identify | paper | keys | rules | completion) command=${COMP_WORDS[i]} && break ;;
        esac
    done
    local choices=
    case $command:$before in
        make:--out | make:-o | simulate:--out | simulate:-o | design:--out | design:-o | identify:--out | identify:-o | paper:--out | paper:-o | paper:--profiles)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -d -- "$word")
            return ;;
        make:--via) choices='cgal openscad' ;;
        design:--method) choices='algorithm_1 co_design pareto' ;;
        make:--jobs | make:-j | simulate:--jobs | simulate:-j | simulate:--levels | simulate:--push-torque | simulate:--at | design:--jobs | design:-j | paper:--jobs | paper:-j | design:--population | design:--generations | design:--seed) return ;;
        make:*)
            case $word in
                -*) choices='--out --via --jobs --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        simulate:*)
            case $word in
                -*) choices='--out --levels --push-torque --at --jobs --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        design:*)
            case $word in
                -*) choices='--method --out --population --generations --seed --jobs --resume --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        identify:*)
            case $word in
                -*) choices='--out --help' ;;
                *) _fusee_files "$word" csv; return ;;
            esac ;;
        paper:*) choices='--out --profiles --jobs --help' ;;
        completion:completion) choices='bash zsh fish' ;;
        :*) choices='make simulate design identify paper keys rules completion --help --version' ;;
        *) choices='--help' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
}

complete -F _fusee fusee
