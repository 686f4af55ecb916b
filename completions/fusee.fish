# fish completion for fusee, printed by `fusee completion fish`

# Is this the command that is typed?
function __fusee_at
    set -l words (commandline -opc)
    set -e words[1]
    set -l path
    for word in $words
        if contains -- "$path $word" ' make' ' fix' ' simulate' ' identify' ' design' ' diagnose' ' predict' ' case-template' ' blind' ' blind make' ' blind score' ' paper' ' coupons' ' calibrate' ' check' ' rules' ' keys'
            set path "$path $word"
        end
    end
    test "$path" = "$argv"
end

# Folders, and files with one of these endings.
function __fusee_files
    __fish_complete_path (commandline -ct) | string match -r -- '.*(?:/|\.(?:'(string join '|' $argv)'))(?:\t.*)?$'
end

# The keys of a profile; the program prints them.
function __fusee_keys
    set -l words (commandline -opc)
    $words[1] keys --names 2>/dev/null
end

complete -c fusee -f

complete -c fusee -n "__fusee_at ''" -a make -d 'Turn profiles into checked cams'
complete -c fusee -n "__fusee_at ''" -a fix -d 'Change what the findings suggest until a profile can be made'
complete -c fusee -n "__fusee_at ''" -a simulate -d 'Say what the joints of profiles do'
complete -c fusee -n "__fusee_at ''" -a identify -d 'Find a gear\'s friction from break-away tests'
complete -c fusee -n "__fusee_at ''" -a design -d 'Find springs for a profile\'s joint'
complete -c fusee -n "__fusee_at ''" -a diagnose -d 'Say where a built joint and its model part, which effect causes it and how far the gap shrinks with it in the model'
complete -c fusee -n "__fusee_at ''" -a predict -d 'Say what the model of a gap case, with or without the effects of a diagnosis, foretells for other inputs'
complete -c fusee -n "__fusee_at ''" -a case-template -d 'Write an empty gap case for a profile\'s joint'
complete -c fusee -n "__fusee_at ''" -a blind -d 'Benchmark the diagnosis on sealed cases'
complete -c fusee -n "__fusee_at ''" -a paper -d 'Make every table and figure of the paper anew'
complete -c fusee -n "__fusee_at ''" -a coupons -d 'Make test pieces for a profile\'s machine and cable'
complete -c fusee -n "__fusee_at ''" -a calibrate -d 'Turn measured coupons into a profile\'s compensation'
complete -c fusee -n "__fusee_at ''" -a check -d 'Run every rule on a profile\'s cams, or on a third-party mesh, without making files'
complete -c fusee -n "__fusee_at ''" -a rules -d 'List every manufacturability rule with its limits and sources'
complete -c fusee -n "__fusee_at ''" -a keys -d 'List every key of a profile with unit, allowed values and default'
complete -c fusee -n "__fusee_at ''" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ''" -l version -d 'Display program version information and exit'

complete -c fusee -n "__fusee_at ' make'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' make'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' make'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets one folder per design'
complete -c fusee -n "__fusee_at ' make'" -l via -x -a 'cgal openscad' -d 'Kernel that makes the STL'
complete -c fusee -n "__fusee_at ' make'" -l force -d 'Also replace files that were made from another source or changed since'
complete -c fusee -n "__fusee_at ' make'" -s j -l jobs -x -d 'Designs made at the same time'

complete -c fusee -n "__fusee_at ' fix'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' fix'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' fix'" -s o -l out -x -a '(__fusee_files toml)' -d 'File that gets the new profile'
complete -c fusee -n "__fusee_at ' fix'" -l reviews -d 'Take away what is to be reviewed and accepted, too'
complete -c fusee -n "__fusee_at ' fix'" -l keep -x -a '(__fusee_keys)' -d 'Key or table that is not changed, as k_pe.hub.bore_mm or cable'
complete -c fusee -n "__fusee_at ' fix'" -l most -x -d 'Profiles judged before the search gives up'
complete -c fusee -n "__fusee_at ' fix'" -l json -d 'Print the changes as JSON instead of text'
complete -c fusee -n "__fusee_at ' fix'" -l force -d 'Replace the file if it stands there already'

complete -c fusee -n "__fusee_at ' simulate'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' simulate'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' simulate'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets one folder per profile'
complete -c fusee -n "__fusee_at ' simulate'" -l levels -x -d 'Levels of co-contraction in place of the profile\'s'
complete -c fusee -n "__fusee_at ' simulate'" -l push-torque -x -d 'Joint torque of the push-and-release test [Nm]'
complete -c fusee -n "__fusee_at ' simulate'" -l at -x -d 'Torques of agonist, antagonist and joint [Nm] at which equilibrium, sensitivity and dead-band are asked for, such as 1,0.8,0'
complete -c fusee -n "__fusee_at ' simulate'" -l force -d 'Also replace files that were made from another source or changed since'
complete -c fusee -n "__fusee_at ' simulate'" -s j -l jobs -x -d 'Profiles simulated at the same time'

