# bash completion for fusee; `source <(fusee completion bash)`

# Files with one of some endings (toml, csv) and folders that may hold some.
_fusee_files() {
    local IFS=$'\n' word=$1 ending
    shift
    compopt -o filenames 2>/dev/null
    # shellcheck disable=SC2207  # one word per line, whatever spaces it holds
    for ending; do COMPREPLY+=($(compgen -f -X "!*.$ending" -- "$word")); done
    # shellcheck disable=SC2207
    COMPREPLY+=($(compgen -d -- "$word"))
}

_fusee_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$1")
}

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${COMP_WORDS[i]} in
            make | fix | simulate | design | identify | coupons | calibrate | diagnose | predict | case-template | blind | paper | check | keys | rules | completion) command=${COMP_WORDS[i]} && break ;;
        esac
    done
    local choices='' step=''
    [ "$command" = blind ] && ((COMP_CWORD > i + 1)) && step=${COMP_WORDS[i + 1]}
    case $command:$before in
        make:--out | make:-o | simulate:--out | simulate:-o | design:--out | design:-o | identify:--out | identify:-o | coupons:--out | coupons:-o | diagnose:--out | diagnose:-o | predict:--out | predict:-o | predict:--inputs | case-template:--out | case-template:-o | blind:--out | blind:-o | blind:--model | paper:--out | paper:-o | paper:--profiles)
            _fusee_folders "$word"
            return ;;
        make:--via) choices='cgal openscad' ;;
        blind:--plant) choices='plant model' ;;
        check:--out | check:-o) _fusee_folders "$word"; return ;;
        check:--process) choices='fdm sla sls mill mill4 edm laser all' ;;
        check:--profile | check:--limits) _fusee_files "$word" toml; return ;;
        check:--jobs | check:-j) return ;;
        design:--method) choices='algorithm_1 co_design pareto' ;;
        make:--jobs | make:-j | simulate:--jobs | simulate:-j | simulate:--levels | simulate:--push-torque | simulate:--at | design:--jobs | design:-j | paper:--jobs | paper:-j | diagnose:--jobs | diagnose:-j | fix:--most | fix:--keep | blind:--seed | blind:--cases | blind:--seal | blind:--limit | blind:--jobs | blind:-j | design:--population | design:--generations | design:--seed) return ;;
        fix:--out | fix:-o) _fusee_files "$word" toml; return ;;
        predict:--effects) _fusee_files "$word" json; return ;;
        diagnose:--profile | diagnose:--write-profile | calibrate:--profile | calibrate:--write-profile) _fusee_files "$word" toml; return ;;
        make:*)
            case $word in
                -*) choices='--out --via --jobs --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        fix:*)
            case $word in
                -*) choices='--out --keep --most --reviews --json --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        simulate:*)
            case $word in
                -*) choices='--out --levels --push-torque --at --jobs --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        design:*)
            case $word in
                -*) choices='--method --out --population --generations --seed --jobs --resume --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        identify:*)
            case $word in
                -*) choices='--out --force --help' ;;
                *) _fusee_files "$word" csv; return ;;
            esac ;;
        coupons:*)
            case $word in
                -*) choices='--out --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        calibrate:*)
            case $word in
                -*) choices='--profile --write-profile --json --force --help' ;;
                *) _fusee_files "$word" csv; return ;;
            esac ;;
        diagnose:*)
            case $word in
                -*) choices='--out --profile --write-profile --jobs --force --help' ;;
                *) _fusee_folders "$word"; return ;;
            esac ;;
        predict:*)
            case $word in
                -*) choices='--effects --inputs --out --force --help' ;;
                *) _fusee_folders "$word"; return ;;
            esac ;;
        case-template:*)
            case $word in
                -*) choices='--out --force --help' ;;
                *) _fusee_files "$word" toml; return ;;
            esac ;;
        blind:*)
            case $step:$word in
                make:*) choices='--seed --cases --plant --jobs --out --force --help' ;;
                score:-*) choices='--seal --model --limit --again --jobs --out --force --help' ;;
                score:*) _fusee_folders "$word"; return ;;
                *) choices='make score --help' ;;
            esac ;;
        paper:*) choices='--out --profiles --jobs --force --help' ;;
        check:*)
            case $word in
                -*) choices='--process --profile --limits --out --json --jobs --force --help' ;;
                *) _fusee_files "$word" toml stl obj 3mf step stp; return ;;
            esac ;;
        rules:*) choices='--json --help' ;;
        completion:completion) choices='bash zsh fish' ;;
        :*) choices='make fix simulate design identify coupons calibrate diagnose predict case-template blind paper check keys rules completion --help --version' ;;
        *) choices='--help' ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
}

complete -F _fusee fusee
