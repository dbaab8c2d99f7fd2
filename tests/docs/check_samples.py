#!/usr/bin/env python3
"""Code on a page is the text of a file that is compiled and run: the two are compared.

    check_samples.py REPOSITORY [--write]    prints each difference, or with --write takes the text of the files
    check_samples.py --self-test             shows that differences are found

A fence follows a line that says what it is:

    <!-- sample: tests/docs/samples/first_world.c world -->     the lines of the file between two comments [world]
    <!-- no sample: REASON -->                                  who runs it, or why nobody does

On pages of the first part of docs/README.md, in README.md and wherever the language is C, C++ or CMake each fence has such a line.
"""
import pathlib
import re
import sys
import textwrap

FENCE = re.compile(r"(?P<line>[^\n]*)\n(?P<fence>```(?P<language>\w+)\n)(?P<code>.*?)(?=^```$)", re.DOTALL | re.MULTILINE)
SAMPLE = re.compile(r"<!-- sample: (\S+) (\w+) -->")
REASON = re.compile(r"<!-- no sample: \S.* -->")
EVERYWHERE = {"c", "cpp", "cmake"}
OF_USERS = EVERYWHERE | {"sh", "python"}


def section_of(text, name):
    """The lines between the two comments with the name, as far to the left as they can be; None if there are not two."""
    parts = re.split(rf"^[ \t]*(?://|#|/\*) \[{name}\](?: \*/)?\n", text, flags=re.MULTILINE)
    return textwrap.dedent(parts[1]) if len(parts) == 3 else None


def pages_of_users(root):
    contents = (root / "docs" / "README.md").read_text().split("\n## ")
    return {root / "README.md"} | {root / "docs" / page for page in re.findall(r"\]\(([\w-]+\.md)", contents[1] if len(contents) > 1 else "")}


def compared(root, page, languages):
    """The page with the text of the files, and what is wrong, a sentence each."""
    faults = []

    def replace(match):
        sample, place = SAMPLE.fullmatch(match["line"].strip()), page.relative_to(root)
        if match["language"] not in languages or REASON.fullmatch(match["line"].strip()):
            return match[0]
        first = match["code"].splitlines()[0] if match["code"] else ""
        if not sample:
            faults.append(f"{place}: nothing says which file is compiled and run for: {first}")
            return match[0]
        file = root / sample[1]
        text = section_of(file.read_text(), sample[2]) if file.is_file() else None
        if text is None:
            faults.append(f"{place}: there is no {sample[1]} with a section {sample[2]}")
            return match[0]
        if text != match["code"]:
            faults.append(f"{place}: is not what {sample[1]} has in its section {sample[2]}: {first}")
        return f"{match['line']}\n{match['fence']}{text}"

    text = FENCE.sub(replace, page.read_text())
    return text, faults


def main(root, write):
    users, faults = pages_of_users(root), []
    for page in sorted({*root.glob("*.md"), *(root / "docs").rglob("*.md")}):
        text, found = compared(root, page, OF_USERS if page in users else EVERYWHERE)
        if write:
            page.write_text(text)
        faults += found
    print(*faults, sep="\n", end="\n" if faults else "")
    return 1 if faults else 0


def self_test():
    import tempfile

    file = "int before;\n    /* [one] */\n    int x;\n      int y;\n    /* [one] */\n"
    right = "<!-- sample: a.c one -->\n```c\nint x;\n  int y;\n```\n"
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "a.c").write_text(file)

        def faults(text, languages=frozenset(OF_USERS)):
            (root / "page.md").write_text(text)
            return len(compared(root, root / "page.md", languages)[1])

        assert faults(right) == 0
        assert faults(right.replace("x", "z")) == 1
        assert faults(right.replace("one", "two")) == 1
        assert faults(right.replace("a.c", "b.c")) == 1
        assert faults("text\n```c\nint x;\n```\n") == 1
        assert faults("text\n```sh\nls\n```\n") == 1
        assert faults("text\n```sh\nls\n```\n", EVERYWHERE) == 0
        assert faults("<!-- no sample: a fragment -->\n```c\nint x;\n```\n") == 0
        assert compared(root, root / "page.md", OF_USERS)[0] == (root / "page.md").read_text()
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1] == "--self-test" else main(pathlib.Path(sys.argv[1]), "--write" in sys.argv))
