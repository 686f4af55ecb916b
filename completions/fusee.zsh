#compdef fusee
# zsh completion for fusee; `source <(fusee completion zsh)`, or as _fusee in a folder of $fpath

_fusee() {
    local context state state_descr line
    typeset -A opt_args
    local -a commands=(
        'make:turn profiles into checked, exported cams'
        'fix:change a profile until it can be made'
        'simulate:say what the joints of profiles do'
        "design:find springs for a profile's joint"
        "identify:find a gear's friction from break-away tests"
        'coupons:make test pieces for a machine and a cable'
        'calibrate:turn measured coupons into compensation'
        'diagnose:say where a built joint and its model part, and why'
        'predict:say what the model of a gap case foretells'
        'case-template:write an empty gap case for a profile'
        'blind:benchmark the diagnosis on sealed cases'
        "paper:make the paper's tables and figures anew"
        "check:run every rule on a profile's cams, or on a mesh"
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
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use make]' \
                        '*:profile:_files -g "*.toml"' ;;
                fix)
                    _arguments \
                        '(-o --out)'{-o,--out}'[file for the new profile]:profile:_files -g "*.toml"' \
                        '--reviews[take away what is to be reviewed, too]' \
                        '*--keep[key or table that is not changed]:key:' \
                        '--most[profiles judged before the search gives up]:number:' \
                        '--json[as JSON]' \
                        '--force[replace the file if it stands there]' \
                        '(- *)--help[say how to use fix]' \
                        '1:profile:_files -g "*.toml"' ;;
                simulate)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--levels[levels of co-contraction]:number:' \
                        '--push-torque[joint torque of the push-and-release test]:torque:' \
                        '*--at[torques T1,T2,TQ of an equilibrium]:torques:' \
                        '(-j --jobs)'{-j,--jobs}'[profiles simulated at once]:number:' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use simulate]' \
                        '*:profile:_files -g "*.toml"' ;;
                design)
                    _arguments \
                        '--method[how springs are looked for]:method:(algorithm_1 co_design pareto)' \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--population[members of a generation]:number:' \
                        '--generations[generations]:number:' \
                        '--seed[seed of the search]:number:' \
                        '(-j --jobs)'{-j,--jobs}'[threads]:number:' \
                        '--resume[go on from the checkpoint]' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use design]' \
                        '1:profile:_files -g "*.toml"' ;;
                identify)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use identify]' \
                        '1:rows:_files -g "*.csv"' ;;
                coupons)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use coupons]' \
                        '1:profile:_files -g "*.toml"' ;;
                calibrate)
                    _arguments \
                        '--profile[profile of the coupons]:profile:_files -g "*.toml"' \
                        '--write-profile[calibrated profile to write]:profile:_files -g "*.toml"' \
                        '--json[as JSON]' \
                        '--force[replace the file if it stands there]' \
                        '(- *)--help[say how to use calibrate]' \
                        '1:sheet:_files -g "*.csv"' ;;
                diagnose)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--profile[profile of the rig]:profile:_files -g "*.toml"' \
                        '--write-profile[corrected profile to write]:profile:_files -g "*.toml"' \
                        '(-j --jobs)'{-j,--jobs}'[threads]:number:' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use diagnose]' \
                        '1:case:_files -/' ;;
                predict)
                    _arguments \
                        '--effects[diagnosis to predict with]:diagnosis:_files -g "*.json"' \
                        '--inputs[folder of other inputs]:folder:_files -/' \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use predict]' \
                        '1:case:_files -/' ;;
                case-template)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder of the case]:folder:_files -/' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use case-template]' \
                        '1:profile:_files -g "*.toml"' ;;
                blind)
                    case $words[2] in
                        make)
                            _arguments \
                                '1:step:(make score)' \
                                '--seed[seed of the benchmark]:number:' \
                                '--cases[how many cases]:number:' \
                                '--plant[who makes the measurements]:maker:(plant model)' \
                                '(-o --out)'{-o,--out}'[folder of the benchmark]:folder:_files -/' \
                                '(-j --jobs)'{-j,--jobs}'[threads]:number:' \
                                '--force[replace files of another source, and changed ones]' \
                                '(- *)--help[say how to use blind make]' ;;
                        score)
                            _arguments \
                                '1:step:(make score)' \
                                '--seal[hash that blind make printed]:hash:' \
                                '--model[benchmark made by the model]:folder:_files -/' \
                                '--limit[the first cases only]:number:' \
                                '--again[make diagnoses anew]' \
                                '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                                '(-j --jobs)'{-j,--jobs}'[cases side by side]:number:' \
                                '--force[replace files of another source, and changed ones]' \
                                '(- *)--help[say how to use blind score]' \
                                '2:benchmark:_files -/' ;;
                        *) _arguments '(- *)--help[say how to use blind]' '1:step:(make score)' ;;
                    esac ;;
                paper)
                    _arguments \
                        '(-o --out)'{-o,--out}'[folder for the results]:folder:_files -/' \
                        '--profiles[folder of the shipped profiles]:folder:_files -/' \
                        '(-j --jobs)'{-j,--jobs}'[threads]:number:' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use paper]' ;;
                check)
                    _arguments \
                        '--process[how it is made]:process:(fdm sla sls mill mill4 edm laser all)' \
                        '--profile[profile of the machine]:profile:_files -g "*.toml"' \
                        '--limits[file of limits of your own]:limits:_files -g "*.toml"' \
                        '(-o --out)'{-o,--out}'[folder for the coloured mesh]:folder:_files -/' \
                        '--json[as JSON]' \
                        '(-j --jobs)'{-j,--jobs}'[threads]:number:' \
                        '--force[replace files of another source, and changed ones]' \
                        '(- *)--help[say how to use check]' \
                        '1:profile or mesh:_files -g "*.(toml|stl|obj|3mf|step|stp)"' ;;
                rules) _arguments '--json[as JSON]' '(- *)--help[say how to use rules]' ;;
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
