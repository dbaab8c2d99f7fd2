#!/usr/bin/env python3
"""Each source file of ode_mt/ has a test of its name, or a test whose opening comment says that it covers the file.

    check_tests.py REPOSITORY    its root; prints each file without a test, and each name that is out of date
    check_tests.py --self-test   shows that such files and names are found

The test of dxFooBar.cpp is foo_bar_test.cpp, in any folder of tests/. Any other file of tests/ may say at the end of its opening comment

    // Covers dxFooBar.cpp, api/common.cpp.

with names of files, or with the last parts of their paths.
"""
import pathlib
import re
import tempfile

from checks import run_check, unexpected

OPENING = re.compile(r"\A(?:#!.*\n)?((?:(?://|#(?!\S)).*\n)+)")
COVERS = re.compile(r"^(?://|#) Covers ((?:.|\n)*)", re.MULTILINE)
NAME = re.compile(r"[\w/]+\.cpp\b")
SUFFIXES = {".cpp", ".sh"}


def key_of(name):
    """What the names of a file and of its test have in common."""
    return re.sub(r"^dx(?=[A-Z])", "", name).replace("_", "").lower()


def covered_by(test):
    """The names that the opening comment of a file of tests/ gives."""
    opening = OPENING.match(test.read_text())
    covers = COVERS.search(opening[1]) if opening else None
    return NAME.findall(covers[1]) if covers else []


def complaints_of(root):
    root = pathlib.Path(root)
    tests = sorted(path for path in (root / "tests").rglob("*") if path.suffix in SUFFIXES)
    of_a_test = {key_of(path.stem[:-len("_test")]) for path in tests if path.name.endswith("_test.cpp")}
    files = sorted(path.relative_to(root) for path in (root / "ode_mt").rglob("*.cpp"))
    covered = set()
    for test in tests:
        for name in covered_by(test):
            parts = pathlib.PurePath(name).parts
            named = [file for file in files if file.parts[-len(parts):] == parts]
            covered.update(named)
            where = f"{test.relative_to(root)} covers {name}"
            if len(named) != 1:
                yield f"{where}: {len(named)} files of ode_mt/ have this name"
    for file in files:
        if file not in covered and key_of(file.stem) not in of_a_test:
            yield f"{file}: no test has its name or says that it covers it"


def self_test():
    def complaints(files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for path, text in files.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            return list(complaints_of(root))

    file, test = "ode_mt/core/dxFooBar.cpp", "tests/core/all_test.cpp"
    covers = "// All of it.\n//\n// Covers dxFooBar.cpp.\n#include <x>\n"
    cases = {
        "a test of its name": ({file: "", "tests/core/foo_bar_test.cpp": ""}, []),
        "covered": ({file: "", test: covers}, []),
        "covered by a script": ({file: "", "tests/core/all.sh": "#!/bin/sh\n# Covers all of these: dxNo.hpp,\n# core/dxFooBar.cpp.\n"}, []),
        "neither": ({file: "", test: ""}, [f"{file}: no test has its name or says that it covers it"]),
        "named below the opening comment": ({file: "", test: "#include <x>\n" + covers}, [f"{file}: no test has its name or says that it covers it"]),
        "both": ({file: "", test: covers, "tests/core/foo_bar_test.cpp": ""}, []),
        "a file that is gone": ({test: covers}, [f"{test} covers dxFooBar.cpp: 0 files of ode_mt/ have this name"]),
        "an ambiguous name": ({file: "", "ode_mt/api/dxFooBar.cpp": "", test: covers}, [f"{test} covers dxFooBar.cpp: 2 files of ode_mt/ have this name"]),
    }
    return unexpected(complaints, cases)


if __name__ == "__main__":
    run_check(complaints_of, self_test)
