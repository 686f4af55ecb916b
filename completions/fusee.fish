# fish completion for fusee, printed by `fusee completion fish`

# Is this the command that is typed?
function __fusee_at
    set -l words (commandline -opc)
    set -e words[1]
    set -l path
    for word in $words
        if contains -- "$path $word" ' make' ' batch' ' query' ' fix' ' budget' ' springs' ' simulate' ' identify' ' design' ' diagnose' ' predict' ' case-template' ' blind' ' blind make' ' blind score' ' paper' ' coupons' ' calibrate' ' check' ' rules' ' keys'
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

complete -c fusee -n "__fusee_at ''" -a make -d 'Make checked cams from profiles'
complete -c fusee -n "__fusee_at ''" -a batch -d 'Make every design of a study, with an index of their figures'
complete -c fusee -n "__fusee_at ''" -a query -d 'Ask the index of a study in SQL, read-only'
complete -c fusee -n "__fusee_at ''" -a fix -d 'Change a profile until it can be made'
complete -c fusee -n "__fusee_at ''" -a budget -d 'State the errors of joints as a shop builds them'
complete -c fusee -n "__fusee_at ''" -a springs -d 'Turn the wanted rates into springs that can be wound or bought'
complete -c fusee -n "__fusee_at ''" -a simulate -d 'Simulate the joints of profiles'
complete -c fusee -n "__fusee_at ''" -a identify -d 'Identify the friction of a gear from break-away tests'
complete -c fusee -n "__fusee_at ''" -a design -d 'Find springs for the joint of a profile'
complete -c fusee -n "__fusee_at ''" -a diagnose -d 'Diagnose a built joint'
complete -c fusee -n "__fusee_at ''" -a predict -d 'Predict the measurements of a gap case for other inputs, with or without the effects of a diagnosis'
complete -c fusee -n "__fusee_at ''" -a case-template -d 'Write an empty gap case for the joint of a profile'
complete -c fusee -n "__fusee_at ''" -a blind -d 'Benchmark the diagnosis on sealed cases'
complete -c fusee -n "__fusee_at ''" -a paper -d 'Reproduce every table and figure of the paper'
complete -c fusee -n "__fusee_at ''" -a coupons -d 'Make test pieces for the machine and the cable of a profile'
complete -c fusee -n "__fusee_at ''" -a calibrate -d 'Compute the compensation of a profile from measured coupons (shrinkage, bore offset, neutral axis of the cable, spring rates), or from the inspection sheet of a finished part (offset, eccentricity and rotation of its contour)'
complete -c fusee -n "__fusee_at ''" -a check -d 'Check the cams of a profile, or a third-party mesh, against every rule'
complete -c fusee -n "__fusee_at ''" -a rules -d 'List every rule with its limits and sources'
complete -c fusee -n "__fusee_at ''" -a keys -d 'List every key of a profile with unit, allowed values and default'
complete -c fusee -n "__fusee_at ''" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ''" -l version -d 'Display program version information and exit'

complete -c fusee -n "__fusee_at ' make'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' make'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' make'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the results'
complete -c fusee -n "__fusee_at ' make'" -l via -x -a 'cgal openscad' -d 'Kernel that makes the STL'
complete -c fusee -n "__fusee_at ' make'" -l force -d 'Also replace files of another source and changed files'
complete -c fusee -n "__fusee_at ' make'" -s j -l jobs -x -d 'Number of designs made at the same time'

complete -c fusee -n "__fusee_at ' batch'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' batch'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' batch'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that gets the folder of the study'
complete -c fusee -n "__fusee_at ' batch'" -l name -x -d 'Name of the folder for a list of profiles'
complete -c fusee -n "__fusee_at ' batch'" -l dry-run -d 'List the designs and the size on disk'
complete -c fusee -n "__fusee_at ' batch'" -l shard -x -d 'NUMBER/COUNT'
complete -c fusee -n "__fusee_at ' batch'" -l merge -d 'Make no design'
complete -c fusee -n "__fusee_at ' batch'" -l slurm -d 'Submit the study to Slurm'
complete -c fusee -n "__fusee_at ' batch'" -l slurm-tasks -x -d 'Tasks of the array'
complete -c fusee -n "__fusee_at ' batch'" -l slurm-options -x -d 'Further options of sbatch, e.g'
complete -c fusee -n "__fusee_at ' batch'" -l force -d 'Also replace files of another source and changed files'
complete -c fusee -n "__fusee_at ' batch'" -s j -l jobs -x -d 'Designs made at the same time'

complete -c fusee -n "__fusee_at ' query'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' query'"
complete -c fusee -n "__fusee_at ' query'" -s h -l help -d 'Print this help message and exit'

