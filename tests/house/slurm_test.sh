#!/bin/bash
# A study as a job array on two nodes, one of which is lost half way, ends with the index of one process.
# The folder's name has what the shell and sbatch would read as more than a name.
# slurm_test.sh PROGRAM SOURCE [DESIGNS]     200 designs, or as many as are named
. "$(dirname -- "$0")/lib.sh"
. "$(dirname -- "$0")/slurm_cluster.sh"
program=$1 source=$2 designs=${3:-200}
[ "$(id -u)" = 0 ] || skip 'starting Slurm needs root'
for tool in $cluster_programs; do command -v "$tool" >/dev/null || skip "$tool is not installed"; done

array="it's 50% of \"\$(HOME)\" \`#\`"
cat >"$work/study.toml" <<END
[study]
base = "$source/profiles/pnrvsa.toml"
method = "latin_hypercube"
count = $designs
outputs = "figures"
[vary]
rig.peak_torque_Nm = {from = 0.9, to = 1.2}
k_se.hub.bore_mm = {from = 5.0, to = 60.0}
END
cd "$work"
trap 'cluster_stop; rm -rf "$work"' EXIT
cluster_start "$work/cluster" || {
    tail -n 5 "$work"/cluster/log/*.log >&2
    skip 'the daemons of Slurm cannot start here'
}
"$program" batch study.toml --out "$array" --slurm --slurm-tasks 8 >"$work/submitted"
index_job=$(sed -n 's/.* job \([0-9]*\) for the index.*/\1/p' "$work/submitted")
[ -n "$index_job" ] || fail "no job for the index: $(cat "$work/submitted")"
"$program" batch study.toml --out one --jobs 1 >"$work/log" 2>&1 & # at the same time, in another folder

for _ in $(seq 600); do # under way, and the node has a task
    rows=$(cat "$array"/study/rows/*.jsonl 2>/dev/null | wc -l)
    if [ "$rows" -ge $((designs / 5)) ] && cluster_freeze n2 "${program##*/}"; then break; fi
    sleep 0.1
done
cluster_crash n2
wait $! || fail "one process: $(cat "$work/log")"
for _ in $(seq 600); do
    [ -n "$(squeue -h -j "$index_job" 2>/dev/null)" ] || break
    sleep 0.3
done
[ -z "$(squeue -h -j "$index_job" 2>/dev/null)" ] || fail "the array does not end: $(squeue) $(tail -n 40 cluster/log/slurmctld.log)"
for file in index.csv index.sqlite index.html; do
    cmp "one/study/$file" "$array/study/$file" || fail "$file differs from that of one process"
done
for log in 1.log index.log; do [ -e "$array/study/slurm/$log" ] || fail "no $log in $array/study/slurm: $(ls "$array/study/slurm")"; done
again=$(grep -c 'requeue job .* due to failure of node n2' cluster/log/slurmctld.log) || fail 'the lost node had no task'
printf '%s designs in 8 tasks, %s ended by the lost node and run again, index as of one process\n' "$designs" "$again"
