#!/usr/bin/env python3
"""What the documents name is there: links with their headings, files, functions and classes, tests. And every page of docs/ is
in its contents, docs/README.md.

    check_docs.py REPOSITORY UPSTREAM BUILD

REPOSITORY: its root; UPSTREAM: upstream's unpacked sources; BUILD: the build folder, whose tests are asked for.
Prints each name that is missing, with its document, and each page that is not in the contents, and exits with 1.
"""
import json
import pathlib
import re
import subprocess
import sys

CODE = {".c", ".cc", ".cmake", ".cpp", ".h", ".hpp", ".in", ".json", ".map", ".py", ".sdf", ".sh", ".txt", ""}
FOLDERS = ("ode", "ode_mt", "include", "tests", "bench", "worlds", "docs", "examples", ".ci")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
QUOTED = re.compile(r"`([^`\n]+)`")
IDENTIFIER = re.compile(r"\b(?:dx|d(?=[A-Z])|ODE_MT_)\w{3,}\b(?![*-]|\.\.\.)")  # not `dGeom...`, which stands for many
PATH = re.compile(r"(?<![\w/.~$-])(?:ode|ode_mt|tests|bench|worlds|docs|include)/[\w./-]*\w")
TEST = re.compile(r"(?:[A-Z]\w+/)?[A-Z]\w*[a-z]\w*\.[A-Z]\w*[a-z]\w*")


def text_of(folder, suffixes):
    files = (path for path in folder.rglob("*") if path.suffix in suffixes and path.is_file())
    return "\n".join(path.read_text(errors="ignore") for path in files)


def anchor_of(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def missing_links(document, text):
    for target, anchor in LINK.findall(text):
        if re.match(r"\w+:", target):
            continue
        path = document.parent / target if target else document
        if not path.exists():
            yield target
        elif anchor and path.suffix == ".md":
            headings = re.findall(r"^#+ (.*)$", path.read_text(), flags=re.M)
            if anchor not in map(anchor_of, headings):
                yield f"{target}#{anchor}"


def missing_names(text, folders, words, tests):
    for name in IDENTIFIER.findall(text):
        if name not in words:
            yield name
    for quoted in QUOTED.findall(text):
        for path in PATH.findall(quoted):
            if not any((root / path).exists() or list(root.glob(path + ".*")) for root in folders):
                yield path
        test = re.sub(r"(\.\w+)/\w+$", r"\1", quoted)  # without the name of its parameter
        if TEST.fullmatch(test) and test not in tests:
            yield test


def pages_without_contents(docs):
    """Pages to which the contents have no link."""
    linked = {target for target, _ in LINK.findall((docs / "README.md").read_text())}
    return sorted({str(page.relative_to(docs)) for page in docs.rglob("*.md")} - linked - {"README.md"})


def main(root, upstream, build):
    folders = [root / name for name in FOLDERS]
    code = "".join(text_of(folder, CODE) for folder in folders) + text_of(upstream, {".c", ".cpp", ".h"})
    words = set(re.findall(r"\w+", code))
    documents = [*root.glob("*.md"), *(path for folder in folders for path in folder.rglob("*.md") if upstream not in path.parents)]
    listed = subprocess.check_output(["ctest", "--test-dir", build, "--show-only=json-v1"], text=True)
    tests = {re.sub(r"^[a-z_]+\.(?=[A-Z])", "", test["name"]) for test in json.loads(listed)["tests"]}
    tests |= {re.sub(r"/[^/]*$", "", name) for name in tests}  # without its parameter
    tests |= {re.sub(r"^\w+/", "", name) for name in tests}  # nor the name of the set of parameters
    failures = 0
    for page in pages_without_contents(root / "docs"):
        print(f"docs/README.md: the contents lack docs/{page}")
        failures += 1
    for document in documents:
        text = document.read_text()
        for name in sorted({*missing_links(document, text), *missing_names(text, (root, upstream), words, tests)}):
            print(f"{document.relative_to(root)}: there is no {name}")
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*map(pathlib.Path, sys.argv[1:])))