complete -c fusee -n "__fusee_at ' fix'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' fix'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' fix'" -s o -l out -x -a '(__fusee_files toml)' -d 'File of the new profile'
complete -c fusee -n "__fusee_at ' fix'" -l reviews -d 'Also remove the warnings'
complete -c fusee -n "__fusee_at ' fix'" -l keep -x -a '(__fusee_keys)' -d 'Key or table that stays unchanged, such as k_pe.hub.bore_mm or cable'
complete -c fusee -n "__fusee_at ' fix'" -l most -x -d 'Largest number of profiles that the search judges'
complete -c fusee -n "__fusee_at ' fix'" -l json -d 'Print the changes as JSON instead of text'
complete -c fusee -n "__fusee_at ' fix'" -l force -d 'Replace the file if it exists'

complete -c fusee -n "__fusee_at ' budget'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' budget'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' budget'" -l draws -x -d 'Number of joints to sample'
complete -c fusee -n "__fusee_at ' budget'" -l wanted -x -d 'Wanted error of the torque, 5 to 95 % of joints, to both sides [%]'
complete -c fusee -n "__fusee_at ' budget'" -l json -d 'Print JSON'

complete -c fusee -n "__fusee_at ' springs'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' springs'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' springs'" -s o -l out -x -a '(__fusee_files toml)' -d 'File of the new profile'
complete -c fusee -n "__fusee_at ' springs'" -l catalogue -x -a '(__fusee_files csv)' -d 'Springs on sale'
complete -c fusee -n "__fusee_at ' springs'" -l bought -d 'Take the springs of the catalogue, not wound ones'
complete -c fusee -n "__fusee_at ' springs'" -l wire-class -x -a 'sl sm sh dm dh' -d 'Wire of EN 10270-1 where the profile states none'
complete -c fusee -n "__fusee_at ' springs'" -l cycles -x -d 'Load cycles where the profile states none'
complete -c fusee -n "__fusee_at ' springs'" -l within -x -d 'Largest difference of a wound spring\'s rate from the wanted one, in percent'
complete -c fusee -n "__fusee_at ' springs'" -l most -x -d 'Springs to list of each kind'
complete -c fusee -n "__fusee_at ' springs'" -l accept-reviews -d 'Also take springs with warnings'
complete -c fusee -n "__fusee_at ' springs'" -l force -d 'Replace the file if it exists'

complete -c fusee -n "__fusee_at ' simulate'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' simulate'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' simulate'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the results'
complete -c fusee -n "__fusee_at ' simulate'" -l levels -x -d 'Number of levels of co-contraction'
complete -c fusee -n "__fusee_at ' simulate'" -l push-torque -x -d 'Joint torque of the push-and-release test [Nm]'
complete -c fusee -n "__fusee_at ' simulate'" -l at -x -d 'Torques of agonist, antagonist and joint [Nm], such as 1,0.8,0'
complete -c fusee -n "__fusee_at ' simulate'" -l force -d 'Also replace files of another source and changed files'
complete -c fusee -n "__fusee_at ' simulate'" -s j -l jobs -x -d 'Number of profiles simulated at the same time'

complete -c fusee -n "__fusee_at ' identify'" -a '(__fusee_files csv)'
complete -c fusee -n "__fusee_at ' identify'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' identify'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the results'
complete -c fusee -n "__fusee_at ' identify'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' design'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' design'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' design'" -l method -x -a 'algorithm_1 co_design pareto' -d 'Method of the search'
complete -c fusee -n "__fusee_at ' design'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of NAME-design and NAME-design.checkpoint'
complete -c fusee -n "__fusee_at ' design'" -l population -x -d 'Size of a generation'
complete -c fusee -n "__fusee_at ' design'" -l generations -x -d 'Number of generations'
complete -c fusee -n "__fusee_at ' design'" -l seed -x -d 'Seed'
complete -c fusee -n "__fusee_at ' design'" -s j -l jobs -x -d 'Number of threads'
complete -c fusee -n "__fusee_at ' design'" -l resume -d 'Continue a stopped search from its checkpoint'
complete -c fusee -n "__fusee_at ' design'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' diagnose'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' diagnose'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' diagnose'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of diagnosis.json and diagnosis.html'
complete -c fusee -n "__fusee_at ' diagnose'" -l profile -x -a '(__fusee_files toml)' -d 'Profile of the rig'
complete -c fusee -n "__fusee_at ' diagnose'" -l write-profile -x -a '(__fusee_files toml)' -d 'File of the profile that suits the rig as diagnosed'
complete -c fusee -n "__fusee_at ' diagnose'" -s j -l jobs -x -d 'Number of threads'
complete -c fusee -n "__fusee_at ' diagnose'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' predict'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' predict'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' predict'" -l effects -x -a '(__fusee_files json)' -d 'diagnosis.json with the effects'
complete -c fusee -n "__fusee_at ' predict'" -l inputs -x -a '(__fish_complete_directories)' -d 'Folder of CSV files with the same names as in the case'
complete -c fusee -n "__fusee_at ' predict'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the same files with predicted values in the measured columns'
complete -c fusee -n "__fusee_at ' predict'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' case-template'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' case-template'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' case-template'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the case'
complete -c fusee -n "__fusee_at ' case-template'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' blind'" -a make -d 'Make gap cases of simulated rigs, and a sealed file with their faults'
complete -c fusee -n "__fusee_at ' blind'" -a score -d 'Diagnose every case, then open the seal and count the correct diagnoses'
complete -c fusee -n "__fusee_at ' blind'" -s h -l help -d 'Print this help message and exit'

