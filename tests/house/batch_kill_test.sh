#!/bin/bash
# A study that is killed at any moment and started again leaves the bytes of an undisturbed run.
# batch_kill_test.sh PROGRAM SOURCE [KILLS]: 5 kills unless said otherwise; 50 take about 2 minutes.
. "$(dirname -- "$0")/lib.sh"
program=$1 source=$2 kills=${3:-5}
sed 's/^chordal_error_mm = .*/chordal_error_mm = 0.005/' "$source/profiles/pnrvsa.toml" >"$work/base.toml"
cat >"$work/study.toml" <<'END'
[study]
base = "base.toml"
outputs = "meshes"
[vary]
k_se.hub.bore_mm = {from = 5.0, to = 6.0, steps = 4}
cable.diameter_mm = [0.8, 0.85]
END
cd "$work"
run() { "$program" batch study.toml --out "$1" >"$work/log" 2>&1; }
# Every file but the log of the rows, which has times.
list() { (cd "$1/study" && find . -type f ! -path './rows/*' -print0 | LC_ALL=C sort -z | xargs -0 sha256sum); }

begin=$(date +%s%N)
run undisturbed || fail "the study cannot be made: $(cat "$work/log")"
milliseconds=$((($(date +%s%N) - begin) / 1000000))
list undisturbed >wanted
[ "$(grep -c stl wanted)" -ge 16 ] || fail "the designs have no meshes: $(cat wanted)"
for kill in $(seq "$kills"); do
    if [ "$((kill % 10))" = 1 ]; then rm -rf killed; fi # some kills meet a folder that earlier ones left
    run killed &
    sleep "$(awk -v most="$milliseconds" -v seed="$kill$RANDOM" 'BEGIN { srand(seed); print rand() * most / 1000 }')"
    pkill -9 -P $! -x "$(basename "$program")" || true
    wait $! || true
    if [ "$((kill % 10))" = 0 ] || [ "$kill" = "$kills" ]; then
        run killed || fail "it cannot go on after kill $kill: $(cat "$work/log")"
        list killed >found
        cmp wanted found || fail "other bytes after kill $kill"
    fi
done
printf '%s kills in a run of %s ms, bytes equal\n' "$kills" "$milliseconds"
