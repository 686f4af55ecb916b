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
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1:command:->command' '*::argument:->argument'
    local -a menu=(
        'init:Write a first profile from a few answers'
        'make:Make checked cams from profiles'
        'watch:Remake a profile on each save'
        'check:Check the cams of a profile, or a third-party mesh, against every rule'
        'fix:Change a profile until it can be made'
        'batch:Make every design of a study, with an index of their figures'
        'query:Ask the index of a study in SQL, read-only'
        'design:Find springs for the joint of a profile'
        'springs:Turn the wanted rates into springs that can be wound or bought'
        'budget:State the errors of joints as a shop builds them'
        'render:Draw the cams, the joint, a curve or a gap map as a picture, PNG or SVG'
        'coupons:Make test pieces for the machine and the cable of a profile'
        'calibrate:Compute the compensation of a profile from measured coupons'
        'simulate:Simulate the joints of profiles'
        'case-template:Write an empty gap case for the joint of a profile'
        'identify:Identify the friction of a gear from break-away tests'
        'diagnose:Diagnose a built joint'
        'predict:Predict the measurements of a gap case for other inputs, with or without the effects of a diagnosis'
        'blind:Benchmark the diagnosis on sealed cases'
        'paper:Reproduce every table and figure of the paper'
        'explain:Explain a rule, a key of a profile, an effect of the diagnosis, or a term'
        'keys:List the keys of a profile with unit, allowed values and default'
        'rules:List the rules with their limits and sources'
    )
    case $state in
        command) _describe command menu ;;
        argument) (($+functions[_fusee_$words[1]])) && _fusee_$words[1] ;;
    esac
}

_fusee_init() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--torque)'--torque='[Torque of one motor at the joint, held for long, Nm (0.01 to 1000)]'':VALUE: ' \
        '(--overdrive)'--overdrive='[Torque of one motor at the joint for a short time]'':VALUE: ' \
        '(--least)'--least='[Least co-contraction in use, at the joint]'':VALUE: ' \
        '(--ratio)'--ratio='[Turns of a capstan for one turn of the joint (0.2 to 5)]'':VALUE: ' \
        '(--range)'--range='[Range of the joint between its stops]'':VALUE: ' \
        '(--law)'--law='[Springs that you measured at the capstan]'':VALUE: ' \
        '(--joint-stiffness)'--joint-stiffness='[Stiffness of the joint at the torque, capstans held]'':VALUE: ' \
        '(--friction)'--friction='[Friction of each gear]'':VALUE: ' \
        '(--friction-constant)'--friction-constant='[Part of the gear friction that does not grow with the load, at the capstan, Nm (0 to 100)]'':VALUE: ' \
        '(--cable)'--cable='[Cable and its diameter, mm (fibre, steel, 7x7, 7x19 or 7x49, then 0.2 to 8)]'':VALUE: ' \
        '(--breaking-load)'--breaking-load='[Breaking load of the cable]'':VALUE: ' \
        '(--shaft)'--shaft='[Diameter of the motors'\'' shafts, mm (2 to 50)]'':VALUE: ' \
        '(--process)'--process='[How the parts are made (fdm, sla, sls, mill, mill4)]'':VALUE: ' \
        '(--material)'--material='[Material of the parts]'':VALUE: ' \
        '(--bed)'--bed='[Side of the machine'\''s bed, mm (50 to 2000)]'':VALUE: ' \
        '*'--columns='[A column that is not recognised by its header]'':NAME=HEADER: ' \
        '(-y --yes)'{-y,--yes}'[Ask nothing]' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads]'':0 to 1024: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_make() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of the results]'':folder:_files -/' \
        '(--via)'--via='[Kernel that makes the STL]'':choice:(cgal openscad)' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of designs made at the same time]'':0 to 1024: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':file:_files -g "*.(toml)(-.)"'
}

_fusee_watch() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of the results, as of make]'':folder:_files -/' \
        '(--serve)'--serve'[Serve out/NAME to a browser on this machine (127.0.0.1)]' \
        '(--port)'--port='[Port of --serve]'':0 to 65535: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_check() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--process)'--process='[Process]'':choice:(fdm sla sls mill mill4 edm laser all)' \
        '(--profile)'--profile='[Profile whose \[process\] states machine and limits]'':file:_files -g "*.(toml)(-.)"' \
        '(--limits)'--limits='[File of \[\[limits\]\], each with its reason]'':file:_files -g "*.(toml)(-.)"' \
        '(-o --out)'{-o+,--out=}'[Folder of NAME_check.3mf, which shows the findings in colours]'':folder:_files -/' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads for a mesh]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml|stl|obj|3mf|step|stp)(-.)"'
}

