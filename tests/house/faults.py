#!/usr/bin/env python3
"""Every command under every fault: docs/robustness.md.

faults.py PROGRAM SOURCE SHIM [--long] [--kills N] [--only COMMAND,...] [--faults FAULT,...]

Each command runs undisturbed once. Then, from an empty output folder, with each fault. A run must end with exit code 0, 1 (as undisturbed), 2
or 130; say so on standard error unless it is 0; leave no hidden folder and no partial file; leave all files of the undisturbed run, byte for
byte, or none; and the next undisturbed run must give the same bytes. kill -9 may leave a hidden folder and, within the moves of the last step,
old and new files: the next run must end with the same bytes and no leftovers. Prints a table; exit code 1 if anything is wrong.
"""
import argparse
import hashlib
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

COMMANDS = {  # name: arguments; o is the output folder, which exists
    "make": "make fast.toml --out o",
    "simulate": "simulate fast.toml --levels 3 --out o",
    "design": "design fast.toml --generations 3 --out o",
    "fix": "fix bad.toml --out o/fixed.toml",
    "coupons": "coupons fast.toml --out o",
    "calibrate": "calibrate profiles/examples/coupon.csv --profile fast.toml --write-profile o/calibrated.toml",
    "springs": "springs fast.toml --out o/springs.toml",
    "render": "render fast.toml --view cams -o o/cams.png --force",
    "check": "check box.stl --process fdm --out o",
    "case-template": "case-template fast.toml --out o/case",
    "identify": "identify profiles/examples/break_away.csv --out o",
    "diagnose": "diagnose profiles/gap/paper_table_1 --out o/diagnosis",
    "predict": "predict profiles/gap/paper_table_1 --out o/rows",
    "blind make": "blind make --seed 1 --cases 2 --out o/blind",
    "batch": "batch study.toml --out o",
    "budget": "budget fast.toml --wanted 3",
    "keys": "keys",
}
SHORT = ["coupons", "calibrate", "keys"]  # of the test in CI
READS_ONLY = ["budget", "keys"]  # nothing to lose by kill -9
REFUSE_EXISTING = ["fix", "design", "springs", "calibrate"]  # a file that the user names
LEFT = re.compile(r"fusee-staging-|fusee-temporary-|\.part-|\.trial-|fusee-crash-")
SOME = re.compile(r"rows/|index\.sqlite|\.fusee\.json$")  # holds times, a database's pages, or names of the source


class House:
    def __init__(self, program, source, shim, folder):
        self.program, self.shim, self.work = str(pathlib.Path(program).resolve()), str(pathlib.Path(shim).resolve()), folder
        shutil.copytree(pathlib.Path(source) / "profiles", folder / "profiles")
        shutil.copy(pathlib.Path(source) / "tests/fuzz/seeds/stl/box.stl", folder)
        text = (folder / "profiles/pnrvsa.toml").read_text()
        text = re.sub(r"(?m)^formats = .*", 'formats = ["stl"]', text)
        fine = re.sub(r"(?m)^chordal_error_mm = .*", "chordal_error_mm = 0.005", text)
        (folder / "fast.toml").write_text(fine)
        (folder / "bad.toml").write_text(re.sub(r"(?m)^chordal_error_mm = .*", "chordal_error_mm = 0.01", text))
        (folder / "study.toml").write_text(
            '[study]\nbase = "fast.toml"\noutputs = "meshes"\n[vary]\nk_se.hub.bore_mm = {from = 5.0, to = 6.0, steps = 2}\n')
        self.wanted, self.code, self.seconds = {}, {}, {}

    def clear(self):
        for name in ("o", "tmp"):
            shutil.rmtree(self.work / name, ignore_errors=True)
            (self.work / name).mkdir()

    def files(self):
        found = {}
        for path in sorted((self.work / "o").rglob("*")):
            name = str(path.relative_to(self.work / "o"))
            if path.is_file() and not SOME.search(name) and not LEFT.search(name):
                found[name] = hashlib.sha256(path.read_bytes()).hexdigest()
        return found

    def left(self):
        return [str(p.relative_to(self.work)) for p in self.work.rglob("*") if LEFT.search(p.name)]

    def start(self, command, fault="", shell="", before=None, **more):
        env = dict(os.environ, TMPDIR=str(self.work / "tmp"))
        words = [self.program, *COMMANDS[command].split(), *more.pop("extra", [])]
        if fault:
            env.update(LD_PRELOAD=self.shim, FUSEE_FAULT=fault)
        if shell:
            words = ["bash", "-c", shell, "bash", *words]
        more.setdefault("stdout", subprocess.DEVNULL)
        return subprocess.Popen(words, cwd=self.work, env=env, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                errors="replace", preexec_fn=before, **more)

    def run(self, command, **how):
        running = self.start(command, **how)
        _, said = running.communicate(timeout=600)
        return running.returncode, said

    def undisturbed(self, command):
        self.clear()
        begin = time.monotonic()
        code, said = self.run(command)
        self.seconds[command] = time.monotonic() - begin
        self.wanted[command], self.code[command] = self.files(), code
        return "" if code == 0 and not self.left() else f"undisturbed: exit code {code}: {said[-300:]}"

    def again(self, command):
        """The next undisturbed run."""
        code, said = self.run(command, extra=["--force"] if command in REFUSE_EXISTING else [])
        if code != self.code[command]:
            return f"the next run ends with {code}: {said[-200:]}"
        if self.files() != self.wanted[command]:
            return "the next run leaves other bytes"
        return f"the next run leaves {self.left()}" if self.left() else ""

    def judge(self, command, code, said, repeat=True, silent=False, codes=(0, 2, 130)):
        """What is wrong with a disturbed end; "" if nothing. @param silent: standard error is lost too"""
        if code not in codes:
            return f"exit code {code}: {said[-300:]}"
        if code != 0 and not said.strip() and not silent:
            return f"exit code {code} and no message"
        if "internal error" in said:
            return said[-300:]
        found = self.files()
        if code == 0 and found != self.wanted[command]:
            return "exit code 0, but other files"
        stays = command in ("design", "batch")  # a stopped search keeps its checkpoint, a study its finished designs
        if found and found != self.wanted[command] and not stays:
            return f"half of the files: {sorted(found)[:3]}"
        if self.left():
            return f"left: {self.left()[:3]}"
        return self.again(command) if repeat else ""


