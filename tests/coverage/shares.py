#!/usr/bin/env python3
"""Shares of lines and branches that were run, of gcovr's summary, and the files with the most that were not.

    shares.py SUMMARY.json LEAST_LINES LEAST_BRANCHES

Exits with 1 if a share is below its threshold, in percent. Vector kernels are compiled once for each instruction set, and each
copy has branches of its own, of which a machine runs those that it can; so their branches are shown apart.
"""
import json
import sys

KERNELS = ("ode_mt/collision/broadphase/overlap/", "ode_mt/dynamics/world_step/kernels/", "ode_mt/dynamics/quick_step/sor/")
SHOWN = 15


def share(files, what):
    covered, total = (sum(file[f"{what}_{part}"] for file in files) for part in ("covered", "total"))
    return 100 * covered / total if total else 100.0, f"{covered} of {total}"


def main(summary, least_lines, least_branches):
    with open(summary) as text:
        files = json.load(text)["files"]
    kernels = [file for file in files if file["filename"].startswith(KERNELS)]
    others = [file for file in files if file not in kernels]
    rows = [("lines", files, "line", float(least_lines)), ("branches", others, "branch", float(least_branches)),
            ("branches of vector kernels", kernels, "branch", 0)]
    failed = False
    for name, of, what, least in rows:
        percent, counts = share(of, what)
        print(f"{name}: {percent:.1f} % ({counts})" + (f", less than {least} %" if percent < least else ""))
        failed |= percent < least
    for what, of in (("line", files), ("branch", others)):
        def missing(file):
            return file[f"{what}_total"] - file[f"{what}_covered"]
        print(f"most that was not run, by {what}:")
        for file in sorted(of, key=missing, reverse=True)[:SHOWN]:
            print(f"  {missing(file):4} of {file[what + '_total']:4} {file['filename']}")
    return failed


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
