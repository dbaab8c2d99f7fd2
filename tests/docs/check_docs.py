#!/usr/bin/env python3
"""What the documents name exists: links with their headings, files, functions and classes, tests. Every page of docs/ is in its contents,
docs/README.md, and every note in docs/notes/README.md. Pages for users link to no note. Contracts and pages that code names exist.

    check_docs.py REPOSITORY UPSTREAM BUILD    prints each fault with its document, and exits with 1 if there is one
    check_docs.py --self-test                  shows that faults are found

REPOSITORY: its root; UPSTREAM: upstream's unpacked sources; BUILD: the build folder, whose tests are asked for. Notes have a date: only
their links are checked, since code that they name may have changed since.
"""
import json
import pathlib
import re
import subprocess
import sys

from check_samples import pages_of_users

CODE = {".c", ".cc", ".cmake", ".cpp", ".h", ".hpp", ".in", ".json", ".map", ".py", ".sdf", ".sh", ".txt", ""}
FOLDERS = ("ode", "ode_mt", "include", "tests", "bench", "worlds", "docs", "examples", ".ci")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
QUOTED = re.compile(r"`([^`\n]+)`")
IDENTIFIER = re.compile(r"\b(?:dx|d(?=[A-Z])|ODE_MT_)\w{3,}\b(?![*-]|\.\.\.)")  # not `dGeom...`, which stands for many
PATH = re.compile(r"(?<![\w/.~$-])(?:ode|ode_mt|tests|bench|worlds|docs|include)/[\w./-]*\w")
TEST = re.compile(r"(?:[A-Z]\w+/)?[A-Z]\w*[a-z]\w*\.[A-Z]\w*[a-z]\w*")
FENCE = re.compile(r"^```.*?^```$", re.DOTALL | re.MULTILINE)
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
PAGE = re.compile(r"(?<![\w/.])docs/[\w/-]+\.md\b")
CONTRACT = re.compile(r"\b[Cc]ontract ([CF]\d+)\b")


def text_of(folder, suffixes):
    files = (path for path in folder.rglob("*") if path.suffix in suffixes and path.is_file())
    return "\n".join(path.read_text(errors="ignore") for path in files)


def anchor_of(heading):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors_of(text):
    """Returns the anchors of a page. Comments in fences begin like headings and are none."""
    return {anchor_of(heading) for heading in HEADING.findall(FENCE.sub("", text))}


def missing_links(document, text):
    for target, anchor in LINK.findall(text):
        if re.match(r"\w+:", target):
            continue
        path = document.parent / target if target else document
        if not path.exists():
            yield target
        elif anchor and path.suffix == ".md" and anchor not in anchors_of(path.read_text()):
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


def missing_pages(code, root):
    """Yields pages that code names and docs/ lacks."""
    return sorted({page for page in PAGE.findall(code) if not (root / page).exists()})


def links_of(text):
    return {target for target, _ in LINK.findall(text)}


def pages_without_contents(docs):
    """Yields each list of pages with a page that it lacks."""
    for contents, pages in ((docs / "README.md", docs.glob("*.md")), (docs / "notes" / "README.md", (docs / "notes").glob("*.md"))):
        linked = links_of(contents.read_text()) if contents.is_file() else set()
        for page in sorted({page.name for page in pages} - linked - {"README.md"}):
            yield contents, page


def links_to_notes(docs):
    """Yields each page for users with its link to a note."""
    for page in sorted(filter(pathlib.Path.is_file, pages_of_users(docs.parent))):
        for target in sorted(links_of(page.read_text())):
            if docs / "notes" in (page.parent / target).resolve().parents:
                yield page, target


def undefined_contracts(code, page):
    """Returns the contracts that code names and that have no heading on the page."""
    return sorted(set(CONTRACT.findall(code)) - {heading.split(":")[0] for heading in HEADING.findall(page)})


def cases_of(listed):
    """Returns the names of the cases that a GoogleTest program lists."""
    cases, suite = set(), ""
    for line in listed.splitlines():
        name = line.split("#")[0].rstrip()
        if name.startswith("  "):
            cases.add(suite + name.strip())
        else:
            suite = name
    return cases