complete -c fusee -n "__fusee_at ' blind make'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' blind make'" -l seed -x -d 'Seed'
complete -c fusee -n "__fusee_at ' blind make'" -l cases -x -d 'Number of cases'
complete -c fusee -n "__fusee_at ' blind make'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of the benchmark'
complete -c fusee -n "__fusee_at ' blind make'" -l force -d 'Also replace files of another source and changed files'
complete -c fusee -n "__fusee_at ' blind make'" -l plant -x -a 'plant model' -d 'Source of the measurements'
complete -c fusee -n "__fusee_at ' blind make'" -s j -l jobs -x -d 'Number of threads'

complete -c fusee -n "__fusee_at ' blind score'" -a '(__fish_complete_directories)'
complete -c fusee -n "__fusee_at ' blind score'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' blind score'" -l seal -x -d 'Hash that fusee blind make printed'
complete -c fusee -n "__fusee_at ' blind score'" -l model -x -a '(__fish_complete_directories)' -d 'Benchmark made with --plant model'
complete -c fusee -n "__fusee_at ' blind score'" -l limit -x -d 'Number of cases, from the first'
complete -c fusee -n "__fusee_at ' blind score'" -l again -d 'Repeat existing diagnoses'
complete -c fusee -n "__fusee_at ' blind score'" -s j -l jobs -x -d 'Number of cases diagnosed at the same time'
complete -c fusee -n "__fusee_at ' blind score'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of score.json and score.html'
complete -c fusee -n "__fusee_at ' blind score'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' paper'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' paper'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that contains the result, the folder paper'
complete -c fusee -n "__fusee_at ' paper'" -l profiles -x -a '(__fish_complete_directories)' -d 'Folder of the shipped profiles'
complete -c fusee -n "__fusee_at ' paper'" -s j -l jobs -x -d 'Number of threads'
complete -c fusee -n "__fusee_at ' paper'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' coupons'" -a '(__fusee_files toml)'
complete -c fusee -n "__fusee_at ' coupons'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' coupons'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder that contains the result, the folder NAME-coupons'
complete -c fusee -n "__fusee_at ' coupons'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' calibrate'" -a '(__fusee_files csv)'
complete -c fusee -n "__fusee_at ' calibrate'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' calibrate'" -l profile -x -a '(__fusee_files toml)' -d 'Profile of the coupons'
complete -c fusee -n "__fusee_at ' calibrate'" -l write-profile -x -a '(__fusee_files toml)' -d 'File of the calibrated profile'
complete -c fusee -n "__fusee_at ' calibrate'" -l json -d 'Print JSON'
complete -c fusee -n "__fusee_at ' calibrate'" -l force -d 'Replace the file if it exists'

complete -c fusee -n "__fusee_at ' check'" -a '(__fusee_files toml stl obj 3mf step stp)'
complete -c fusee -n "__fusee_at ' check'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' check'" -l process -x -a 'fdm sla sls mill mill4 edm laser all' -d 'Process'
complete -c fusee -n "__fusee_at ' check'" -l profile -x -a '(__fusee_files toml)' -d 'Profile whose [process] states machine and limits'
complete -c fusee -n "__fusee_at ' check'" -l limits -x -a '(__fusee_files toml)' -d 'File of [[limits]], each with its reason'
complete -c fusee -n "__fusee_at ' check'" -s o -l out -x -a '(__fish_complete_directories)' -d 'Folder of NAME_check.3mf, which shows the findings in colours'
complete -c fusee -n "__fusee_at ' check'" -l json -d 'Print JSON'
complete -c fusee -n "__fusee_at ' check'" -s j -l jobs -x -d 'Number of threads for a mesh'
complete -c fusee -n "__fusee_at ' check'" -l force -d 'Also replace files of another source and changed files'

complete -c fusee -n "__fusee_at ' rules'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' rules'" -l json -d 'Print JSON'

complete -c fusee -n "__fusee_at ' keys'" -s h -l help -d 'Print this help message and exit'
complete -c fusee -n "__fusee_at ' keys'" -l names -d 'Print only the names, one per line'
