#!/bin/sh
# FuseeModule refuses an include that a module did not declare, and a header that does not compile alone; it accepts a good tree.
# layering_test.sh CMAKE_FOLDER
. "$(dirname -- "$0")/lib.sh"
modules=$1

# A house of two modules: high USES low.
make_house() {
    house=$work/$1
    mkdir -p "$house/include/fusee/low" "$house/include/fusee/high" "$house/src/low" "$house/src/high"
    cat >"$house/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(house CXX)
list(APPEND CMAKE_MODULE_PATH "$modules")
add_library(fusee_options INTERFACE)
install(TARGETS fusee_options EXPORT fuseeTargets)
include(FuseeModule)
fusee_module(low SOURCES src/low/low.cpp)
fusee_module(high SOURCES src/high/high.cpp USES low)
END
    echo 'inline int low() { return 1; }' >"$house/include/fusee/low/low.h"
    printf '#include "fusee/low/low.h"\ninline int high() { return low(); }\n' >"$house/include/fusee/high/high.h"
    echo '#include "fusee/low/low.h"' >"$house/src/low/low.cpp"
    printf '#include "fusee/high/high.h"\n' >"$house/src/high/high.cpp"
}
configure() { cmake -S "$house" -B "$house/build" -G Ninja >"$house/log" 2>&1; }
check_headers() { cmake --build "$house/build" --target all_verify_interface_header_sets >"$house/log" 2>&1; }

make_house good
configure || { cat "$house/log" >&2; fail 'a good house was refused'; }
check_headers || { cat "$house/log" >&2; fail 'good headers were refused'; }

# The same house, with a wrong include written after it was configured: the next build notices.
echo '#include "fusee/high/high.h"' >>"$house/src/low/low.cpp"
if cmake --build "$house/build" >"$house/log" 2>&1; then fail 'a later wrong include was not noticed'; fi
expect_in 'the message' "module 'low' (USES )" "$house/log"

refuse() {  # NAME FILE LINE
    make_house "$1"
    mkdir -p "$(dirname -- "$house/$2")"
    echo "$3" >>"$house/$2"
    if configure; then fail "accepted: $3 in $2"; fi
    tr -s '\n ' ' ' <"$house/log" >"$house/message"  # CMake folds long lines
    expect_in "$1" 'may not have: ' "$house/message"
}
refuse upwards_source src/low/low.cpp '#include "fusee/high/high.h"'
refuse upwards_header include/fusee/low/low.h '  #  include <fusee/high/high.h>'
refuse nested src/low/deep/deeper.cpp '#include "fusee/high/high.h"'
refuse private_header src/low/detail.h '#include "fusee/high/high.h"'
refuse climbing src/low/low.cpp '#include "../high/detail.h"'
refuse climbing_back src/low/low.cpp '#include "fusee/low/../high/high.h"'

make_house wrong_floor
sed -i 's/low.cpp)/low.cpp USES high)/' "$house/CMakeLists.txt"
if configure; then fail 'a module used one above it'; fi
expect_in 'wrong floor' 'floor below' "$house/log"

make_house lonely
echo 'inline std::string name() { return "no #include <string>"; }' >>"$house/include/fusee/low/low.h"
configure || fail 'a lonely header cannot be seen at configure time'
if check_headers; then fail 'a header that does not compile alone was accepted'; fi
expect_in 'lonely header' 'string' "$house/log"

# A module in two parts: a part may include what it uses itself, not what another part uses.
in_parts() {
    sed -i '/fusee_module(high/d' "$house/CMakeLists.txt"
    echo 'fusee_module(high PART one SOURCES src/high/high.cpp HEADERS high.h USES low)
fusee_module(high PART two SOURCES src/high/two.cpp USES high_one)
fusee_parts(high one two)' >>"$house/CMakeLists.txt"
    echo '#include "fusee/high/high.h"' >"$house/src/high/two.cpp"
}
make_house parts
in_parts
configure || { cat "$house/log" >&2; fail 'a module in parts was refused'; }
check_headers || { cat "$house/log" >&2; fail 'headers of a module in parts were refused'; }
echo '#include "fusee/low/low.h"' >>"$house/src/high/two.cpp"
if configure; then fail 'a part included what only another part uses'; fi

# With FUSEE_PARTIAL a module that is left out leaves out those that use it, and no other.
make_house partial
echo 'if(TARGET fusee_high OR NOT TARGET fusee_low)
  message(FATAL_ERROR "wrong modules")
endif()' >>"$house/CMakeLists.txt"
sed -i 's/USES low)/USES low absent)/' "$house/CMakeLists.txt"
if configure; then fail 'a module without what it uses was accepted'; fi
cmake -S "$house" -B "$house/build" -G Ninja -DFUSEE_PARTIAL=ON >"$house/log" 2>&1 || { cat "$house/log" >&2; fail 'not left out'; }
