#!/usr/bin/env python3
"""What the library keeps for the process is an object of dxProcess, or stands in globals.txt with the reason why it is not.

    check_globals.py NM LIBRARY REPOSITORY    prints each variable of ode_mt/ that is neither, and each line of the list that is out of date
    check_globals.py --self-test              shows that such variables and lines are found

LIBRARY is libode.a: each member is the object of one source file. Variables are those in its writable sections; constants that hold addresses are
in one that becomes read-only. Those of one thread are not of the process.
"""
import pathlib
import re
import subprocess

from checks import run_check, unexpected

WRITABLE = re.compile(r"\.(?:data|bss)(?!\.rel\.ro)")  # also a section for each variable, as .bss.NAME
MEMBER = re.compile(r"(\w+\.cpp)\.o:(.*)")
LIST = "tests/layers/globals.txt"


def variables_of(listing):
    """Yields (name, source file) from what `nm -A -C -f sysv` prints of an archive."""
    for line in listing.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        match = MEMBER.search(cells[0])
        if match and WRITABLE.match(cells[-1]):
            yield re.sub(r"\[abi:\w+\]", "", match[2]).split("::")[-1], match[1]


def complaints(variables, sources, listed):
    """`listed`: names, or FILE:NAME where others may have the same name."""
    words = set(re.findall(r"\w+", "\n".join(sources.values())))
    # Others are the compiler's, or upstream's, some of whose files have the name of one of ours.
    own = sorted({(name, file) for name, file in variables if file in sources and name in words})
    named = {(name, file): {name, f"{file[:-len('.cpp')]}:{name}"} for name, file in own}
    for name, file in own:
        if named[name, file].intersection(listed):
            continue
        if not re.search(rf"\bdxProcessObject<.*>\s+{name};", sources[file]):
            yield f"ode_mt/.../{file}: {name} is neither a dxProcessObject nor in {LIST}"
    there = set().union(*named.values())
    for name in listed:
        if name not in there:
            yield f"{LIST}: there is no variable {name}"


def read_list(text):
    return [line.split("|")[0].strip() for line in text.splitlines() if line.strip() and not line.startswith("#")]


def complaints_of(nm, library, root):
    root = pathlib.Path(root)
    listing = subprocess.run([nm, "-A", "-C", "-f", "sysv", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    sources = {path.name: path.read_text() for path in (root / "ode_mt").rglob("*") if path.suffix in (".cpp", ".h")}
    variables = list(variables_of(listing))
    if not any(file in sources for _, file in variables):
        return ["no variable of ode_mt/ was found"]
    return list(complaints(variables, sources, read_list((root / LIST).read_text())))


def self_test():
    def found(case):
        listing, sources, listed = case
        return list(complaints(variables_of(listing), sources, listed))

    row = "lib/libode.a:b.cpp.o:{}|0000000000000010|   b  |            OBJECT|0000000000000008|     |{}"
    unknown = ["ode_mt/.../b.cpp: last is neither a dxProcessObject nor in tests/layers/globals.txt"]
    cases = {
        "an object of the process": ((row.format("(anonymous namespace)::pool", ".bss"), {"b.cpp": "dxProcessObject<int> pool;"}, []), []),
        "a variable without a reason": ((row.format("last", ".bss"), {"b.cpp": "int last;"}, []), unknown),
        "in a section of its own": ((row.format("last", ".bss.last"), {"b.cpp": "int last;"}, []), unknown),
        "one that holds an address": ((row.format("last", ".data.rel.local"), {"b.cpp": "int *last = &x;"}, []), unknown),
        "one with a reason": ((row.format("last", ".data"), {"b.cpp": "int last;"}, ["last"]), []),
        "one with a reason in its file": ((row.format("last", ".data"), {"b.cpp": "int last;"}, ["b:last"]), []),
        "one with a reason in another file": ((row.format("last", ".data"), {"b.cpp": "int last;"}, ["a:last"]),
                                              [*unknown, "tests/layers/globals.txt: there is no variable a:last"]),
        "a constant": ((row.format("kTable", ".data.rel.ro.local"), {"b.cpp": "kTable"}, []), []),
        "of a thread": ((row.format("t_own", ".tbss"), {"b.cpp": "t_own"}, []), []),
        "of upstream's": ((row.format("g_count", ".bss"), {"b.cpp": "int last;"}, []), []),
        "a line that is out of date": (("", {"b.cpp": "// gone"}, ["gone"]), ["tests/layers/globals.txt: there is no variable gone"]),
    }
    return unexpected(found, cases)


if __name__ == "__main__":
    run_check(complaints_of, self_test)
