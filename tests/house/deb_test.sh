#!/bin/bash
# The Debian packages of a build: contents, control fields, equal bytes when packed twice; the unpacked program and module run.
# deb_test.sh SOURCE_FOLDER BUILD_FOLDER
. "$(dirname -- "$0")/lib.sh"
command -v dpkg-shlibdeps >/dev/null || skip 'dpkg-dev is missing'
source=$1 build=$2
export SOURCE_DATE_EPOCH=1700000000 FUSEE_PACKAGE_LEVEL=0  # quick

cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/one" >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; fail 'cpack (is everything built?)'; }
rm -rf "$work/one/_CPack_Packages"
cp -r "$work/one" "$work/two"
# Twice in the short form: the program alone, whose package has all kinds of files but static libraries.
[ -n "${FUSEE_LONG_TESTS:-}" ] || find "$work/two" -name '*.deb' ! -name 'fusee_*' -delete
for folder in one two; do "$source/packaging/repack.sh" "$work/$folder"/*.deb >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "repack.sh, $folder"; }; done
packages='fusee libfusee-dev python3-fusee'
if [ -x "$build/bin/fusee-mujoco" ]; then packages="$packages fusee-mujoco"; else echo 'NOT TESTED: fusee-mujoco, libmujoco-dev is missing'; fi
for package in $packages; do
    one=$(echo "$work/one/${package}"_*.deb)
    [ -s "$one" ] || fail "$package was not made"
    if [ "$package" = fusee ] || [ -n "${FUSEE_LONG_TESTS:-}" ]; then cmp "$one" "$work/two/${one##*/}" || fail "$package: two packings differ"; fi
    dpkg-deb -c "$one" >"$work/$package.list"
    dpkg-deb -f "$one" >"$work/$package.control"
    expect_in "$package" "./usr/share/doc/$package/copyright" "$work/$package.list"
    expect_in "$package" "./usr/share/doc/$package/changelog.gz" "$work/$package.list"
    if grep -v ' root/root ' "$work/$package.list"; then fail "$package: another owner than root"; fi
    if grep -v ' 2023-11-14 ' "$work/$package.list"; then fail "$package: another time than SOURCE_DATE_EPOCH"; fi
    dpkg-deb --fsys-tarfile "$one" | tar -xOf - "./usr/share/doc/$package/copyright" | grep -q '^License: GPL-3+$' || fail "$package: its licence"
done
for file in bin/fusee share/fusee/profiles/pnrvsa.toml share/man/man1/fusee.1.gz share/bash-completion/completions/fusee share/doc/fusee/docs/licences.md; do
    expect_in fusee "./usr/$file" "$work/fusee.list"
done
expect_in fusee 'libocct-data-exchange-7.6' "$work/fusee.control"
expect_in libfusee-dev 'libfusee_spring.a' "$work/libfusee-dev.list"
expect_in libfusee-dev 'fuseeConfig.cmake' "$work/libfusee-dev.list"
expect_in libfusee-dev 'libcgal-dev' "$work/libfusee-dev.control"
for library in fusee_nsga2 fusee_ceres fusee_brep_kernel fusee_step fusee_pictures; do
    expect_in fusee "fusee/$library.so" "$work/fusee.list"
    expect_in python3-fusee "fusee/$library.so" "$work/python3-fusee.list"
done
expect_in fusee 'libpagmo' "$work/fusee.control"
if grep libmujoco "$work/fusee.control"; then fail 'fusee itself needs MuJoCo'; fi
if [ -e "$work/fusee-mujoco.control" ]; then
    for program in fusee-mujoco fusee-mujoco-plant; do expect_in fusee-mujoco "./usr/bin/$program" "$work/fusee-mujoco.list"; done
    expect_in fusee-mujoco 'libmujoco2' "$work/fusee-mujoco.control"
fi
expect_in python3-fusee '_fusee.pyi' "$work/python3-fusee.list"
expect_in python3-fusee 'python3-numpy' "$work/python3-fusee.control"

for package in fusee python3-fusee; do dpkg-deb -x "$work/one/$package"_*.deb "$work/root"; done
expect_same 'the unpacked program' "$("$build/bin/fusee" --version)" "$("$work/root/usr/bin/fusee" --version)"
"$work/root/usr/bin/fusee" check "$work/root/usr/share/fusee/profiles/pnrvsa.toml" >"$work/log" || { cat "$work/log" >&2; fail 'the unpacked program'; }
# Found in PATH, it finds its libraries.
(cd "$work" && PATH="$work/root/usr/bin:$PATH" fusee render "$work/root/usr/share/fusee/profiles/pnrvsa.toml" --view cams -o cams.png) >"$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail 'a picture by the unpacked program'; }
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$work/root/usr/lib/python3/dist-packages" /usr/bin/python3 -c 'import fusee; print(fusee.__file__)' >"$work/log"
expect_in 'the unpacked module' "$work/root" "$work/log"
