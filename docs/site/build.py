#!/usr/bin/env python3
"""Builds the site: the documents of the repository as pages that a browser opens from the disk, with the reference of functions.

    build.py --repository FOLDER --reference FOLDER --tables FOLDER --output FOLDER [--mkdocs PROGRAM]

Pages are README.md and whatever is linked from it, and so on; source files that a document links become pages, too. The navigation is that of
docs/README.md. FOLDER of the reference is what docs/reference/build.py wrote; that of tables has pages that the build generates, or does not exist. MkDocs warns of nothing, and every link leads somewhere, or it
is an error.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from links import faults_of

HERE = pathlib.Path(__file__).resolve().parent
LINK = re.compile(r"(\]\(|src=\")([^)#\s:\"]+)((?:#[^)\s]*)?[)\"])")
ROW = re.compile(r"^\| \**\[([^\]]+)\]\(([^)#]+)\)", re.MULTILINE)
CODE_IN_ROW = re.compile(r"^\|.*\|$", re.MULTILINE), re.compile(r"`[^`\n]+`")
PICTURES = {".svg", ".png"}
FENCES = {".cpp": "cpp", ".h": "cpp", ".c": "c", ".cmake": "cmake", ".py": "python", ".sh": "sh"}


def for_mkdocs(text):
    """The text without the backslash that hosts of code want before a bar of code in a table, and MkDocs would show."""
    rows, code = CODE_IN_ROW
    return rows.sub(lambda row: code.sub(lambda span: span[0].replace("\\|", "|"), row[0]), text)


class Pages:
    """Copies documents and what they link to, each to the same place below `target`."""

    def __init__(self, repository, target):
        self.repository, self.target, self.done = repository, target, set()

    def add(self, path):
        """Returns how links name the page of a file or folder of the repository: its name and what is appended."""
        if (path / "README.md").exists():
            self.add(path / "README.md")
            return "/README.md"
        appended = "" if path.suffix in {".md", *PICTURES} else "/index.md" if path.is_dir() else ".md"
        if path in self.done or self.repository not in path.parents:
            return appended
        self.done.add(path)
        page = self.target / (str(path.relative_to(self.repository)) + appended)
        page.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix in PICTURES:
            shutil.copy(path, page)
        elif path.suffix == ".md":
            page.write_text(for_mkdocs(LINK.sub(lambda link: self.followed(path, link), path.read_text())))
        elif path.is_dir():
            page.write_text(f"# {path.name}/\n\nFiles of this folder:\n\n" + "".join(f"* `{file.name}`\n" for file in sorted(path.iterdir())))
        else:
            page.write_text(f"# {path.name}\n\n```` {FENCES.get(path.suffix, 'text')}\n{path.read_text()}\n````\n")
        return appended

    def followed(self, document, link):
        target = pathlib.Path(os.path.normpath(document.parent / link[2]))
        return link[1] + link[2] + (self.add(target) if target.exists() else "") + link[3]


def add_tables(folder, target):
    """Copies generated pages, and returns the section that lists them."""
    pages = sorted(folder.glob("*.md"))
    (target / "tables").mkdir(exist_ok=True)
    for page in pages:
        (target / "tables" / page.name).write_text(for_mkdocs(page.read_text()))
    return [{"Generated tables": [f"tables/{page.name}" for page in pages]}] if pages else []


def navigation(repository, tables):
    """Titles and pages in the order of docs/README.md: one section for each of its headings, then the generated tables."""
    contents = (repository / "docs" / "README.md").read_text()
    sections = [{"ODE_MT": "README.md"}]
    for heading, text in re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", contents, flags=re.MULTILINE | re.DOTALL):
        sections.append({heading: [{title: f"docs/{page}"} for title, page in ROW.findall(text)]})
    return [*sections, *tables, {"Working on ODE_MT": ["CONTRIBUTING.md", "tests/README.md", "worlds/README.md"]}, {"Contents": "docs/README.md"}]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--repository", type=pathlib.Path, required=True)
    arguments.add_argument("--reference", type=pathlib.Path, required=True)
    arguments.add_argument("--tables", type=pathlib.Path, required=True)
    arguments.add_argument("--output", type=pathlib.Path, required=True)
    arguments.add_argument("--mkdocs", default="mkdocs")
    given = arguments.parse_args()
    output, html = given.output, given.output / "html"
    shutil.rmtree(output, ignore_errors=True)
    Pages(given.repository, output / "pages").add(given.repository / "README.md")
    tables = add_tables(given.tables, output / "pages")
    shutil.copy(HERE / "site.css", output / "pages")
    shutil.copy(HERE / "hooks.py", output)
    configuration = (HERE / "mkdocs.yml.in").read_text() + f"nav: {json.dumps(navigation(given.repository, tables))}\n"
    (output / "mkdocs.yml").write_text(configuration)  # JSON is YAML
    environment = {**os.environ, "ODE_MT_REFERENCE_TAGS": str(given.reference / "ode.tag")}
    if subprocess.run([given.mkdocs, "build", "--strict", "--quiet", "--config-file", output / "mkdocs.yml"], env=environment).returncode:
        return 1
    shutil.copytree(given.reference / "html", html / "reference")
    faults = list(faults_of(html))
    print(*faults, sep="\n", end="\n" if faults else "", file=sys.stderr)
    print(html / "index.html" if not faults else f"{len(faults)} faults", file=sys.stderr if faults else sys.stdout)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
