#!/bin/bash
# The model that fusee writes for MuJoCo, in the official engine (npm, WebAssembly). Without node, npm or the package it is skipped with the
# reason.     mujoco_test.sh PROGRAM SOURCE BUILD [all]
. "$(dirname -- "$0")/../house/lib.sh"
program=$(readlink -f -- "$1") source=$(readlink -f -- "$2") modules=$(readlink -f -- "$3")/mujoco
for tool in node npm; do command -v $tool >/dev/null || skip "$tool is not installed: no model was run"; done

mkdir -p "$modules"
if ! cmp -s "$source/tests/mujoco/package-lock.json" "$modules/package-lock.json" || [ ! -e "$modules/done" ]; then
    rm -f "$modules/done"
    cp "$source/tests/mujoco/package.json" "$source/tests/mujoco/package-lock.json" "$source/tests/mujoco/.npmrc" "$modules"
    (cd "$modules" && timeout 120 npm ci >npm.log 2>&1) || skip 'npm ci failed, without its registry: no model was run'
    touch "$modules/done"
fi

cd "$work"
sed 's/^formats = .*/formats = ["stl"]/' "$source/profiles/pnrvsa.toml" >pnrvsa.toml
"$program" make pnrvsa.toml --out made >log 2>&1 || fail "make: $(cat log)"  # springs.csv: the law at the capstan
"$program" simulate pnrvsa.toml --levels 5 --out out --write-mjcf mjcf >log 2>&1 || fail "simulate: $(cat log)"
cp made/pnrvsa/springs.csv out/pnrvsa
python3 -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' mjcf/pnrvsa/joint_twin.py || fail 'joint_twin.py is not Python'
cp "$source/tests/mujoco/twin_test.mjs" "$modules"  # beside its node_modules
node "$modules/twin_test.mjs" "$work/mjcf/pnrvsa" "$work/out/pnrvsa" "${4-}"

"$program" case-template pnrvsa.toml --out case >log 2>&1 || fail "case-template: $(cat log)"
cat >effects.json <<'END'
{"effects": [{"id": "joint.coulomb", "side": "none", "parameter": {"value": 0.05}},
             {"id": "se.hysteresis", "side": "agonist", "parameter": {"value": 0.1}},
             {"id": "gear.backlash", "side": "antagonist", "parameter": {"value": 0.05}}]}
END
"$program" predict case --effects effects.json --out rows --write-mjcf rig >log 2>&1 || fail "predict: $(cat log)"
cp "$source/tests/mujoco/rig_test.mjs" "$source/tests/mujoco/experiments.mjs" rig/joint_twin.mjs "$modules"
node "$modules/rig_test.mjs" rig case rows
