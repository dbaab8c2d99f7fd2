#!/usr/bin/env python3
"""Layers of ode_mt/: rooms include downwards only, and no folders include one another in a circle.

    check_layers.py ODE_MT       the folder; prints each include that goes upwards, with its file and line
    check_layers.py --self-test  shows that trees with such includes are refused

A room is a folder in ode_mt/. A new room, or one that includes another one for the first time, gets its place in MAY_INCLUDE.
"""
import pathlib
import re
import tempfile

from checks import run_check, unexpected

# What each room may include, besides itself. Collision and dynamics know nothing of each other; clusters are opted into by
# exported functions alone, and so is remote, which implements what dynamics asks of it (dynamics/step/dxRemoteSolvers.h).
MAY_INCLUDE = {
    "core": (),
    "threading": ("core",),
    "settings": ("core", "threading"),
    "collision": ("core", "threading", "settings"),
    "dynamics": ("core", "threading", "settings"),
    "remote": ("core", "threading", "settings", "dynamics"),
    "clusters": ("core", "threading", "settings", "collision"),
    "api": ("core", "threading", "settings", "collision", "dynamics", "remote", "clusters"),
}
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')


def includes_of(root):
    """Yields (file, line number, included file) of includes within the folder, all relative to it."""
    for path in sorted(path for path in root.rglob("*") if path.suffix in (".h", ".cpp")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            for folder in (path.parent, root):
                target = folder / match[1]
                if target.exists():
                    yield path.relative_to(root), number, target.resolve().relative_to(root.resolve())
                    break


def upwards(includes):
    """Complaints about includes that the table does not allow."""
    for file, number, target in includes:
        room, other = file.parts[0], target.parts[0]
        if room not in MAY_INCLUDE:
            yield f"{file}:{number}: {room}/ has no place among the rooms"
        elif other != room and other not in MAY_INCLUDE[room]:
            yield f"{file}:{number}: {room}/ must not include {other}/ ({target})"


def circles(includes):
    """Complaints about folders that include one another, one with each include that closes the circle."""
    edges = {}
    for file, number, target in includes:
        if file.parent != target.parent:
            edges.setdefault(file.parent, {}).setdefault(target.parent, []).append(f"{file}:{number}: {target}")

    def reached_from(start):
        seen, left = set(), [start]
        while left:
            for folder in edges.get(left.pop(), ()):
                if folder not in seen:
                    seen.add(folder)
                    left.append(folder)
        return seen

    reached = {folder: reached_from(folder) for folder in edges}
    for folder in sorted(edges):
        for other in sorted(edges[folder]):
            if folder in reached.get(other, ()):
                for place in edges[folder][other]:
                    yield f"{place} (from {other}/ one comes back to {folder}/)"


def complaints_of(root):
    includes = list(includes_of(pathlib.Path(root)))
    return [*upwards(includes), *circles(includes)]


def self_test():
    cases = {
        "downwards": ({"core/a.h": "", "threading/b.h": "core/a.h", "api/c.cpp": "threading/b.h"}, []),
        "upwards": ({"core/a.h": "threading/b.h", "threading/b.h": ""},
                    ["core/a.h:2: core/ must not include threading/ (threading/b.h)"]),
        "sideways": ({"dynamics/a.cpp": "collision/b.h", "collision/b.h": ""},
                     ["dynamics/a.cpp:2: dynamics/ must not include collision/ (collision/b.h)"]),
        "named as neighbours": ({"core/a.cpp": "../api/b.h", "api/b.h": ""}, ["core/a.cpp:2: core/ must not include api/ (api/b.h)"]),
        "a room without a place": ({"attic/a.cpp": "core/b.h", "core/b.h": ""}, ["attic/a.cpp:2: attic/ has no place among the rooms"]),
        "a circle of folders": ({"core/x/a.h": "core/y/b.h", "core/y/b.h": "", "core/y/c.h": "core/z/d.h", "core/z/d.h": "core/x/a.h"},
                                ["core/x/a.h:2: core/y/b.h (from core/y/ one comes back to core/x/)",
                                 "core/y/c.h:2: core/z/d.h (from core/z/ one comes back to core/y/)",
                                 "core/z/d.h:2: core/x/a.h (from core/x/ one comes back to core/z/)"]),
        "a folder and its own folder": ({"core/a.h": "core/x/b.h", "core/x/b.h": "", "core/x/c.h": "core/d.h", "core/d.h": ""},
                                        ["core/a.h:2: core/x/b.h (from core/x/ one comes back to core/)",
                                         "core/x/c.h:2: core/d.h (from core/ one comes back to core/x/)"]),
    }

    def found_in(files):
        with tempfile.TemporaryDirectory() as folder:
            for path, included in files.items():
                file = pathlib.Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text("#pragma once\n" + (f'#include "{included}"\n' if included else ""))
            return complaints_of(folder)

    return unexpected(found_in, cases)


if __name__ == "__main__":
    run_check(complaints_of, self_test)
