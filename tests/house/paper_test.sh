#!/bin/bash
# Every test that docs/paper.md and docs/theory name as proof exists.
# paper_test.sh SOURCE_FOLDER
. "$(dirname -- "$0")/lib.sh"
source=$1

# `Suite.Name` or `Prefix/Suite.Name`, both CamelCase; a file's name does not begin with a capital letter.
grep -ohE '`([A-Za-z]+/)?[A-Z][A-Za-z0-9]+\.[A-Z][A-Za-z0-9]+`' "$source/docs/paper.md" "$source"/docs/theory/*.md | tr -d '`' | sort -u >"$work/named"
[ "$(wc -l <"$work/named")" -gt 50 ] || fail 'docs/paper.md names hardly any test'
cat "$source"/tests/*/*_test.cpp >"$work/tests"
while IFS=. read -r suite name; do
    grep -qE "^TEST(_[FP])?\(${suite##*/}, $name\)" "$work/tests" || fail "there is no test $suite.$name"
    [[ $suite != */* ]] || grep -qE "INSTANTIATE_TEST_SUITE_P\(${suite%%/*}, *${suite##*/}," "$work/tests" ||
        fail "${suite##*/} is not instantiated as ${suite%%/*}"
done <"$work/named"
