# fish completion for fusee; `fusee completion fish | source`
set -l commands make keys rules completion
complete -c fusee -f
complete -c fusee -n "not __fish_seen_subcommand_from $commands" -l version -d 'say which version this is'
complete -c fusee -l help -d 'say how to use it'
complete -c fusee -n "not __fish_seen_subcommand_from $commands" -a make -d 'turn profiles into checked, exported cams'
complete -c fusee -n "not __fish_seen_subcommand_from $commands" -a keys -d 'list every key of a profile'
complete -c fusee -n "not __fish_seen_subcommand_from $commands" -a rules -d 'list the rules that a part is checked by'
complete -c fusee -n "not __fish_seen_subcommand_from $commands" -a completion -d 'print the completion script of a shell'
complete -c fusee -n '__fish_seen_subcommand_from make' -a '(__fish_complete_suffix .toml)'
complete -c fusee -n '__fish_seen_subcommand_from make' -s o -l out -x -a '(__fish_complete_directories)' -d 'folder for the results'
complete -c fusee -n '__fish_seen_subcommand_from make' -l via -x -a 'cgal openscad' -d 'kernel that makes the solids'
complete -c fusee -n '__fish_seen_subcommand_from make' -s j -l jobs -x -d 'designs made at once'
complete -c fusee -n '__fish_seen_subcommand_from completion' -a 'bash zsh fish'
