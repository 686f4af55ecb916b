#!/bin/bash
# fusee watch as a person uses it: save, replace by rename, break, mend, Ctrl-C; its page reloads itself.
# watch_test.sh PROGRAM SOURCE
. "$(dirname -- "$0")/lib.sh"
program=$1 source=$2
cd "$work"
sed -e 's/^formats = .*/formats = ["stl"]/' "$source/profiles/pnrvsa.toml" >mine.toml
sed -i 's/^name = .*/name = "mine"/' mine.toml

# await COUNT TEXT [FILE]: the log, or FILE, has TEXT so many times within a minute
await() {
    for _ in $(seq 300); do
        [ "$(grep -cF -- "$2" "${3:-log}")" -ge "$1" ] && return 0
        kill -0 "$watch" 2>/dev/null || break
        sleep 0.2
    done
    cat log >&2
    fail "'$2' was not said $1 times in ${3:-log}"
}

: >log
"$program" watch mine.toml --serve >log 2>&1 &
watch=$!
await 1 'law, contours and rules without a solid in'
await 1 ' made '
[ -s out/mine/report.html ] || fail 'no page'
address=$(sed -n 's/^page: \([^ ]*\) .*/\1/p' log)

# The page has the reload script only as it is served; another host's name is refused.
fetch() { curl -s --max-time 5 "$@"; }
command -v curl >/dev/null || printf 'no curl: the served page is not tested\n'
if command -v curl >/dev/null; then
    fetch "$address" >page
    expect_in 'the served page' "EventSource('/events')" page
    grep -q EventSource out/mine/report.html && fail 'the file itself was changed'
    expect_same 'another host' 403 "$(fetch -o /dev/null -w '%{http_code}' -H 'Host: example.org' "$address")"
    expect_same 'a file above the folder' 404 "$(fetch -o /dev/null -w '%{http_code}' --path-as-is "${address}../../mine.toml")"
    status() { fetch -o /dev/null -w '%{http_code}' --path-as-is "$@"; }
    expect_same 'a file above the folder, encoded' 404 "$(status "${address}%2e%2e/%2e%2e/mine.toml")"
    ln -s /etc/hostname out/mine/link.txt
    expect_same 'a link out of the folder' 404 "$(status "${address}link.txt")"
    rm out/mine/link.txt
    two_names() {
        exec 4<>"/dev/tcp/127.0.0.1/$1"
        printf 'GET / HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nHost: example.org\r\nConnection: close\r\n\r\n' "$1" >&4
        head -n 1 <&4 | tr -d '\r'
    }
    port=${address##*:} port=${port%/}
    expect_same 'two names' 'HTTP/1.1 403 Forbidden' "$(two_names "$port")"
    expect_same 'no name' 403 "$(status -H 'Host:' "$address")"
    expect_same 'the address of another server' 403 "$(status --request-target http://example.org/ -H 'Host: example.org' "$address")"
    expect_same 'a proxy for this one' 400 "$(status --request-target "${address}report.html" "$address")"
    expect_same 'what is no request' 405 "$(status -X POST "$address")"
    code=0
    "$program" watch mine.toml --serve --port "$port" --out second >second.log 2>&1 || code=$?
    expect_same 'a second one on its port' 2 "$code"
    expect_in 'a second one on its port' 'taken' second.log
    # A range of 4 kB that names the file a thousand times: it is sent once.
    ranges=$(printf '0-,%.0s' $(seq 1000))
    expect_same 'ranges' "200 $(stat -c %s out/mine/k_se.stl)" \
        "$(fetch -o /dev/null -w '%{http_code} %{size_download}' -H "Range: bytes=${ranges%,}" "${address}k_se.stl")"
    # Tabs that stay open, and clients that never finish a request.
    for _ in $(seq 40); do
        (curl -sN --max-time 60 "${address}events" >/dev/null || true) &
        (
            exec 3<>"/dev/tcp/127.0.0.1/$port"
            while printf 'G' >&3 && kill -0 "$watch"; do sleep 0.3; done
        ) 2>/dev/null &
    done
    sleep 1
    expect_same 'one more tab' 200 "$(status "$address")"
    (curl -sN --max-time 60 "${address}events" >events || true) &
    sleep 0.5
fi

sed -i 's/^preload_mm = .*/preload_mm = 12.0/' mine.toml # save
await 1 'changed: k_pe.spring.preload_mm 14.6 -> 12'
await 2 ' made '
if command -v curl >/dev/null; then await 1 'event: reload' events; fi

sed 's/^preload_mm = .*/preload_mm = 13.0/' mine.toml >new # an editor that replaces the file
mv new mine.toml
await 1 'changed: k_pe.spring.preload_mm 12 -> 13'

sed -i 's/^diameter_mm = .*/diameter_m = 1/' mine.toml # break
await 1 'bad profile, waiting for the next save'
await 1 'mine.toml:24:1: cable.diameter_m: unknown key'
kill -0 "$watch" || fail 'a bad profile ended it'

sed -i -e 's/^diameter_m = .*/diameter_mm = 0.8/' -e 's/^preload_mm = .*/preload_mm = 25.0/' mine.toml # mend, but impossible
await 1 'error: cable.bend_ratio'
sed -i 's/^preload_mm = .*/preload_mm = 11.5/' mine.toml
await 1 'preload_mm 25 -> 11.5' # the make of 13 may end only now: a count of makes would not tell which it was

sed -i 's/^preload_mm = .*/preload_mm = 11.0/' mine.toml
await 1 'preload_mm 11.5 -> 11'
kill -INT "$watch" # while it makes
code=0
wait "$watch" || code=$?
expect_same 'exit code after Ctrl-C' 130 "$code"
if find out -name '.fusee-staging-*' | grep .; then fail 'a half-written folder is left'; fi

code=0
"$program" watch missing.toml >log 2>&1 || code=$?
expect_same 'a missing profile' 2 "$code"
