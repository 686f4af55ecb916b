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
            ' init' | ' make' | ' watch' | ' check' | ' fix' | ' batch' | ' query' | ' design' | ' springs' | ' budget' | ' render' | ' coupons' | ' calibrate' | ' simulate' | ' case-template' | ' identify' | ' diagnose' | ' predict' | ' blind' | ' blind make' | ' blind score' | ' paper' | ' explain' | ' keys' | ' rules') command+=" ${COMP_WORDS[i]}" ;;
        esac
    done
    case $command in
        '')
            case $word:$before in
                *:--color) _fusee_words "$word" auto always never ;;
                *) _fusee_words "$word" init make watch check fix batch query design springs budget render coupons calibrate simulate case-template identify diagnose predict blind paper explain keys rules --help --version --json --color --quiet --verbose ;;
            esac ;;
        ' init')
            case $word:$before in
                *:--torque) ;;
                *:--overdrive) ;;
                *:--least) ;;
                *:--ratio) ;;
                *:--range) ;;
                *:--law) ;;
                *:--joint-stiffness) ;;
                *:--friction) ;;
                *:--friction-constant) ;;
                *:--cable) ;;
                *:--breaking-load) ;;
                *:--shaft) ;;
                *:--process) ;;
                *:--material) ;;
                *:--bed) ;;
                *:--columns) ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --torque --overdrive --least --ratio --range --law --joint-stiffness --friction --friction-constant --cable --breaking-load --shaft --process --material --bed --columns --yes --jobs --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' make')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--via) _fusee_words "$word" cgal openscad ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --via --force --jobs --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' watch')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--port) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --serve --port --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' check')
            case $word:$before in
                *:--process) _fusee_words "$word" fdm sla sls mill mill4 edm laser all ;;
                *:--profile) _fusee_files "$word" toml ;;
                *:--limits) _fusee_files "$word" toml ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --process --profile --limits --out --jobs --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml stl obj 3mf step stp ;;
            esac ;;
        ' fix')
            case $word:$before in
                *:-o | *:--out) _fusee_files "$word" toml ;;
                *:--keep) _fusee_keys "$word" ;;
                *:--most) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --reviews --keep --most --force --json --color --quiet --verbose ;;
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
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --name --dry-run --shard --merge --slurm --slurm-tasks --slurm-options --force --jobs --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' query')
            case $word:$before in
                *:--seconds) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --seconds --json --color --quiet --verbose ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' design')
            case $word:$before in
                *:--method) _fusee_words "$word" algorithm_1 co_design pareto ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--population) ;;
                *:--generations) ;;
                *:--seed) ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --method --out --population --generations --seed --jobs --resume --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' springs')
            case $word:$before in
                *:-o | *:--out) _fusee_files "$word" toml ;;
                *:--catalogue) _fusee_files "$word" csv ;;
                *:--columns) ;;
                *:--wire-class) _fusee_words "$word" sl sm sh dm dh ;;
                *:--cycles) ;;
                *:--within) ;;
                *:--most) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --catalogue --columns --bought --wire-class --cycles --within --most --accept-reviews --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' budget')
            case $word:$before in
                *:--draws) ;;
                *:--wanted) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --draws --wanted --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' render')
            case $word:$before in
                *:--view) ;;
                *:-o | *:--out) ;;
                *:--width) ;;
                *:--co-contraction) ;;
                *:--joint-angle) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --view --out --width --dark --co-contraction --joint-angle --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' coupons')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' calibrate')
            case $word:$before in
                *:--profile) _fusee_files "$word" toml ;;
                *:--write-profile) _fusee_files "$word" toml ;;
                *:--columns) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --profile --write-profile --columns --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" csv ;;
            esac ;;
        ' simulate')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--levels) ;;
                *:--push-torque) ;;
                *:--at) ;;
                *:--write-mjcf) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --levels --push-torque --at --write-mjcf --force --jobs --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' case-template')
            case $word:$before in
                *:--next) _fusee_files "$word" json ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --next --out --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" toml ;;
            esac ;;
        ' identify')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--columns) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --columns --force --json --color --quiet --verbose ;;
                *) _fusee_files "$word" csv ;;
            esac ;;
        ' diagnose')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--profile) _fusee_files "$word" toml ;;
                *:--write-profile) _fusee_files "$word" toml ;;
                *:--write-mjcf) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --out --profile --write-profile --write-mjcf --jobs --force --json --color --quiet --verbose ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' predict')
            case $word:$before in
                *:--effects) _fusee_files "$word" json ;;
                *:--inputs) _fusee_folders "$word" ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--write-mjcf) _fusee_folders "$word" ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --effects --inputs --out --write-mjcf --force --json --color --quiet --verbose ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' blind')
            case $word:$before in
                *:--color) _fusee_words "$word" auto always never ;;
                *) _fusee_words "$word" make score --help --json --color --quiet --verbose ;;
            esac ;;
        ' blind make')
            case $word:$before in
                *:--seed) ;;
                *:--cases) ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--plant) _fusee_words "$word" plant model ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                *) _fusee_words "$word" --help --seed --cases --out --force --plant --jobs --json --color --quiet --verbose ;;
            esac ;;
        ' blind score')
            case $word:$before in
                *:--seal) ;;
                *:--model) _fusee_folders "$word" ;;
                *:--limit) ;;
                *:-j | *:--jobs) ;;
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --seal --model --limit --again --jobs --out --force --json --color --quiet --verbose ;;
                *) _fusee_folders "$word" ;;
            esac ;;
        ' paper')
            case $word:$before in
                *:-o | *:--out) _fusee_folders "$word" ;;
                *:--profiles) _fusee_folders "$word" ;;
                *:-j | *:--jobs) ;;
                *:--color) _fusee_words "$word" auto always never ;;
                *) _fusee_words "$word" --help --out --profiles --jobs --force --json --color --quiet --verbose ;;
            esac ;;
        ' explain')
            case $word:$before in
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --json --color --quiet --verbose ;;
                *) ;;
            esac ;;
        ' keys')
            case $word:$before in
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --names --json --color --quiet --verbose ;;
                *) _fusee_keys "$word" ;;
            esac ;;
        ' rules')
            case $word:$before in
                *:--color) _fusee_words "$word" auto always never ;;
                -*) _fusee_words "$word" --help --json --color --quiet --verbose ;;
                *) ;;
            esac ;;
    esac
}

complete -F _fusee fusee
