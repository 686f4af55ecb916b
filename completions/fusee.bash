# bash completion for fusee, printed by `fusee completion bash`
# shellcheck shell=bash disable=SC2207  # one word per line, whatever spaces it holds

_fusee_words() {
    local word=$1
    shift
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$word")
}

_fusee_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$1")
}

# Folders, and files with one of these endings.
_fusee_files() {
    local IFS=$'\n' word=$1 ending
    _fusee_folders "$word"
    shift
    for ending; do COMPREPLY+=($(compgen -f -X "!*.$ending" -- "$word")); done
}

# The keys of a profile; the program prints them.
_fusee_keys() {
    compopt -o nospace 2>/dev/null
    _fusee_words "$1" "$("${COMP_WORDS[0]}" keys --names 2>/dev/null)"
}

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' i
    COMPREPLY=()
    # --out=FOLDER arrives as three words.
    [ "$before" = = ] && before=${COMP_WORDS[COMP_CWORD - 2]}
    [ "$word" = = ] && word=''
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$command ${COMP_WORDS[i]}" in
            ' make' | ' batch' | ' query' | ' fix' | ' budget' | ' springs' | ' simulate' | ' identify' | ' design' | ' diagnose' | ' predict' | ' case-template' | ' blind' | ' blind make' | ' blind score' | ' paper' | ' coupons' | ' calibrate' | ' check' | ' rules' | ' keys') command+=" ${COMP_WORDS[i]}" ;;
        esac
    done
    case $command in
        '')
            case $word:$before in
                *) _fusee_words "$word" make batch query fix budget springs simulate identify design diagnose predict case-template blind paper coupons calibrate check rules keys --help --version ;;
            esac ;;
        ' make')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--via) _fusee_words "$word" cgal openscad ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --out --via --force --jobs ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' batch')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--name) ;;
                *:--shard) ;;
                *:--slurm-tasks) ;;
                *:--slurm-options) ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --out --name --dry-run --shard --merge --slurm --slurm-tasks --slurm-options --force --jobs ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' query')
            case $word:$before in
                -*) _fusee_words "$word" --help ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' fix')
            case $word:$before in
                *:-o | *:--out) _fusee_files "$word" toml ;;
                *:--keep) _fusee_keys "$word" ;;
                *:--most) ;;
                -*) _fusee_words "$word" --help --out --reviews --keep --most --json --force ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' budget')
            case $word:$before in
                *:--draws) ;;
                *:--wanted) ;;
                -*) _fusee_words "$word" --help --draws --wanted --json ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' springs')
            case $word:$before in
                *:-o | *:--out) _fusee_files "$word" toml ;;
                *:--catalogue) _fusee_files "$word" csv ;;
                *:--wire-class) _fusee_words "$word" sl sm sh dm dh ;;
                *:--cycles) ;;
                *:--within) ;;
                *:--most) ;;
                -*) _fusee_words "$word" --help --out --catalogue --bought --wire-class --cycles --within --most --accept-reviews --force ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' simulate')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--levels) ;;
                *:--push-torque) ;;
                *:--at) ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --out --levels --push-torque --at --force --jobs ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' identify')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                -*) _fusee_words "$word" --help --out --force ;;
                *) _fusee_files "$word" csv ;;
            esac ;;
        ' design')
            case $word:$before in
                *:--method) _fusee_words "$word" algorithm_1 co_design pareto ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--population) ;;
                *:--generations) ;;
                *:--seed) ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --method --out --population --generations --seed --jobs --resume --force ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' diagnose')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--profile) _fusee_files "$word" toml ;;
                *:--write-profile) _fusee_files "$word" toml ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --out --profile --write-profile --jobs --force ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' predict')
            case $word:$before in
                *:--effects) _fusee_files "$word" json ;;
                *:--inputs) _fusee_folders "$word" ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                -*) _fusee_words "$word" --help --effects --inputs --out --force ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' case-template')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                -*) _fusee_words "$word" --help --out --force ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' blind')
            case $word:$before in
                *) _fusee_words "$word" make score --help ;;
            esac ;;
        ' blind make')
            case $word:$before in
                *:--seed) ;;
                *:--cases) ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--plant) _fusee_words "$word" plant model ;;
                *:-j | *:--jobs) ;;
                *) _fusee_words "$word" --help --seed --cases --out --force --plant --jobs ;;
            esac ;;
        ' blind score')
            case $word:$before in
                *:--seal) ;;
                *:--model) _fusee_folders "$word" ;;
                *:--limit) ;;
                *:-j | *:--jobs) ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                -*) _fusee_words "$word" --help --seal --model --limit --again --jobs --out --force ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' paper')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--profiles) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                *) _fusee_words "$word" --help --out --profiles --jobs --force ;;
            esac ;;
        ' coupons')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                -*) _fusee_words "$word" --help --out --force ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' calibrate')
            case $word:$before in
                *:--profile) _fusee_files "$word" toml ;;
                *:--write-profile) _fusee_files "$word" toml ;;
                -*) _fusee_words "$word" --help --profile --write-profile --json --force ;;
                *) _fusee_files "$word" csv ;;
            esac ;;
        ' check')
            case $word:$before in
                *:--process) _fusee_words "$word" fdm sla sls mill mill4 edm laser all ;;
                *:--profile) _fusee_files "$word" toml ;;
                *:--limits) _fusee_files "$word" toml ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                -*) _fusee_words "$word" --help --process --profile --limits --out --json --jobs --force ;;
                *) _fusee_files "$word" toml stl obj 3mf step stp ;;
            esac ;;
        ' rules')
            case $word:$before in
                *) _fusee_words "$word" --help --json ;;
            esac ;;
        ' keys')
            case $word:$before in
                *) _fusee_words "$word" --help --names ;;
            esac ;;
    esac
}

complete -F _fusee fusee