_fusee_fix() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[File of the new profile]'':file:_files -g "*.(toml)(-.)"' \
        '(--reviews)'--reviews'[Also remove the warnings]' \
        '*'--keep='[Key or table that stays unchanged, such as k_pe.hub.bore_mm or cable]'':key:__fusee_keys' \
        '(--most)'--most='[Largest number of profiles that the search judges]'':1 to 1000000: ' \
        '(--force)'--force'[Replace the file if it exists]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_batch() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that gets the folder of the study]'':folder:_files -/' \
        '(--name)'--name='[Name of the folder for a list of profiles]'':TEXT: ' \
        '(--dry-run)'--dry-run'[List the designs and the size on disk]' \
        '(--shard)'--shard='[NUMBER/COUNT]'':TEXT: ' \
        '(--merge)'--merge'[Make no design]' \
        '(--slurm)'--slurm'[Submit the study to Slurm]' \
        '(--slurm-tasks)'--slurm-tasks='[Tasks of the array]'':0 to 1000: ' \
        '(--slurm-options)'--slurm-options='[Further options of sbatch, e.g]'':TEXT: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(-j --jobs)'{-j+,--jobs=}'[Designs made at the same time]'':0 to 1024: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':file:_files -g "*.(toml)(-.)"'
}

_fusee_query() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--seconds)'--seconds='[Longest time of the query \[s\]]'':1 to 86400: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':folder:_files -/' \
        '2'':TEXT: '
}

_fusee_design() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--method)'--method='[Method of the search]'':choice:(algorithm_1 co_design pareto)' \
        '(-o --out)'{-o+,--out=}'[Folder of NAME-design and NAME-design.checkpoint]'':folder:_files -/' \
        '(--population)'--population='[Size of a generation]'':8 to 100000: ' \
        '(--generations)'--generations='[Number of generations]'':1 to 1000000: ' \
        '(--seed)'--seed='[Seed]'':0 to 1000000000: ' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads]'':0 to 1024: ' \
        '(--resume)'--resume'[Continue a stopped search from its checkpoint]' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_springs() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[File of the new profile]'':file:_files -g "*.(toml)(-.)"' \
        '(--catalogue)'--catalogue='[Springs on sale]'':file:_files -g "*.(csv)(-.)"' \
        '*'--columns='[A column that is not recognised by its header]'':NAME=HEADER: ' \
        '(--bought)'--bought'[Take the springs of the catalogue, not wound ones]' \
        '(--wire-class)'--wire-class='[Wire of EN 10270-1 where the profile states none]'':choice:(sl sm sh dm dh)' \
        '(--cycles)'--cycles='[Load cycles where the profile states none]'':1 to 1000000000000: ' \
        '(--within)'--within='[Largest difference of a wound spring'\''s rate from the wanted one, in percent]'':0 to 10: ' \
        '(--most)'--most='[Springs to list of each kind]'':1 to 1000: ' \
        '(--accept-reviews)'--accept-reviews'[Also take springs with warnings]' \
        '(--force)'--force'[Replace the file if it exists]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_budget() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--draws)'--draws='[Number of joints to sample]'':20 to 100000: ' \
        '(--wanted)'--wanted='[Wanted error of the torque, 5 to 95 % of joints, to both sides \[%\]]'':0.01 to 100: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_render() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--view)'--view='[What to draw, see below]'':VIEW: ' \
        '(-o --out)'{-o+,--out=}'[The picture, *.png or *.svg]'':FILE: ' \
        '(--width)'--width='[Width or height of the PNG and of shaded pictures, whichever is larger \[px\]]'':16 to 8000: ' \
        '(--dark)'--dark'[Charts on a dark page]' \
        '(--co-contraction)'--co-contraction='[Load of both capstans in the view assembly \[Nm\]]'':0 to 10000: ' \
        '(--joint-angle)'--joint-angle='[Angle of the joint from its middle in the view assembly \[deg\]]'':-360 to 360: ' \
        '(--force)'--force'[Replace the file if it exists]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_coupons() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that contains the result, the folder NAME-coupons]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_calibrate() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--profile)'--profile='[Profile of the coupons]'':file:_files -g "*.(toml)(-.)"' \
        '(--write-profile)'--write-profile='[File of the calibrated profile]'':file:_files -g "*.(toml)(-.)"' \
        '*'--columns='[A column that is not recognised by its header]'':NAME=HEADER: ' \
        '(--force)'--force'[Replace the file if it exists]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(csv)(-.)"'
}