def limit(kind, value):
    return lambda: resource.setrlimit(kind, (value, value))


def shim_fault(call, error, counts):
    def trial(house, command):
        for count in counts:
            house.clear()
            wrong = house.judge(command, *house.run(command, fault=f"{call}:{error}:{count}"))
            if wrong:
                return f"{call} {count}: {wrong}"
        return ""
    return trial


def started(silent=False, codes=(0, 2, 130), files=False, json=False, **how):
    """@param files: all that the command writes must be there, whatever it ends with"""
    def trial(house, command):
        house.clear()
        code, said = house.run(command, **how, **({"extra": ["--json"]} if json else {}))
        if files and house.files() != house.wanted[command]:
            return f"exit code {code}, and other files: {said[-300:]}"
        if files and said.count("standard output cannot be written") > 1:
            return f"told twice: {said}"
        return house.judge(command, code, said, silent=silent, codes=codes)
    return trial


def stopped(number, times):
    def trial(house, command):
        for i in range(times):
            house.clear()
            running = house.start(command)
            # Before `main` the loader binds the libraries: a signal then ends the process, and nothing is written.
            time.sleep(max(0.2, house.seconds[command] * (i + 0.5) / times))
            running.send_signal(number)
            _, said = running.communicate(timeout=600)
            if running.returncode == -number and not said and not house.files() and not house.left():
                continue  # before `main`: a few tenths of a second of a busy machine
            wrong = house.judge(command, running.returncode, said, repeat=i == 0)
            if wrong:
                return f"signal after {(i + 0.5) / times:.2f} of its time: {wrong}"
        return ""
    return trial


def full_disk(size):
    """A real file system without room; for root only."""
    def trial(house, command):
        house.clear()
        place = house.work / "o"
        if subprocess.run(["mount", "-t", "tmpfs", "-o", size, "tmpfs", place], capture_output=True).returncode != 0:
            return None
        try:
            return house.judge(command, *house.run(command), repeat=False)
        finally:
            subprocess.run(["umount", place], check=True)
    return trial


def kills(house, command, times, seed):
    dice = random.Random(seed)
    wrong = []
    for i in range(times):
        if i % 5 == 0:
            house.clear()  # the others meet what a killed run left
        more = ["--force"] if command in REFUSE_EXISTING else []
        running = house.start(command, extra=more)
        time.sleep(dice.uniform(0.0, house.seconds[command]))
        running.kill()
        running.communicate()
        if i % 5 == 4 or i == times - 1:
            fault = house.again(command)
            if fault:
                wrong.append(f"kill {i + 1}: {fault}")
    return "; ".join(wrong)


