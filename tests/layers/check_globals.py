#!/usr/bin/env python3
"""What the library keeps for the process is an object of dxProcess, or stands in globals.txt with the reason why it is not.

    check_globals.py NM LIBRARY REPOSITORY    prints each variable of ode_mt/ that is neither, and each line of the list that is out of date
    check_globals.py --self-test              shows that such variables and lines are found

Variables are those in writable sections of the library that debug information places in ode_mt/; constants that hold addresses are
in a section that becomes read-only. Those of one thread are not of the process.
"""
import pathlib
import re
import subprocess

from checks import run_check, unexpected

WRITABLE = {".data", ".bss"}
LIST = "tests/layers/globals.txt"
PLACE = re.compile(r"ode_mt/(?:\./|\.\./|ode_mt/)*([\w/]+\.(?:cpp|h)):(\d+)$")


def variables_of(listing):
    """Yields (name, file, line number) from what `nm -C -l -f sysv` prints."""
    for line in listing.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) < 7:
            continue
        section, _, place = cells[-1].partition("\t")
        match = PLACE.search(place.strip())
        if section.strip() in WRITABLE and match:
            name = re.sub(r"\.(?:lto_priv|constprop)\.\d+$|\[abi:\w+\]", "", cells[0])
            yield name.split("::")[-1], match[1], int(match[2])


def complaints(variables, line_of, listed, sources):
    known = set(listed)
    for name, file, number in sorted(set(variables)):
        if name.startswith("guard variable") or "dxProcessObject<" in line_of(file, number) or name in known:
            continue
        yield f"ode_mt/{file}:{number}: {name} is neither a dxProcessObject nor in {LIST}"
    for name in listed:
        if not re.search(rf"\b{re.escape(name)}\b", sources):
            yield f"{LIST}: there is no variable {name}"


def read_list(text):
    return [line.split("|")[0].strip() for line in text.splitlines() if line.strip() and not line.startswith("#")]


def complaints_of(nm, library, root):
    root = pathlib.Path(root)
    listing = subprocess.run([nm, "-C", "-l", "-f", "sysv", library], check=True, capture_output=True, text=True).stdout
    variables = list(variables_of(listing))
    if not variables:
        return ["no variable of ode_mt/ was found: the library has no debug information"]
    files = {path.relative_to(root / "ode_mt").as_posix(): path.read_text() for path in (root / "ode_mt").rglob("dx*.*")}
    files |= {path.relative_to(root / "ode_mt").as_posix(): path.read_text() for path in (root / "ode_mt" / "api").glob("*.cpp")}

    def line_of(file, number):
        lines = files.get(file, "").splitlines()
        return lines[number - 1] if number <= len(lines) else ""

    return list(complaints(variables, line_of, read_list((root / LIST).read_text()), "\n".join(files.values())))


def self_test():
    def found(case):
        listing, lines, listed = case
        return list(complaints(variables_of(listing), lambda file, number: lines.get((file, number), ""), listed, " ".join(lines.values())))

    row = "{}|0000000000000010|   b  |            OBJECT|0000000000000008|     |{}\t/x/./ode_mt/core/./../../ode_mt/{}"
    cases = {
        "an object of the process": ((row.format("(anonymous namespace)::pool", ".bss", "a/b.cpp:3"),
                                      {("a/b.cpp", 3): "dxProcessObject<int> pool;"}, []), []),
        "a variable without a reason": ((row.format("last", ".bss", "a/b.cpp:3"), {("a/b.cpp", 3): "int last;"}, []),
                                        ["ode_mt/a/b.cpp:3: last is neither a dxProcessObject nor in tests/layers/globals.txt"]),
        "one with a reason": ((row.format("last", ".data", "a/b.h:3"), {("a/b.h", 3): "int last;"}, ["last"]), []),
        "a constant": ((row.format("kTable", ".data.rel.ro", "a/b.cpp:3"), {("a/b.cpp", 3): "kTable"}, []), []),
        "of a thread": ((row.format("t_own", ".tbss", "a/b.cpp:3"), {("a/b.cpp", 3): "t_own"}, []), []),
        "a line that is out of date": (("", {}, ["gone"]), ["tests/layers/globals.txt: there is no variable gone"]),
    }
    return unexpected(found, {name: (case, expected) for name, (case, expected) in cases.items()})


if __name__ == "__main__":
    run_check(complaints_of, self_test)