_fusee_simulate() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of the results]'':folder:_files -/' \
        '(--levels)'--levels='[Number of levels of co-contraction]'':2 to 1000: ' \
        '(--push-torque)'--push-torque='[Joint torque of the push-and-release test \[Nm\]]'':0 to 10000: ' \
        '*'--at='[Torques of agonist, antagonist and joint \[Nm\], such as 1,0.8,0]'':T1,T2,TQ: ' \
        '(--write-mjcf)'--write-mjcf='[Folder of the joints as models for MuJoCo, with companion programs that apply the exact laws]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of profiles simulated at the same time]'':0 to 1024: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':file:_files -g "*.(toml)(-.)"'
}

_fusee_case-template() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--next)'--next='[diagnosis.json of a case]'':file:_files -g "*.(json)(-.)"' \
        '(-o --out)'{-o+,--out=}'[Folder of the case]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(toml)(-.)"'
}

_fusee_identify() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of the results]'':folder:_files -/' \
        '*'--columns='[A column that is not recognised by its header]'':NAME=HEADER: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':file:_files -g "*.(csv)(-.)"'
}

_fusee_diagnose() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder of diagnosis.json and diagnosis.html]'':folder:_files -/' \
        '(--profile)'--profile='[Profile of the rig]'':file:_files -g "*.(toml)(-.)"' \
        '(--write-profile)'--write-profile='[File of the profile that suits the rig as diagnosed, with --profile]'':file:_files -g "*.(toml)(-.)"' \
        '(--write-mjcf)'--write-mjcf='[Folder of the rig with its effects as a model for MuJoCo, with companion programs that apply the exact laws]'':folder:_files -/' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':folder:_files -/'
}

_fusee_predict() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--effects)'--effects='[diagnosis.json with the effects]'':file:_files -g "*.(json)(-.)"' \
        '(--inputs)'--inputs='[Folder of CSV files with the same names as in the case]'':folder:_files -/' \
        '(-o --out)'{-o+,--out=}'[Folder of the same files with predicted values in the measured columns]'':folder:_files -/' \
        '(--write-mjcf)'--write-mjcf='[Folder of the rig with its effects as a model for MuJoCo, with companion programs that apply the exact laws]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':folder:_files -/'
}

_fusee_blind() {
    local context state state_descr line curcontext=$curcontext
    typeset -A opt_args
    _arguments -s -C \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1:command:->command' '*::argument:->argument'
    local -a menu=(
        'make:Make gap cases of simulated rigs, and a sealed file with their faults'
        'score:Diagnose every case, then open the seal and count the correct diagnoses'
    )
    case $state in
        command) _describe command menu ;;
        argument) (($+functions[_fusee_blind_$words[1]])) && _fusee_blind_$words[1] ;;
    esac
}

_fusee_blind_make() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--seed)'--seed='[Seed]'':0 to 18446744073709551615: ' \
        '(--cases)'--cases='[Number of cases]'':1 to 10000: ' \
        '(-o --out)'{-o+,--out=}'[Folder of the benchmark]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--plant)'--plant='[Source of the measurements]'':choice:(plant model)' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads]'':0 to 1024: ' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]'
}

_fusee_blind_score() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--seal)'--seal='[Hash that fusee blind make printed]'':TEXT: ' \
        '(--model)'--model='[Benchmark made with --plant model]'':folder:_files -/' \
        '(--limit)'--limit='[Number of cases, from the first]'':UINT: ' \
        '(--again)'--again'[Repeat existing diagnoses]' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of cases diagnosed at the same time]'':0 to 1024: ' \
        '(-o --out)'{-o+,--out=}'[Folder of score.json and score.html]'':folder:_files -/' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '1'':folder:_files -/'
}

_fusee_paper() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(-o --out)'{-o+,--out=}'[Folder that contains the result, the folder paper]'':folder:_files -/' \
        '(--profiles)'--profiles='[Folder of the shipped profiles]'':folder:_files -/' \
        '(-j --jobs)'{-j+,--jobs=}'[Number of threads]'':0 to 1024: ' \
        '(--force)'--force'[Also replace files of another source and changed files]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]'
}

_fusee_explain() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':NAME: '
}

_fusee_keys() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--names)'--names'[Print only the names, one per line]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':key:__fusee_keys'
}

_fusee_rules() {
    _arguments -s \
        '(- *)'{-h,--help}'[Print this help message and exit]' \
        '(--json)'--json'[Print one JSON object instead of text (docs/json.md)]' \
        '(--color)'--color='[Colour of severity words]'':choice:(auto always never)' \
        '(-q --quiet)'{-q,--quiet}'[Print errors and what was asked for]' \
        '(-v --verbose)'{-v,--verbose}'[Print more]' \
        '*'':WORD: '
}

if [[ $funcstack[1] == _fusee ]]; then
    _fusee "$@"
else
    compdef _fusee fusee
fi