def faults(long):
    counts = [1, 2, 5, 20] if long else [2]
    memory = resource.RLIMIT_AS
    table = {
        "ENOSPC": shim_fault("write", 28, counts),
        "ENOSPC, fsync": shim_fault("fsync", 28, counts),
        "EROFS": shim_fault("open", 30, [1]),
        "EMFILE": started(before=limit(resource.RLIMIT_NOFILE, 8)),
        "ENOMEM": started(before=limit(memory, 400_000_000)),
        "closed stdout": started(shell='exec "$@" >&-', codes=(0, 2), files=True),
        "full stdout": started(shell='exec "$@" >/dev/full', codes=(0, 2), files=True),
        "full stdout --json": started(shell='exec "$@" >/dev/full', codes=(2,), files=True, json=True),
        "both closed": started(shell='exec "$@" >&- 2>&-', codes=(0, 2), files=True, silent=True),
        "both full": started(shell='exec "$@" >/dev/full 2>&1', codes=(0, 2), files=True, silent=True),
        "a reader that left": started(shell='exec 3> >(true); wait $!; "$@" >&3', codes=(0,), files=True),
        "both readers left --json": started(shell='exec 3> >(true); wait $!; "$@" >&3 2>&3', codes=(0,), files=True, silent=True, json=True),
        "EFBIG": started(before=limit(resource.RLIMIT_FSIZE, 512)),
        "SIGTERM": stopped(signal.SIGTERM, 5 if long else 1),
    }
    if long:
        table.update({
            "EIO, fsync": shim_fault("fsync", 5, counts),
            "EMFILE, open": shim_fault("open", 24, counts),
            "ENOMEM, malloc": shim_fault("malloc", 12, counts),
            "no process (EAGAIN)": shim_fault("spawn", 11, [1]),
            "full disk": full_disk("size=40k"),
            "read-only disk": full_disk("ro"),
            "SIGINT": stopped(signal.SIGINT, 5),
        })
    return table


def report(house):
    """An internal error and a fatal signal leave a folder that repeats the command."""
    for fault, number in (("fsync:throw:1", None), ("fsync:stop:1", signal.SIGSEGV), ("fsync:stop:1", signal.SIGABRT)):
        house.clear()
        running = house.start("coupons", fault=fault)
        if number is not None:
            _, status = os.waitpid(running.pid, os.WUNTRACED)
            if not os.WIFSTOPPED(status):
                return f"{number}: ended before its first file: {running.stderr.read()}"
            running.send_signal(number)
            running.send_signal(signal.SIGCONT)
        _, said = running.communicate(timeout=100)
        folders = [p for p in house.work.iterdir() if p.name.startswith("fusee-crash-")]
        if running.returncode != 3 or len(folders) != 1 or str(folders[0]) not in said:
            return f"{fault or number}: exit code {running.returncode}, {folders}: {said}"
        place = folders[0]
        inputs = place / "inputs" / str(house.work / "fast.toml").lstrip("/")
        if not inputs.is_file() or inputs.read_bytes() != (house.work / "fast.toml").read_bytes():
            return f"{fault or number}: no copy of the profile: {[str(p) for p in place.rglob('*')]}"
        stack = (place / "stack.txt").read_text()
        if "fusee" not in stack or (number is None and ("logic_error" not in stack or "write_file" not in stack and "sync" not in stack)):
            return f"{fault or number}: stack:\n{stack}"
        again = subprocess.run(["sh", place / "reproduce.sh"], env=dict(os.environ, FUSEE=house.program), capture_output=True, text=True)
        if again.returncode != 0 or not list(place.rglob("groove_ladder.stl")):
            return f"{fault or number}: reproduce.sh ends with {again.returncode}: {again.stderr}"
        shutil.rmtree(place)
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program"), parser.add_argument("source"), parser.add_argument("shim")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--kills", type=int, default=None)
    parser.add_argument("--only", default="")
    parser.add_argument("--faults", default="")
    arguments = parser.parse_args()
    commands = arguments.only.split(",") if arguments.only else list(COMMANDS) if arguments.long else SHORT
    times = arguments.kills if arguments.kills is not None else (100 if arguments.long else 4)
    wrong, rows = [], []
    with tempfile.TemporaryDirectory() as folder:
        house = House(arguments.program, arguments.source, arguments.shim, pathlib.Path(folder))
        table = {name: trial for name, trial in faults(arguments.long).items()
                 if not arguments.faults or name in arguments.faults.split(",")}
        print("| command | " + " | ".join(table) + " | kill -9 |\n|" + "---|" * (len(table) + 2), flush=True)
        for command in commands:
            fault = house.undisturbed(command)
            if fault:
                wrong.append(f"{command}: {fault}")
                continue
            cells = []
            for name, trial in table.items():
                result = trial(house, command)
                cells.append("-" if result is None else "right" if not result else "**wrong**")
                if result:
                    wrong.append(f"{command}: {name}: {result}")
            if command not in READS_ONLY and times > 0:
                result = kills(house, command, times, 1)
                cells.append(f"{times} right" if not result else "**wrong**")
                if result:
                    wrong.append(f"{command}: kill -9: {result}")
            else:
                cells.append("")
            print(f"| `{command}` | " + " | ".join(cells) + " |", flush=True)
        if "coupons" in commands and not arguments.faults:
            result = report(house)
            print(f"crash reports: {'right' if not result else 'wrong'}")
            if result:
                wrong.append(f"crash report: {result}")
    for line in wrong:
        print(f"WRONG: {line}", file=sys.stderr)
    return 1 if wrong else 0


sys.exit(main())
