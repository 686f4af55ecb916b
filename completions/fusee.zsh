#compdef fusee
# zsh completion for fusee, printed by `fusee completion zsh`; as _fusee in a folder of $fpath, or sourced

# The keys of a profile; the program prints them.
__fusee_keys() {
    local -a keys=(${(f)"$(_call_program keys $program keys --names 2>/dev/null)"})
    compadd -S '' -a keys
}

_fusee() {
    local program=$words[1]
    local context state state_descr line curcontext=$curcontext
    typeset -A opt_args
    _arguments -s -C \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(- *)'--version'[Display program version information and exit]' \
        '1:command:->command' '*::argument:->argument'
    local -a menu=(
        'make:Turn profiles into checked cams'
        'fix:Change what the findings suggest until a profile can be made'
        'simulate:Say what the joints of profiles do'
        'identify:Find a gear'\''s friction from break-away tests'
        'design:Find springs for a profile'\''s joint'
        'diagnose:Say where a built joint and its model part, which effect causes it and how far the gap shrinks with it in the model'
        'predict:Say what the model of a gap case, with or without the effects of a diagnosis, foretells for other inputs'
        'case-template:Write an empty gap case for a profile'\''s joint'
        'blind:Benchmark the diagnosis on sealed cases'
        'paper:Make every table and figure of the paper anew'
        'coupons:Make test pieces for a profile'\''s machine and cable'
        'calibrate:Turn measured coupons into a profile'\''s compensation'
        'check:Run every rule on a profile'\''s cams, or on a third-party mesh, without making files'
        'rules:List every manufacturability rule with its limits and sources'
        'keys:List every key of a profile with unit, allowed values and default'
    )
    case $state in
        command) _describe command menu ;;
        argument) (($+functions[_fusee_$words[1]])) && _fusee_$words[1] ;;
    esac
}

_fusee_make() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets one folder per design]'':folder:_files -/' \
        '(--via)'--via='[Kernel that makes the STL]'':choice:(cgal openscad)' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '(-j --jobs)'{-j+,--jobs=}'[Designs made at the same time]'':0 to 1024: ' \
        '*'':file:_files -g "*.(toml)(-.)"'
}

_fusee_fix() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[File that gets the new profile]'':file:_files -g "*.(toml)(-.)"' \
        '(--reviews)'--reviews'[Take away what is to be reviewed and accepted, too]' \
        '*'--keep='[Key or table that is not changed, as k_pe.hub.bore_mm or cable]'':key:__fusee_keys' \
        '(--most)'--most='[Profiles judged before the search gives up]'':1 to 1000000: ' \
        '(--json)'--json'[Print the changes as JSON instead of text]' \
        '(--force)'--force'[Replace the file if it stands there already]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_simulate() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets one folder per profile]'':folder:_files -/' \
        '(--levels)'--levels='[Levels of co-contraction in place of the profile'\''s]'':2 to 1000: ' \
        '(--push-torque)'--push-torque='[Joint torque of the push-and-release test \[Nm\]]'':0 to 10000: ' \
        '*'--at='[Torques of agonist, antagonist and joint \[Nm\] at which equilibrium, sensitivity and dead-band are asked for, such as 1,0.8,0]'':T1,T2,TQ: ' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '(-j --jobs)'{-j+,--jobs=}'[Profiles simulated at the same time]'':0 to 1024: ' \
        '*'':file:_files -g "*.(toml)(-.)"'
}

_fusee_identify() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets one folder per file]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':file:_files -g "*.(csv)(-.)"'
}

_fusee_design() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--method)'--method='[In place of the profile'\''s]'':choice:(algorithm_1 co_design pareto)' \
        '(-o --out)'{-o+,--out=}'[Folder that gets NAME-design and NAME-design.checkpoint]'':folder:_files -/' \
        '(--population)'--population='[Members of a generation, in place of the profile'\''s]'':8 to 100000: ' \
        '(--generations)'--generations='[Generations, in place of the profile'\''s]'':1 to 1000000: ' \
        '(--seed)'--seed='[Seed, in place of the profile'\''s]'':0 to 1000000000: ' \
        '(-j --jobs)'{-j+,--jobs=}'[Threads]'':0 to 1024: ' \
        '(--resume)'--resume'[Go on from the checkpoint of a search that was stopped]' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_diagnose() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets diagnosis.json and diagnosis.html]'':folder:_files -/' \
        '(--profile)'--profile='[Profile that the rig was made from]'':file:_files -g "*.(toml)(-.)"' \
        '(--write-profile)'--write-profile='[File that gets the profile corrected for the rig as it is, to cut new cams from by fusee make]'':file:_files -g "*.(toml)(-.)"' \
        '(-j --jobs)'{-j+,--jobs=}'[Threads]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':folder:_files -/'
}

