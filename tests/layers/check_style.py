#!/usr/bin/env python3
"""Style that holds for every file of the repository: length of lines, blanks, and sorted lists of source files.

    check_style.py REPOSITORY    its root; prints each place that breaks a rule, with file and line
    check_style.py --self-test   shows that such places are found

Lines of C++, CMake and prose have 150 characters at most. A row of a Markdown table and a line without a blank to break it at may be longer, and so
may a command, in a script or on a page.
In CMakeLists.txt, source files that stand on lines of their own are sorted.
"""
import pathlib
import re
import subprocess
import tempfile

from checks import run_check, unexpected

MAX_LENGTH = 150
CODE = (".h", ".cpp", ".c", ".cmake", ".toml")
SCRIPTS = (".py", ".sh", ".js", ".css")
PROSE = (".md",)
# Data, texts of others, and what a test writes.
LEFT_OUT = re.compile(r"^(LICENSE|docs/(figures|images|reference)/|worlds/elements\.md|worlds/(?!.*\.(h|cpp|md)$)|tests/.*/(golden|data|seeds)/|tests/kept_state/table/)")
SOURCE = re.compile(r"^\s+([\w./-]+\.(?:c|cpp))\)?\s*$")


def files_of(root):
    """The files that git follows or would follow; without git or a repository all but what is built and fetched."""
    try:
        listed = subprocess.run(["git", "-C", root, "ls-files", "--cached", "--others", "--exclude-standard"], check=True, capture_output=True, text=True)
        names = listed.stdout.splitlines()
    except (OSError, subprocess.CalledProcessError):
        names = [path.relative_to(root).as_posix() for path in pathlib.Path(root).rglob("*") if path.is_file()]
        names = [name for name in names if not name.startswith(("build/", "ode/upstream/"))]
    return sorted(name for name in names if (pathlib.Path(name).suffix in CODE + SCRIPTS + PROSE or name.endswith("CMakeLists.txt"))
                  and not LEFT_OUT.match(name) and pathlib.Path(root, name).is_file())


def is_breakable(line, name):
    """Whether a line that is too long should be broken: no table, no command of a script, and a blank after the first word."""
    if pathlib.Path(name).suffix in SCRIPTS:
        return False
    if pathlib.Path(name).suffix in PROSE and line.lstrip().startswith("|"):
        return False
    return " " in line.strip()[:MAX_LENGTH].lstrip("-*>#/ ")


def complaints_of_lines(name, lines):
    """Complaints about lines by themselves."""
    is_code = False  # of a page
    for number, line in enumerate(lines, 1):
        is_code ^= name.endswith(PROSE) and line.lstrip().startswith("```")
        if len(line) > MAX_LENGTH and not is_code and is_breakable(line, name):
            yield f"{name}:{number}: {len(line)} characters, {MAX_LENGTH} at most"
        if line != line.rstrip():
            yield f"{name}:{number}: blanks at the end"
        if "\t" in line and name.endswith((".h", ".cpp")):
            yield f"{name}:{number}: a tab"


def complaints_of_lists(name, lines):
    """Complaints about source files of a list of CMake that are not sorted."""
    previous = None
    for number, line in enumerate(lines, 1):
        match = SOURCE.match(line)
        source = match[1] if match else None
        if source and previous and source.lower() < previous.lower():
            yield f"{name}:{number}: {source} stands after {previous}"
        previous = source if not line.rstrip().endswith(")") else None


def complaints_of(root):
    for name in files_of(root):
        text = pathlib.Path(root, name).read_text(errors="replace")
        lines = text.split("\n")
        if text and lines[-1]:
            yield f"{name}: does not end in a new line"
        yield from complaints_of_lines(name, lines)
        if name.endswith("CMakeLists.txt"):
            yield from complaints_of_lists(name, lines)


def self_test():
    long_line = "// " + "word " * 40 + "end"
    cases = {
        "in order": ({"a/CMakeLists.txt": "add_library(a\n    b.cpp\n    c.cpp)\nadd_library(d\n    a.cpp)\n", "a/b.h": "int a;\n"}, []),
        "a long line": ({"a/b.h": long_line + "\n"}, [f"a/b.h:1: {len(long_line)} characters, {MAX_LENGTH} at most"]),
        "a long row of a table, a long address": ({"a.md": "| " + long_line + " |\n" + "x" * 200 + "\n"}, []),
        "a long command on a page": ({"a.md": "```sh\n" + long_line + "\n```\n"}, []),
        "long prose": ({"a.md": long_line + "\n"}, [f"a.md:1: {len(long_line)} characters, {MAX_LENGTH} at most"]),
        "blanks and tabs": ({"a.cpp": "int a; \n\tint b;\n"}, ["a.cpp:1: blanks at the end", "a.cpp:2: a tab"]),
        "no end": ({"a.cpp": "int a;"}, ["a.cpp: does not end in a new line"]),
        "a list out of order": ({"CMakeLists.txt": "add_library(a\n    c.cpp\n    b.cpp)\n"}, ["CMakeLists.txt:3: b.cpp stands after c.cpp"]),
    }

    def found_in(files):
        with tempfile.TemporaryDirectory() as folder:
            for path, text in files.items():
                file = pathlib.Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return list(complaints_of(folder))

    return unexpected(found_in, cases)


if __name__ == "__main__":
    run_check(complaints_of, self_test)