complete -c fusee -n "__fusee_at ' identify'" -a '(__fusee_files csv)'
complete -c fusee -n "__fusee_at ' identify'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' identify'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets one folder per file'
complete -c fusee -n "__fusee_at ' identify'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' design'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' design'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' design'" -l method -x -a 'algorithm_1 co_design pareto' -d 'In place of the profile\'s'
complete -c fusee -n "__fusee_at ' design'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets NAME-design and NAME-design.checkpoint'
complete -c fusee -n "__fusee_at ' design'" -l population -x -d 'Members of a generation, in place of the profile\'s'
complete -c fusee -n "__fusee_at ' design'" -l generations -x -d 'Generations, in place of the profile\'s'
complete -c fusee -n "__fusee_at ' design'" -l seed -x -d 'Seed, in place of the profile\'s'
complete -c fusee -n "__fusee_at ' design'" -s j -l jobs -x -d 'Threads'
complete -c fusee -n "__fusee_at ' design'" -l resume -d 'Go on from the checkpoint of a search that was stopped'
complete -c fusee -n "__fusee_at ' design'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' diagnose'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' diagnose'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' diagnose'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets diagnosis.json and diagnosis.html'
complete -c fusee -n "__fusee_at ' diagnose'" -l profile -x -a '(__fusee_files toml)' -d 'Profile that the rig was made from'
complete -c fusee -n "__fusee_at ' diagnose'" -l write-profile -x -a '(__fusee_files toml)' -d 'File that gets the profile corrected for the rig as it is, to cut new cams from by fusee make'
complete -c fusee -n "__fusee_at ' diagnose'" -s j -l jobs -x -d 'Threads'
complete -c fusee -n "__fusee_at ' diagnose'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' predict'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' predict'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' predict'" -l effects -x -a '(__fusee_files json)' -d 'A diagnosis.json'
complete -c fusee -n "__fusee_at ' predict'" -l inputs -x -a '(__fish_complete_directories)' -d 'Folder with CSV files named as the case\'s'
complete -c fusee -n "__fusee_at ' predict'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets the same files, measured columns replaced row by row'
complete -c fusee -n "__fusee_at ' predict'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' case-template'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' case-template'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' case-template'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the case'
complete -c fusee -n "__fusee_at ' case-template'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' blind'" -a make -d 'Write cases of rigs that the model does not know, and a sealed file of what is wrong with them'
complete -c fusee -n "__fusee_at ' blind'" -a score -d 'Diagnose every case, then open the seal and say how many were right'
complete -c fusee -n "__fusee_at ' blind'" -s h -l help -d 'Print this help message and exit'

complete -c fusee -n "__fusee_at ' blind make'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' blind make'" -l seed -x -d 'The same seed gives the same benchmark'
complete -c fusee -n "__fusee_at ' blind make'" -l cases -x -d 'How many cases'
complete -c fusee -n "__fusee_at ' blind make'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets them'
complete -c fusee -n "__fusee_at ' blind make'" -l force -d 'Also replace files that were made from another source or changed since'
complete -c fusee -n "__fusee_at ' blind make'" -l plant -x -a 'plant model' -d 'Who makes the measurements'
complete -c fusee -n "__fusee_at ' blind make'" -s j -l jobs -x -d 'Threads'

complete -c fusee -n "__fusee_at ' blind score'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' blind score'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' blind score'" -l seal -x -d 'The hash that fusee blind make printed'
complete -c fusee -n "__fusee_at ' blind score'" -l model -x -a '(__fish_complete_directories)' -d 'A benchmark made with --plant model'
complete -c fusee -n "__fusee_at ' blind score'" -l limit -x -d 'The first cases only'
complete -c fusee -n "__fusee_at ' blind score'" -l again -d 'Make diagnoses anew that are there already'
complete -c fusee -n "__fusee_at ' blind score'" -s j -l jobs -x -d 'Cases side by side'
complete -c fusee -n "__fusee_at ' blind score'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets score.json and score.html'
complete -c fusee -n "__fusee_at ' blind score'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' paper'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' paper'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets the folder paper'
complete -c fusee -n "__fusee_at ' paper'" -l profiles -x -a '(__fish_complete_directories)' -d 'Folder of the shipped profiles'
complete -c fusee -n "__fusee_at ' paper'" -s j -l jobs -x -d 'Threads'
complete -c fusee -n "__fusee_at ' paper'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' coupons'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' coupons'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' coupons'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets NAME-coupons'
complete -c fusee -n "__fusee_at ' coupons'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' calibrate'" -a '(__fusee_files csv)'
complete -c fusee -n "__fusee_at ' calibrate'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' calibrate'" -l profile -x -a '(__fusee_files toml)' -d 'Profile that the coupons were made from'
complete -c fusee -n "__fusee_at ' calibrate'" -l write-profile -x -a '(__fusee_files toml)' -d 'File that gets the profile with what was found'
complete -c fusee -n "__fusee_at ' calibrate'" -l json -d 'Print JSON'
complete -c fusee -n "__fusee_at ' calibrate'" -l force -d 'Replace the file if it stands there already'

complete -c fusee -n "__fusee_at ' check'" -a '(__fusee_files toml stl obj 3mf step stp)'
complete -c fusee -n "__fusee_at ' check'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' check'" -l process -x -a 'fdm sla sls mill mill4 edm laser all' -d 'How it is made, in place of the profile\'s'
complete -c fusee -n "__fusee_at ' check'" -l profile -x -a '(__fusee_files toml)' -d 'Of a mesh'
complete -c fusee -n "__fusee_at ' check'" -l limits -x -a '(__fusee_files toml)' -d 'Of a mesh'
complete -c fusee -n "__fusee_at ' check'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Of a mesh'
complete -c fusee -n "__fusee_at ' check'" -l json -d 'As JSON'
complete -c fusee -n "__fusee_at ' check'" -s j -l jobs -x -d 'Threads for a mesh'
complete -c fusee -n "__fusee_at ' check'" -l force -d 'Also replace files that were made from another source or changed since'

complete -c fusee -n "__fusee_at ' rules'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' rules'" -l json -d 'As JSON'

complete -c fusee -n "__fusee_at ' keys'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' keys'" -l names -d 'Print only the names, one per line'
