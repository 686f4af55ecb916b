#!/bin/bash
# Builds fusee's programs and its tests from nothing, without a compiler cache, and prints the cost as Markdown: units, processor seconds by module,
# the ten slowest units, and the first program in units of one compilation: that of the corefinement of src/solid/cut.cpp at -O2, before and after.
# build_cost.sh [update]: "update" writes its first table into docs/guides/build.md, between its marks.
# build_cost.sh first [SOURCE]: only the program of designs; of another source tree, also one that has a single program.
set -eu
here=$(readlink -f -- "$(dirname -- "$0")")
source=$(readlink -f -- "${2:-$here/../..}")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export FUSEE_BUILD_COST=$work/cost LC_ALL=C CCACHE_DISABLE=1
launcher=$here/timed_command.sh

mkdir "$work/build"
timed() { # FILE COMMAND...: appends its user and system seconds to FILE
    local TIMEFORMAT='%U %S' file=$1
    { time "${@:2}" 2>&3; } 3>&2 2>>"$file"
}
timed "$work/configured" cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" \
    -DCMAKE_CXX_LINKER_LAUNCHER="$launcher" >"$work/log"
sed 's/$/ configuring/' "$work/configured" >"$work/cost"
unit() { # appends the seconds of the compilation in whose units the first program is stated
    local command
    command=$(sed -n 's/^ *"command": "\(.*\)",*$/\1/p' "$work/build/compile_commands.json" | grep -m 1 'unity_cut_cxx.cxx$\|solid/cut.cpp$')
    command=$(sed 's| -O1||; s| -o [^ ]*| -O2 -o /dev/null|; s| -c .*||' <<<"${command#"$launcher" }")
    (cd "$work/build" && timed "$work/unit" $command -c "$source/src/solid/cut.cpp")
}
build() { # TARGET: appends "target wall-seconds units"
    local begin=$SECONDS
    local target=$1
    cmake --build "$work/build" --target help | grep "^$1:" >/dev/null || target=fusee_app
    cmake --build "$work/build" --target "$target" >>"$work/log"
    echo "$1 $((SECONDS - begin))" >>"$work/wall"
    sed 's/ CMakeFiles/ app/' "$work/cost" | awk -v target="$1" '{ print target, $0 }' >>"$work/all"
    : >"$work/cost"
}
: >"$work/all"
unit
build fusee_make
unit
if [ "${1:-}" != first ]; then
    build fusee_diagnose
    build fusee_app
    build all
fi

# target user system output -> target seconds module file
awk '{
    module = $4; file = $4
    if (sub(/^src\//, "", module)) { sub(/\/.*/, "", module) } else if (sub(/^tests\//, "", module)) { sub(/\/.*/, "", module); module = "tests of " module } else if (file == "configuring") module = file; else module = "links of programs"
    sub(/CMakeFiles\/[^\/]*\.dir\//, "", file); sub(/\.o$/, "", file)
    print $1 "\t" $2 + $3 "\t" module "\t" file
}' "$work/all" >"$work/table"

report() {
    echo "Made by \`tests/bench/build_cost.sh update\` on $(nproc) processors ($(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)), $(c++ -dumpfullversion | sed 's/^/g++ /'), no compiler cache."
    echo
    echo '| target | commands | processor time [s] | time [s] |'
    echo '|---|---|---|---|'
    while read -r target wall; do
        awk -F '\t' -v target="$target" -v wall="$wall" '$1 == target { n++; s += $2 }
            BEGIN { what["fusee_make"] = "`./fusee make`"; what["fusee_diagnose"] = "then `./fusee diagnose`"
                    what["fusee_app"] = "then any other"; what["all"] = "then `./fusee test`" }
            END { printf "| %s | %d | %.0f | %d |\n", what[target], n, s, wall }' "$work/table"
    done <"$work/wall"
    echo
    awk -F '\t' 'NR == FNR { split($0, time, " "); unit += time[1]; n++; next } $1 == "fusee_make" { s += $2 }
        END { printf "`./fusee make` costs %.1f times the compilation of `src/solid/cut.cpp`, a corefinement by CGAL, at -O2 (%.1f s, mean of %d).\n", s / (unit / n), unit / n, n }' "$work/unit" "$work/table"
    echo
    echo '| module | units | processor time [s] |'
    echo '|---|---|---|'
    awk -F '\t' '{ n[$3]++; s[$3] += $2 } END { for (m in n) printf "| %s | %d | %.1f |\n", m, n[m], s[m] }' "$work/table" | sort -t '|' -k 4,4 -rn |
        awk -F '|' '$4 >= 20 { print; next } { modules++; units += $3; seconds += $4 }
            END { if (modules) printf "| %d others | %d | %.1f |\n", modules, units, seconds }'
    echo
    echo '| slowest unit | processor time [s] |'
    echo '|---|---|'
    sort -t "$(printf '\t')" -k 2,2 -rn "$work/table" | head -n 10 | awk -F '\t' '{ printf "| %s | %.1f |\n", $4, $2 }'
}
report >"$work/report"
cat "$work/report"
[ "${1:-}" = update ] || exit 0
page=$source/docs/guides/build.md
awk -v report="$work/report" '
    /<!-- build cost: end -->/ { inside = 0 }
    !inside { print }
    /<!-- build cost: begin -->/ { inside = 1; while ((getline line < report) > 0 && line !~ /^. module/) print line }' "$page" >"$work/page"
cp "$work/page" "$page"
