#!/bin/bash
# ./fusee builds what the command needs and what changed, and hands on arguments, folder and exit code; tried on a house of three small programs.
# launcher_test.sh LAUNCHER
. "$(dirname -- "$0")/lib.sh"
unset FUSEE_BUILD_DIR
house="$work/a house"
mkdir -p "$house/tests" "$work/elsewhere/sub folder" "$work/bin"
cp "$1" "$house/fusee"
cp "$(dirname -- "$1")/tests/total.py" "$house/tests"
printf '%s\n' '# tools: always there' dpkg >"$house/packages.txt"
cat >"$house/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(house LANGUAGES CXX)
enable_testing()
option(FUSEE_PARTIAL "" OFF)
option(FUSEE_BUILD_TESTS "" ON)
foreach(target make diagnose app mujoco)
  if(target STREQUAL make OR NOT FUSEE_PARTIAL OR EXISTS "${PROJECT_SOURCE_DIR}/all libraries")
    add_executable(fusee_${target} main.cpp)
    set_target_properties(fusee_${target} PROPERTIES OUTPUT_NAME fusee-${target} RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  endif()
endforeach()
if(TARGET fusee_app)
  set_target_properties(fusee_app PROPERTIES OUTPUT_NAME fusee)
endif()
if(FUSEE_BUILD_TESTS)
  add_test(NAME says COMMAND fusee_app 1)
  add_test(NAME skips COMMAND sh -c "echo 'SKIP: no such thing'; exit 77")
  set_tests_properties(skips PROPERTIES SKIP_RETURN_CODE 77)
endif()
END
cat >"$house/main.cpp" <<'END'
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
int main(int count, char** words) {
    if (count == 2 && std::string(words[1]) == "rest" && std::filesystem::path(words[0]).filename() == "fusee-make") {
        setenv("FUSEE_DOOR", "whole", 1);
        execv(getenv("FUSEE_LAUNCHER"), words);
    }
    std::printf("first %s", std::filesystem::current_path().filename().c_str());
    for (int i = 1; i < count; ++i) std::printf("|%s", words[i]);
    return count - 1 == 3 ? 42 : 0;
}
END

cd "$work/elsewhere/sub folder"
expect_same 'arguments and folder' 'first sub folder|make|a b.toml' "$("$house/fusee" make 'a b.toml' 2>"$work/err")"
expect_same 'nothing else on stderr' '' "$(cat "$work/err")"
[ -s "$house/build/fusee-build.log" ] || fail 'there is no log'

code=0
../../"a house"/fusee 1 2 3 >"$work/out" || code=$?
expect_same 'exit code' 42 "$code"
ln -s "$house/fusee" "$work/bin/linked"
expect_same 'through a symbolic link' 'first elsewhere|x' "$(cd .. && ../bin/linked x)"

sed -i 's/first/second/' "$house/main.cpp"
expect_same 'a changed source' 'second sub folder' "$("$house/fusee")"

# Each command builds its program; a program that lacks a command has the whole one built.
[ ! -e "$house/build/bin/fusee-diagnose" ] || fail 'make built the program of a diagnosis'
[ ! -e "$house/build/bin/fusee" ] || fail 'make built the whole program'
touch "$house/all libraries"
expect_same 'a diagnosis' 'second sub folder|--json|diagnose|make' "$("$house/fusee" --json diagnose make)"
[ -x "$house/build/bin/fusee-diagnose" ] || fail 'diagnose did not build its program'
[ ! -e "$house/build/bin/fusee" ] || fail 'diagnose built the whole program'
mkdir -p "$work/case"
printf '[model]\nmjcf = "arm.xml"\ncommand = ["own"]\n' >"$work/case/case.toml"
"$house/fusee" diagnose "$work/case" >"$work/out"
[ ! -e "$house/build/bin/fusee-mujoco" ] || fail "built for a case that has a program of its own"
sed -i '/command/d' "$work/case/case.toml"
expect_same 'a model of MuJoCo' "second sub folder|diagnose|$work/case" "$("$house/fusee" diagnose "$work/case")"
[ -x "$house/build/bin/fusee-mujoco" ] || fail 'the companion was not built'
expect_same 'the rest' 'second sub folder|rest' "$("$house/fusee" rest)"
[ -x "$house/build/bin/fusee" ] || fail 'the whole program was not built'

# Two calls at once on a changed source: both run the new program.
sed -i 's/second/third/' "$house/main.cpp"
"$house/fusee" a >"$work/a" &
first=$!
"$house/fusee" b >"$work/b"
wait "$first"
expect_same 'two at once, first' 'third sub folder|a' "$(cat "$work/a")"
expect_same 'two at once, second' 'third sub folder|b' "$(cat "$work/b")"

# A running program does not hold the lock: the next build need not wait for it.
exec 8>"$work/held"
"$house/fusee" >&8
flock -n "$house/build/.fusee-lock" true || fail 'the lock is still held'

"$house/fusee" test >"$work/out" || fail 'test failed'
expect_in 'test runs ctest' '100% tests passed, 0 tests failed out of 2' "$work/out"
expect_in 'the total' 's: 1 passed, 0 failed, 1 skipped' "$work/out"
expect_in 'why a test was skipped' '  skipped skips: no such thing' "$work/out"
"$house/fusee" test -R nothing-of-this-name >"$work/out" 2>&1
expect_in 'ctest gets the arguments' 'No tests were found' "$work/out"

FUSEE_BUILD_DIR="other build" "$house/fusee" >"$work/out"
[ -x "$work/elsewhere/sub folder/other build/bin/fusee-make" ] || fail 'FUSEE_BUILD_DIR was ignored'

# A copied tree builds its own sources, not those that its build folder remembers.
cp -r "$house" "$work/copy"
sed -i 's/third/copied/' "$work/copy/main.cpp"
expect_same 'a copied tree' 'copied sub folder' "$("$work/copy/fusee")"

echo 'int broken = "no";' >>"$house/main.cpp"
code=0
"$house/fusee" 2>"$work/err" >"$work/out" || code=$?
expect_same 'a broken build' 3 "$code"
expect_same 'a broken build runs nothing' '' "$(cat "$work/out")"
expect_in 'the compiler is quoted' 'invalid conversion' "$work/err"
expect_in 'the log is named' 'fusee-build.log' "$work/err"

# A build folder that cannot be used: said at once, with exit code 3 (docs/guides/build.md).
sed -i '$d' "$house/main.cpp"
refuse() { # refuse WHAT WORDS [COMMAND...]: the last runs it
    code=0
    "${@:3}" "$house/fusee" >"$work/out" 2>"$work/err" || code=$?
    expect_same "$1" 3 "$code"
    expect_in "$1" "$2" "$work/err"
}
echo >"$work/file"
FUSEE_BUILD_DIR="$work/file" refuse 'a file' 'cannot be made'
FUSEE_BUILD_DIR="$work/file/below" refuse 'below a file' 'cannot be made'
FUSEE_BUILD_DIR="$house" refuse 'the sources' 'folder of the sources'
mkdir "$work/mounted"
if unshare -m true 2>/dev/null; then
    on_disk() { FUSEE_BUILD_DIR="$work/mounted" refuse "$1" "$2" unshare -m sh -c 'mount -t tmpfs -o "$1" tmpfs "$FUSEE_BUILD_DIR" && exec "$2"' sh "$1"; }
    on_disk size=16k 'cannot be written'
    on_disk ro 'cannot be written'
    on_disk noexec 'runs no program'
fi
# Without flock.
mkdir "$work/few"
for tool in sh readlink dirname mkdir printf head wc chmod rm env; do ln -s "$(command -v "$tool")" "$work/few/$tool"; done
refuse 'no flock' 'flock is missing' env PATH="$work/few"

# A signal ends the build too.
printf '#!/bin/sh\ntouch "%s/few/builds"\nexec sleep 100\n' "$work" >"$work/few/ninja"
chmod +x "$work/few/ninja"
PATH="$work/few:$PATH" "$house/fusee" 2>"$work/err" &
waiting=$!
while [ ! -e "$work/few/builds" ] && kill -0 "$waiting"; do sleep 0.1; done
kill "$waiting"
code=0
wait "$waiting" || code=$?
expect_same 'a signal' 130 "$code"

# A missing package, with a pretended package system.
mkdir "$work/fake"
echo 'libabsent-dev' >>"$house/packages.txt"
cat >"$work/fake/dpkg-query" <<END
#!/bin/sh
echo 'installed dpkg'
if [ -e '$work/fake/absent' ]; then echo 'installed libabsent-dev'; fi
END
cat >"$work/fake/apt-get" <<END
#!/bin/sh
echo "\$DEBIAN_FRONTEND \$*" >>'$work/fake/calls'
case "\$*" in
*update*) touch '$work/fake/updated' ;;
*) [ -e '$work/fake/updated' ] && touch '$work/fake/absent' ;;
esac
END
printf '#!/bin/sh\nprintenv FAKE_ID || echo 0\n' >"$work/fake/id"
chmod +x "$work"/fake/*
PATH="$work/fake:$PATH" "$house/fusee" >"$work/out" 2>"$work/err" || fail 'packages could not be installed'
expect_in 'says what it installs' 'installing libabsent-dev' "$work/err"
expect_same 'first without, then after an update' \
    "$(printf '%s\n' 'install libabsent-dev' update 'install libabsent-dev')" \
    "$(sed 's/.*10min//; s/^noninteractive -qy -o DPkg::Lock::Timeout=600 //; s/ --no-install-recommends//; s/ *$//' "$work/fake/calls")"

# The programs of the profile's formats are installed too, apart from what the build needs, and no others.
rm "$work/fake/absent" "$work/fake/calls"
printf '%s\n' '# diagnose: not wanted' libunwanted-dev '# ngc: a format' viewer '# sliced: another one' unwanted >>"$house/packages.txt"
printf '%s\n' 'formats = ["stl", "ngc"]  # not "sliced"' >"$work/p.toml"
PATH="$work/fake:$PATH" "$house/fusee" make "$work/p.toml" >"$work/out" 2>"$work/err" || fail 'programs could not be installed'
expect_in 'says what it installs' 'installing libabsent-dev viewer' "$work/err"
expect_same 'the programs apart' "$(printf '%s\n' 'install libabsent-dev' 'install viewer')" \
    "$(sed 's/.*10min//; s/^noninteractive -qy -o DPkg::Lock::Timeout=600 //; s/ --no-install-recommends//; s/ *$//' "$work/fake/calls")"
[ -e "$house/build/fusee-packages.log" ] || fail 'there is no log of the packages'
printf '#!/bin/sh\ncase "$*" in *viewer*) exit 100 ;; esac\n' >"$work/fake/apt-get"
code=0
touch "$work/fake/absent"
PATH="$work/fake:$PATH" "$house/fusee" make "$work/p.toml" >"$work/out" 2>"$work/err" || code=$?
expect_same 'a program that cannot be installed' 3 "$code"
expect_in 'a program that cannot be installed' 'could not install: viewer' "$work/err"

# Whoever watches sees how far the packages are.
rm "$work/fake/absent"
cat >"$work/fake/apt-get" <<END
#!/bin/sh
printf '%s\n' '0 upgraded, 4 newly installed, 0 to remove.' 'Get:1 http://x y' 'Unpacking y ...'
sleep 2
touch '$work/fake/absent'
END
if command -v script >/dev/null; then
    PATH="$work/fake:$PATH" script -qec "'$house/fusee'" /dev/null >"$work/out" </dev/null
    expect_in 'how far the packages are' '4 packages, 16 % done' "$work/out"
fi
touch "$work/fake/absent"

# Neither root nor sudo: it says what to do.
rm "$work/fake/absent"
for tool in sh printenv readlink dirname sed awk sort tr mkdir flock grep cat tail head wc chmod rm; do ln -s "$(command -v $tool)" "$work/fake/$tool"; done
code=0
FAKE_ID=1000 PATH="$work/fake" "$house/fusee" make "$work/p.toml" 2>"$work/err" || code=$?
expect_same 'no rights' 3 "$code"
expect_in 'no rights' 'apt-get install --no-install-recommends libabsent-dev viewer' "$work/err"
