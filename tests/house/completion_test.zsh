# What zsh offers with the script of fusee, in a terminal of its own.
# completion_test.zsh COMPLETIONS_FOLDER PROGRAM, in the folder that completion_test.sh made
zmodload zsh/zpty || exit 1
zpty shell zsh -f -i
zpty -w shell "PROMPT=; stty -echo; path+=(${(q)2:h}); autoload -U compinit; compinit -u -D; source ${(q)1}/fusee.zsh"
# The words are printed, too.
zpty -w shell 'compadd() {
    if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd "$@"; return; fi
    local -a offered
    builtin compadd -A offered "$@"
    printf "\n<%s>" ${(Q)offered}; print
    builtin compadd "$@"
}
complete-and-say() {
    zle complete-word
    print "\n<end>"
}
zle -N complete-and-say
bindkey "^I" complete-and-say
print "<ready>"'
zpty -r shell ignored $'*<ready>\r*'

# expect WHAT EXPECTED TYPED
expect() {
    local text
    zpty -w -n shell "fusee $3"$'\t'
    zpty -r shell text '*<end>*' || { print -u2 "FAIL: zsh: $1: no answer"; exit 1; }
    zpty -w -n shell $'\C-u'
    local found=${(j:|:)${(uo)${(M)${(f)${text//$'\r'/}}:#\<*\>}:#<end>}}
    found=${${found//</}//>/}
    [[ $found == $2 ]] || { print -ru2 "FAIL: zsh: $1: expected '$2', found '$found'"; exit 1; }
}
expect 'a command begun' 'keys' k
expect 'profiles and folders' 'my arm.toml|some folder' 'make '
expect 'folders' 'some folder' 'make --out '
expect 'a set of values' 'cgal|openscad' 'make --via '
expect 'a step of the same name as a command' 'model|mujoco|plant|siconos' 'blind make --plant '
expect 'options' '--names' 'keys --n'
expect 'keys' 'k_pe.hub.bore_mm' 'fix --keep k_pe.hub.bor'
zpty -d shell
