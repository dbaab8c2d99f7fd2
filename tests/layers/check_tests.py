#!/usr/bin/env python3
"""Each source file of ode_mt/ has a test of its name, or a line in tests/README.md that says which test covers it.

    check_tests.py REPOSITORY    its root; prints each file without a test, and each line that is out of date
    check_tests.py --self-test   shows that such files and lines are found

The test of dxFooBar.cpp is foo_bar_test.cpp, in any folder of tests/. A line of the table is

    | `room/dxFooBar.cpp` | `folder/file_test.cpp`, `folder/another.cpp` |

with a file of ode_mt/, and the files of tests/ that cover it.
"""
import pathlib
import re
import tempfile

from checks import run_check, unexpected

LINE = re.compile(r"^\| `([\w/]+\.cpp)` \| (.*) \|$", re.MULTILINE)
QUOTED = re.compile(r"`([^`]+)`")


def key_of(name):
    """What the names of a file and of its test have in common."""
    return re.sub(r"^dx(?=[A-Z])", "", name).replace("_", "").lower()


def complaints_of(root):
    root = pathlib.Path(root)
    tests = {key_of(path.stem[:-len("_test")]) for path in (root / "tests").rglob("*_test.cpp")}
    files = {path.relative_to(root / "ode_mt").as_posix(): key_of(path.stem) in tests for path in (root / "ode_mt").rglob("*.cpp")}
    lines = LINE.findall((root / "tests" / "README.md").read_text())
    listed = [file for file, _ in lines]
    for file in sorted(files):
        if not files[file] and file not in listed:
            yield f"ode_mt/{file}: no test has its name, and tests/README.md does not say which one covers it"
    for file, covering in lines:
        if file not in files:
            yield f"tests/README.md: there is no ode_mt/{file}"
        elif files[file]:
            yield f"tests/README.md: ode_mt/{file} needs no line, as a test has its name"
        if listed.count(file) > 1:
            yield f"tests/README.md: ode_mt/{file} has two lines"
        quoted = QUOTED.findall(covering)
        if not quoted:
            yield f"tests/README.md: the line of ode_mt/{file} names no test"
        for test in quoted:
            if not (root / "tests" / test).is_file():
                yield f"tests/README.md: there is no tests/{test}, which covers ode_mt/{file}"


def self_test():
    def complaints(files, table):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for path in (*files, "tests/README.md"):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).touch()
            (root / "ode_mt").mkdir(exist_ok=True)
            (root / "tests" / "README.md").write_text("# Tests\n\n" + "".join(f"| `{file}` | {test} |\n" for file, test in table))
            return list(complaints_of(root))

    file, covering = "ode_mt/core/dxFooBar.cpp", "tests/core/all_test.cpp"
    line = ("core/dxFooBar.cpp", "`core/all_test.cpp`")
    cases = {
        "a test of its name": (([file, "tests/core/foo_bar_test.cpp"], []), []),
        "a line": (([file, covering], [line]), []),
        "neither": (([file, covering], []), [f"{file}: no test has its name, and tests/README.md does not say which one covers it"]),
        "both": (([file, covering, "tests/core/foo_bar_test.cpp"], [line]),
                 [f"tests/README.md: {file} needs no line, as a test has its name"]),
        "a file that is gone": (([covering], [line]), [f"tests/README.md: there is no {file}"]),
        "a test that is gone": (([file], [line]), [f"tests/README.md: there is no {covering}, which covers {file}"]),
        "a line without a test": (([file], [(line[0], "all of them")]), [f"tests/README.md: the line of {file} names no test"]),
        "two lines": (([file, covering], [line, line]), [f"tests/README.md: {file} has two lines"] * 2),
    }
    return unexpected(lambda given: complaints(*given), cases)


if __name__ == "__main__":
    run_check(complaints_of, self_test)
