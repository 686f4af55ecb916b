#!/bin/bash
# timed_command.sh COMMAND...: runs it and appends "user system output-file" [s] to $FUSEE_BUILD_COST. A launcher of compiler and linker.
output= previous=
for argument; do
    [ "$previous" != -o ] || output=$argument
    previous=$argument
done
TIMEFORMAT="%U %S $output"
{ time "$@" 2>&3; } 3>&2 2>>"$FUSEE_BUILD_COST"
