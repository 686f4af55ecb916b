# fish completion for fusee, printed by `fusee completion fish`. The program says what can follow: src/app/usage/complete.h

function __fusee
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l behind ''
    for line in ($words[1] completion words -- $words[2..-1] "$word" 2>/dev/null)
        switch $line
            case '/behind *'
                set behind (string replace '/behind ' '' -- $line)
                set word (string replace -- $behind '' $word)
            case /open
            case /folders
                printf '%s\n' $behind(__fish_complete_directories "$word")
            case '/files *'
                set -l endings (string replace '/files ' '' -- $line)
                printf '%s\n' $behind(__fish_complete_path "$word" | string match -r -- '.*(?:/|\.(?:'$endings'))(?:\t.*)?$')
            case '*'
                printf '%s\n' $behind$line
        end
    end
end

complete -c fusee -f -a '(__fusee)'