def main(root, upstream, build):
    folders = [root / name for name in FOLDERS]
    code = "".join(text_of(folder, CODE) for folder in folders) + text_of(upstream, {".c", ".cpp", ".h"})
    words = set(re.findall(r"\w+", code))
    documents = [*root.glob("*.md"), *(path for folder in folders for path in folder.rglob("*.md") if upstream not in path.parents)]
    listed = subprocess.check_output(["ctest", "--test-dir", build, "--show-only=json-v1"], text=True)
    tests = {re.sub(r"^[a-z_]+\.(?=[A-Z])", "", test["name"]) for test in json.loads(listed)["tests"]}
    for suites in pathlib.Path(build).rglob("*_suites.txt"):  # tests/suites.cmake
        tests |= cases_of(suites.read_text())
    tests |= {re.sub(r"/[^/]*$", "", name) for name in tests}  # without its parameter
    tests |= {re.sub(r"^\w+/", "", name) for name in tests}  # nor the name of the set of parameters
    failures = 0
    for contents, page in pages_without_contents(root / "docs"):
        print(f"{contents.relative_to(root)}: the contents lack {page}")
        failures += 1
    for page, note in links_to_notes(root / "docs"):
        print(f"{page.relative_to(root)}: a page for users links to the note {note}")
        failures += 1
    for contract in undefined_contracts(code, (root / "docs" / "contracts.md").read_text()):
        print(f"docs/contracts.md: code names the contract {contract}, which is not defined")
        failures += 1
    for page in missing_pages(code, root):
        print(f"{page}: code names it (git grep), and it does not exist")
        failures += 1
    for document in documents:
        text = document.read_text()
        has_date = root / "docs" / "notes" in document.parents
        names = () if has_date else missing_names(text, (root, upstream), words, tests)
        for name in sorted({*missing_links(document, text), *names}):
            print(f"{document.relative_to(root)}: there is no {name}")
            failures += 1
    return 1 if failures else 0


def self_test():
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        docs = pathlib.Path(folder).resolve() / "docs"
        (docs / "notes").mkdir(parents=True)
        contents = "# Contents\n\n## User\n\n[one](one.md)\n\n## Developer\n\n[two](two.md) [notes](notes/README.md)\n"
        files = {
            "README.md": contents,
            "one.md": "# One\n\n## A heading, of `code`\n\n```sh\n# a comment\n```\n",
            "two.md": "# Two\n",
            "notes/README.md": "[old](2026-11-old.md)\n",
            "notes/2026-11-old.md": "# Old\n",
        }

        def write(**changed):
            for name, text in {**files, **{name.replace("__", "/") + ".md": text for name, text in changed.items()}}.items():
                (docs / name).write_text(text)

        def missing(text):
            return list(missing_links(docs / "two.md", text))

        write()
        assert missing("[x](one.md) [x](one.md#a-heading-of-code) [x](https://example.org/#nothing) [x](#two)") == []
        assert missing("[x](three.md)") == ["three.md"]
        assert missing("[x](one.md#nothing)") == ["one.md#nothing"]
        assert missing("[x](one.md#a-comment)") == ["one.md#a-comment"]
        assert missing("[x](#nothing)") == ["#nothing"]
        assert missing_pages("// {0}/one.md, {0}/four.md; build/{0}/five.md".format("docs"), docs.parent) == ["docs" "/four.md"]
        assert list(pages_without_contents(docs)) == [] and list(links_to_notes(docs)) == []
        write(README=contents.replace("two.md", "one.md"))
        assert [page for _, page in pages_without_contents(docs)] == ["two.md"]
        write(notes__README="")
        assert [page for _, page in pages_without_contents(docs)] == ["2026-11-old.md"]
        write(two="[x](notes/2026-11-old.md)\n")
        assert list(links_to_notes(docs)) == []
        write(one="[x](notes/2026-11-old.md)\n")
        assert list(links_to_notes(docs)) == [(docs / "one.md", "notes/2026-11-old.md")]
        assert list(missing_names("`dNoSuchThing` `tests/no_such.md` `Some.TestThatIsNot`", [docs.parent], {"word"}, set())) == \
            ["dNoSuchThing", "tests/no_such.md", "Some.TestThatIsNot"]
        assert undefined_contracts("// (contract C1) Contract " + "F9:", "# Contracts\n\n### C1: one\n") == ["F9"]
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main(*map(pathlib.Path, sys.argv[1:])))