_fusee_predict() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--effects)'--effects='[A diagnosis.json]'':file:_files -g "*.(json)(-.)"' \
        '(--inputs)'--inputs='[Folder with CSV files named as the case'\''s]'':folder:_files -/' \
        '(-o --out)'{-o+,--out=}'[Folder that gets the same files, measured columns replaced row by row]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':folder:_files -/'
}

_fusee_case-template() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of the case]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_blind() {
    local context state state_descr line curcontext=$curcontext
    typeset -A opt_args
    _arguments -s -C \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '1:command:->command' '*::argument:->argument'
    local -a menu=(
        'make:Write cases of rigs that the model does not know, and a sealed file of what is wrong with them'
        'score:Diagnose every case, then open the seal and say how many were right'
    )
    case $state in
        command) _describe command menu ;;
        argument) (($+functions[_fusee_blind_$words[1]])) && _fusee_blind_$words[1] ;;
    esac
}

_fusee_blind_make() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--seed)'--seed='[The same seed gives the same benchmark]'':0 to 18446744073709551615: ' \
        '(--cases)'--cases='[How many cases]'':1 to 10000: ' \
        '(-o --out)'{-o+,--out=}'[Folder that gets them]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '(--plant)'--plant='[Who makes the measurements]'':choice:(plant model)' \
        '(-j --jobs)'{-j+,--jobs=}'[Threads]'':0 to 1024: '
}

_fusee_blind_score() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--seal)'--seal='[The hash that fusee blind make printed]'':TEXT: ' \
        '(--model)'--model='[A benchmark made with --plant model]'':folder:_files -/' \
        '(--limit)'--limit='[The first cases only]'':UINT: ' \
        '(--again)'--again'[Make diagnoses anew that are there already]' \
        '(-j --jobs)'{-j+,--jobs=}'[Cases side by side]'':0 to 1024: ' \
        '(-o --out)'{-o+,--out=}'[Folder that gets score.json and score.html]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':folder:_files -/'
}

_fusee_paper() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets the folder paper]'':folder:_files -/' \
        '(--profiles)'--profiles='[Folder of the shipped profiles]'':folder:_files -/' \
        '(-j --jobs)'{-j+,--jobs=}'[Threads]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]'
}

_fusee_coupons() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets NAME-coupons]'':folder:_files -/' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_calibrate() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--profile)'--profile='[Profile that the coupons were made from]'':file:_files -g "*.(toml)(-.)"' \
        '(--write-profile)'--write-profile='[File that gets the profile with what was found]'':file:_files -g "*.(toml)(-.)"' \
        '(--json)'--json'[Print JSON]' \
        '(--force)'--force'[Replace the file if it stands there already]' \
        '1'':file:_files -g "*.(csv)(-.)"'
}

_fusee_check() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--process)'--process='[How it is made, in place of the profile'\''s]'':choice:(fdm sla sls mill mill4 edm laser all)' \
        '(--profile)'--profile='[Of a mesh]'':file:_files -g "*.(toml)(-.)"' \
        '(--limits)'--limits='[Of a mesh]'':file:_files -g "*.(toml)(-.)"' \
        '(-o --out)'{-o+,--out=}'[Of a mesh]'':folder:_files -/' \
        '(--json)'--json'[As JSON]' \
        '(-j --jobs)'{-j+,--jobs=}'[Threads for a mesh]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files that were made from another source or changed since]' \
        '1'':file:_files -g "*.(toml|stl|obj|3mf|step|stp)(-.)"'
}

_fusee_rules() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--json)'--json'[As JSON]'
}

_fusee_keys() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--names)'--names'[Print only the names, one per line]'
}

if [[ $funcstack[1] == _fusee ]]; then
    _fusee "$@"
else
    compdef _fusee fusee
fi
