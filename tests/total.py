#!/usr/bin/env python3
"""total.py JUNIT: what ctest --output-junit wrote as one line (numbers, time), one line for each skipped test, with its reason, and one for the ten
slowest tests."""
import re
import sys
import xml.etree.ElementTree as tree


def reason(case):
    """Why a script (SKIP: ...) or googletest (FILE:LINE: Skipped, then the reason) skipped it; "" for none that is known."""
    text = case.findtext("system-out") or ""
    found = re.search(r"SKIP: *(.+)|: Skipped\n+(.+)", text)
    return next((group for group in found.groups() if group), "") if found else ""


def main():
    suite = tree.parse(sys.argv[1]).getroot()
    cases = suite.findall("testcase")
    failed = [case for case in cases if case.get("status") == "fail"]
    skipped = [case for case in cases if case.find("skipped") is not None]
    print(f"{len(cases)} tests in {float(suite.get('time', 0)):.0f} s: {len(cases) - len(failed) - len(skipped)} passed, {len(failed)} failed, "
          f"{len(skipped)} skipped")
    for case in skipped:
        print(f"  skipped {case.get('name')}: {reason(case) or 'it does not say why'}")
    slowest = sorted(cases, key=lambda case: -float(case.get("time", 0)))[:10]
    print("  slowest: " + ", ".join(f"{case.get('name')} {float(case.get('time', 0)):.1f} s" for case in slowest))


main()
