# bash completion for fusee, printed by `fusee completion bash`. The program says what can follow: src/app/usage/complete.h
# shellcheck shell=bash

_fusee() {
    local word=${COMP_WORDS[COMP_CWORD]} behind='' line ending endings
    # --out=FOLDER arrives as three words.
    [ "$word" = = ] && word=''
    COMPREPLY=()
    while IFS= read -r line; do
        case $line in
            /behind\ *) behind=${line#* } word=${word#"$behind"} ;;
            /open) compopt -o nospace 2>/dev/null ;;
            /folders)
                compopt -o filenames 2>/dev/null
                mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -P "$behind" -- "$word") ;;
            /files\ *)
                IFS='|' read -ra endings <<<"${line#* }"
                for ending in "${endings[@]}"; do
                    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -P "$behind" -X "!*.$ending" -- "$word")
                done ;;
            -?$'\t'*) ;; # its long name is offered
            *) COMPREPLY+=("$behind${line%%$'\t'*}") ;;
        esac
    done < <("${COMP_WORDS[0]}" completion words -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}

complete -F _fusee fusee
