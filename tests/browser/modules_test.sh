#!/bin/bash
# The modules that draw the pages (web/src), in node: kit and pages with small results. modules_test.sh SOURCE
. "$(dirname -- "$0")/../house/lib.sh"
command -v node >/dev/null || skip 'node is not installed: no module of the pages was run'
cd "$1" && node --test tests/browser/*.test.mjs >"$work/log" 2>&1 || { grep -vE '^ok|duration_ms' "$work/log"; fail 'a module of the pages'; }
