#compdef fusee
# zsh completion for fusee; `source <(fusee completion zsh)`, or as _fusee in a folder of $fpath

_fusee() {
    local context state state_descr line
    typeset -A opt_args
    local -a commands=(
        'make:turn profiles into checked, exported cams'
        'keys:list every key of a profile'
        'rules:list the rules that a part is checked by'
        'completion:print the completion script of a shell'
    )
    _arguments -C \
        '(- *)--help[say how to use fusee]' \
        '(- *)--version[say which version this is]' \
        '1:command:->command' \
        '*::argument:->argument'
    case $state in
        command) _describe 'command' commands ;;
        argument)
            case $words[1] in
                make)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--via[kernel that makes the solids]:kernel:(cgal openscad)' \
                        '(-j --jobs)'{-j,--jobs}'[designs made at once]:number:' \
                        '(- *)--help[say how to use make]' \
                        '*:profile:_files -g "*.toml"' ;;
                completion) _arguments '(- *)--help[say how to use completion]' '1:shell:(bash zsh fish)' ;;
                *) _arguments '(- *)--help[say how to use it]' ;;
            esac ;;
    esac
}

if [[ $funcstack[1] == _fusee ]]; then
    _fusee "$@"
else
    compdef _fusee fusee
fi
