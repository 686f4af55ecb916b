"""Long calls leave the interpreter to other threads, and Ctrl-C stops them."""

import os
import signal
import subprocess
import sys
import threading
import time

import fusee


def test_ctrl_c_stops(profiles):
    script = """
import fusee, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
def started(*_):
    print("started", flush=True)
try:
    fusee.design('profiles/pnrvsa.toml', population=64, generations=1_000_000, progress=started)
except KeyboardInterrupt:
    print("stopped", flush=True)
    sys.exit(7)
"""
    child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, env=os.environ)
    try:
        assert child.stdout.readline() == "started\n"
        begin = time.monotonic()
        child.send_signal(signal.SIGINT)
        rest, _ = child.communicate(timeout=60)
    finally:
        child.kill()
    assert child.returncode == 7 and rest.endswith("stopped\n")
    assert time.monotonic() - begin < 30


def test_other_threads_run_meanwhile(profiles):
    beats, ended = [], threading.Event()

    def beat():
        while not ended.wait(0.005):
            beats.append(time.monotonic())

    thread = threading.Thread(target=beat)
    thread.start()
    begin = time.monotonic()
    fusee.make(profiles / "pnrvsa.toml")
    end = time.monotonic()
    ended.set()
    thread.join()
    inside = [moment for moment in beats if begin < moment < end]
    assert len(inside) > 0.1 * (end - begin) / 0.005, "a call that keeps the lock would leave none"


def test_results_are_made_in_threads_too(profiles):
    found = []
    threads = [threading.Thread(target=lambda: found.append(fusee.simulate(profiles / "pnrvsa.toml", levels=3).exact_width.tolist())) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 3 and found[0] == found[1] == found[2]
