"""The functions that upstream's public headers declare, and the groups of this reference that list them.

A group is a file of upstream/: a comment that Doxygen reads, and after it a plain comment with the names of the group's functions:

    /* Functions: dWorldStep dWorldQuickStep */
"""
import pathlib
import re

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*", re.MULTILINE)
PREFIX = r"(?:ODE_API_DEPRECATED\s+)?(?:ODE_API|ODE_PURE_INLINE|ODE_INLINE)\b"
FUNCTION = re.compile(PREFIX + r"([^;{}()]*?)\b(d[A-Z]\w*)\s*\(((?:[^;{}()]|\([^()]*\))*)\)", re.DOTALL)
LISTED = re.compile(r"/\* Functions:(.*?)\*/", re.DOTALL)
GROUP = re.compile(r"@defgroup (\w+)")
OF_CPLUSPLUS = {"odecpp.h", "odecpp_collision.h"}  # classes of inline functions, which call those of the other headers


def declarations_in(header):
    """Pairs of a function's name and its declaration, without the comments of the header."""
    text = DIRECTIVE.sub("", COMMENT.sub(" ", header))
    for result, name, parameters in FUNCTION.findall(text):
        yield name, f"{' '.join(result.split())} {name}({' '.join(parameters.split())});"


def declarations_of(folder):
    """Declarations by the functions' names."""
    declarations = {}
    for path in sorted(pathlib.Path(folder).glob("*.h")):
        if path.name in OF_CPLUSPLUS or path.name == "ode_MT.h":
            continue
        for name, declaration in declarations_in(path.read_text(encoding="latin-1")):
            declarations.setdefault(name, declaration)
    return declarations


def groups_of(folder):
    """Lists of names by the groups' names."""
    groups = {}
    for path in sorted(pathlib.Path(folder).glob("*.dox")):
        text = path.read_text()
        groups[GROUP.search(text)[1]] = [name for names in LISTED.findall(text) for name in names.split()]
    return groups


def of_some_releases(folder):
    """Functions that some releases of ode/releases/ declare and others do not: groups list them, whatever release is built."""
    lines = [line.split() for kind in ("new", "gone") for path in sorted(folder.glob(f"*/{kind}_functions.txt"))
             for line in path.read_text().splitlines()]
    return {words[1] for words in lines if words and words[0] != "#"}


def complaints(declared, groups, others=()):
    """What is wrong with the groups, a sentence each; `others` may be in a group without being declared."""
    listed = [name for names in groups.values() for name in names]
    for name in sorted(set(declared) - set(listed)):
        yield f"{name} is in no group"
    for name in sorted(set(listed) - set(declared) - set(others)):
        yield f"{name} is in a group, but in no header"
    for name in sorted({name for name in listed if listed.count(name) > 1}):
        yield f"{name} is in a group more than once, or in several"
