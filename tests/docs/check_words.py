#!/usr/bin/env python3
"""Pages and comments use the field's words: a picture of our own in the place of a word that the field has is a fault.

    check_words.py REPOSITORY     prints each such word of the pages and of the comments of sources, and exits with 1 if there is one
    check_words.py --self-test    shows that they are found

The list has words that mean nothing else here. docs/glossary.md defines the words to use. Code on a page is not looked at.
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
    r"in vain": "without a result, a probe",
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
    r"so (?:many|much)(?!(?: \S+){0,9}? that\b)": "the name of the number",
    r"summons?": "start workers",
    r"third cache": "L3",
    r"wrong guess(?:es)?": "misprediction",
}
PAGES = ("README.md", "CONTRIBUTING.md", "docs/*.md", "worlds/README.md", "tests/README.md")
SOURCES = ("ode/seams/*", *(f"{folder}/**/*.{kind}" for folder in ("include", "ode_mt", "bench", "worlds", "examples", "tests") for kind in ("c", "cpp", "h")))
COMMENT = re.compile(r"//|/[*]|^ *[*]")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`|\]\([^)]*\)|<!--.*?-->", re.DOTALL | re.MULTILINE)


def text_of_page(text):
    return CODE.sub(lambda code: "\n" * code[0].count("\n"), text)


def text_of_source(text):
    """The comments, each line in its place."""
    return "\n".join("".join(COMMENT.split(line, maxsplit=1)[1:]) for line in text.split("\n"))


def faults_of(plain):
    """Yields the number of a line, the word and what to say instead."""
    words = re.sub(r"[ \t]+", " ", plain)
    for pattern, instead in INSTEAD.items():
        for found in re.finditer(rf"\b{pattern}".replace(" ", r"\s+") + r"\b", words, re.IGNORECASE):
            yield words.count("\n", 0, found.start()) + 1, " ".join(found[0].split()), instead


def main(root):
    failures = 0
    for patterns, text_of in ((PAGES, text_of_page), (SOURCES, text_of_source)):
        for path in sorted(path for pattern in patterns for path in root.glob(pattern)):
            for line, word, instead in sorted(faults_of(text_of(path.read_text()))):
                print(f"{path.relative_to(root)}:{line}: '{word}': say {instead}")
                failures += 1
    return 1 if failures else 0


def self_test():
    def words(text, text_of=text_of_page):
        return sorted((line, word) for line, word, _ in faults_of(text_of(text)))

    assert words("Plain words.\nMarshall, a wall.") == []
    assert words("It works.\nBounds are inside  out.") == [(2, "inside out")]
    assert words("It Shall be.") == [(1, "Shall")]
    assert words("`inside out` and\n```\nshall\n```\nthe nearest cache") == [(5, "nearest cache")]
    assert words("So many words\nthat all agree, and so many others.") == [(2, "so many")]
    assert words("int shall;  // a wrong\n    // guess\n/* It\n * shall. */", text_of_source) == [(1, "wrong guess"), (4, "shall")]
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main(pathlib.Path(sys.argv[1])))
