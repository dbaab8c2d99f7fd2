#!/usr/bin/env python3
"""Pages use the field's words: a picture of our own in the place of a word that the field has is a fault.

    check_words.py REPOSITORY     prints each such word of docs/*.md, README.md and CONTRIBUTING.md, and exits with 1 if there is one
    check_words.py --self-test    shows that they are found

The list has words that mean nothing else on these pages. docs/glossary.md defines the words to use. Code is not looked at.
"""
import pathlib
import re
import sys

INSTEAD = {
    r"asks? the memory for": "prefetch",
    r"body cut": "partition",
    r"by vectors": "vectorised, with SIMD",
    r"contacts ahead": "narrow-phase prefetch",
    r"courtesy": "worker, chunk",
    r"inside out": "min > max",
    r"lines? of the cache": "cache line",
    r"likewise": "the condition itself",
    r"nearest cache": "L1",
    r"no(?:body| ?one) can foresee": "unpredictable",
    r"nursery": "arena, pool",
    r"of home's": "of the coordinator",
    r"rows? of L begins? late": "skyline storage",
    r"shall": "should, must",
    r"shared bod(?:y|ies)": "boundary body",
    r"summons?": "start workers",
    r"third cache": "L3",
    r"trials? in vain": "probe",
    r"wrong guess(?:es)?": "misprediction",
}
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->", re.DOTALL | re.MULTILINE)


def faults_of(text):
    """Yields the number of a line, the word and what to say instead."""
    plain = re.sub("[ \t]+", " ", CODE.sub(lambda code: "\n" * code[0].count("\n"), text))
    for pattern, instead in INSTEAD.items():
        for found in re.finditer(rf"\b{pattern}\b", plain, re.IGNORECASE):
            yield plain.count("\n", 0, found.start()) + 1, found[0], instead


def main(root):
    failures = 0
    for page in [*sorted((root / "docs").glob("*.md")), root / "README.md", root / "CONTRIBUTING.md"]:
        for line, word, instead in sorted(faults_of(page.read_text())):
            print(f"{page.relative_to(root)}:{line}: '{word}': say {instead}")
            failures += 1
    return 1 if failures else 0


def self_test():
    def words(text):
        return [(line, word) for line, word, _ in faults_of(text)]

    assert words("Plain words.\nMarshall, a wall.") == []
    assert words("It works.\nBounds are inside  out.") == [(2, "inside out")]
    assert words("It Shall be.") == [(1, "Shall")]
    assert words("`inside out` and\n```\nshall\n```\nthe nearest cache") == [(5, "nearest cache")]
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main(pathlib.Path(sys.argv[1])))
