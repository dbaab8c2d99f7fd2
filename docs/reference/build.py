#!/usr/bin/env python3
"""Builds the reference: pages of ode_MT.h and of upstream's functions, with a tag file for links to them.

    build.py --headers FOLDER --output FOLDER [--doxygen PROGRAM]

Doxygen reads the groups of this folder, ode_MT.h, and upstream's declarations without their comments, each in its group. In comments, names
of functions become links, as do documents (docs/limits.md). A public function of upstream that is in no group or in several, a function of
ode_MT.h without a description of each parameter and of its result, and anything else that Doxygen warns of are errors.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

from upstream_functions import complaints, declarations_of, groups_of, of_some_releases

HERE = pathlib.Path(__file__).resolve().parent
COMMENT = re.compile(r"/\*\*.*?\*/", re.DOTALL)
DOCUMENT = re.compile(r"\bdocs/([\w-]+)\.md\b(#[\w-]+)?")
NAME = re.compile(r"(?<![\w#@`:\"])(d[A-Z]\w+)\b(?!\.\.\.|\([^)])")  # not dGeom..., which stands for many, and not the text of a call


def linked(text, names):
    """The text with links in its comments."""

    def comment(match):
        inside = DOCUMENT.sub(r"[docs/\1.md](../docs/\1.html\2)", match[0])
        return NAME.sub(lambda name: ("#" if name[1] in names else "") + name[1], inside)

    return COMMENT.sub(comment, text)


def write_input(headers, output):
    """Returns the number of faults, which it prints."""
    declarations = declarations_of(headers)
    groups = groups_of(HERE / "upstream")
    faults = list(complaints(declarations, groups, of_some_releases(HERE.parents[1] / "ode" / "releases")))
    print(*faults, sep="\n", end="\n" if faults else "", file=sys.stderr)
    own = (headers / "ode_MT.h").read_text()
    names = set(declarations) | set(re.findall(r"ODE_API[^;(]*?\b(d[A-Z]\w*)\(", own))
    (output / "ode_MT.h").write_text(linked(own, names))
    for path in HERE.rglob("*.dox"):
        (output / path.name).write_text(linked(path.read_text(), names))
    (output / "upstream.h").write_text("".join(
        f"/** @addtogroup {group}\n@{{ */\n" + "\n".join(declarations[name] for name in listed if name in declarations) + "\n/** @} */\n"
        for group, listed in groups.items()))
    return len(faults)


def run_doxygen(doxygen, configuration, output, **places):
    text = (HERE / f"{configuration}.in").read_text()
    for name, place in places.items():
        text = text.replace(f"@{name}@", str(place))
    (output / configuration).write_text(text)
    return subprocess.run([doxygen, output / configuration]).returncode


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--headers", type=pathlib.Path, required=True)
    arguments.add_argument("--output", type=pathlib.Path, required=True)
    arguments.add_argument("--doxygen", default="doxygen")
    given = arguments.parse_args()
    shutil.rmtree(given.output, ignore_errors=True)
    (given.output / "input").mkdir(parents=True)
    faults = write_input(given.headers, given.output / "input")
    faults += run_doxygen(given.doxygen, "Doxyfile", given.output, INPUT=given.output / "input", OUTPUT=given.output, HERE=HERE) != 0
    faults += run_doxygen(given.doxygen, "Strict", given.output, DOXYFILE=given.output / "Doxyfile", HEADERS=given.headers) != 0
    print(f"{given.output / 'html' / 'index.html'}" if not faults else "the reference has faults", file=sys.stderr if faults else sys.stdout)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
