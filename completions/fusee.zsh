#compdef fusee
# zsh completion for fusee, printed by `fusee completion zsh`; as _fusee in a folder of $fpath, or sourced. The program says what can follow:
# src/app/usage/complete.h

_fusee() {
    local line
    local -a offered open
    for line in ${(f)"$($words[1] completion words -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)"}; do
        case $line in
            (/behind\ *) compset -P ${(b)${line#* }} ;;
            (/open) open=(-S '') ;;
            (/folders) _files -/ ;;
            (/files\ *) _files -g "*.(${line#* })(-.)" ;;
            (*) offered+=("${${line%%$'\t'*}//:/\\:}${${(M)line%%$'\t'*}/$'\t'/:}") ;;
        esac
    done
    (( $#offered )) && _describe fusee offered $open
}

if [[ $funcstack[1] == _fusee ]]; then
    _fusee "$@"
else
    compdef _fusee fusee
fi
