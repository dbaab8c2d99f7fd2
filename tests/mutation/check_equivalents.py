#!/usr/bin/env python3
"""Each mutant that equivalent.jsonl calls equivalent is still one of a line that the sources have, and changes a text of that line.

    check_equivalents.py REPOSITORY

Prints the entries whose file or line is gone, and exits with 1 if there are any: what is said of them says nothing any more.
"""
import json
import pathlib
import sys


def gone(repository):
    for number, line in enumerate((pathlib.Path(__file__).parent / "equivalent.jsonl").read_text().splitlines(), 1):
        entry = json.loads(line)
        source = repository / entry["file"]
        lines = [text.strip() for text in source.read_text().splitlines()] if source.exists() else []
        if entry["code"] not in lines:
            yield f"equivalent.jsonl:{number}: {entry['file']} has no line '{entry['code']}'"
        elif entry["old"] not in entry["code"]:
            yield f"equivalent.jsonl:{number}: the line has no '{entry['old']}'"


def main(repository):
    missing = list(gone(pathlib.Path(repository)))
    print("\n".join(missing))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
