"""What the fork does with upstream's code: its seams and sources, as CMake sees them, and ode/follows.toml."""
import collections
import fnmatch
import pathlib
import re
import subprocess
import tempfile
import tomllib

from comparison.symbols import Unreadable

# seams.cmake and sources.cmake are run as they are; what they set for a source file is written down instead.
READER = r"""
cmake_minimum_required(VERSION 3.25)
set(ODE_MT_UPSTREAM_DIR "/upstream")
set(ODE_MT_RELEASE_DIR "@RELEASE@")
function(set_property)
    list(JOIN ARGN "\t" line)
    file(APPEND "@OUTPUT@" "property\t${line}\n")
endfunction()
function(configure_file)
endfunction()
include("@ODE@/sources.cmake")
include("@ODE@/seams.cmake")
foreach(source IN LISTS ODE_MT_UPSTREAM_SOURCES)
    file(APPEND "@OUTPUT@" "source\t${source}\n")
endforeach()
"""

Seams = collections.namedtuple("Seams", "renamed replaced compiled_after compiled")
Follow = collections.namedtuple("Follow", "what ours tests upstream")


def release_folder(repository, release):
    """Its folder in ode/releases/, with the seams that it alone needs; of a release that has none yet, the newest one's."""
    own = repository / "ode" / "releases" / release
    if own.is_dir():
        return own
    return max(own.parent.glob("*"), key=lambda folder: [int(number) for number in re.findall(r"\d+", folder.name)], default=own)


def read_seams(repository, release):
    """renamed: (file, function); replaced: {(function, replacement): files}; compiled_after: (file, header); compiled: all source files."""
    seams = Seams([], collections.OrderedDict(), [], [])
    with tempfile.TemporaryDirectory() as scratch:
        script, output = pathlib.Path(scratch) / "read.cmake", pathlib.Path(scratch) / "output"
        script.write_text(READER.replace("@OUTPUT@", str(output)).replace("@ODE@", str(repository / "ode")).replace("@RELEASE@", str(release_folder(repository, release))))
        try:
            run = subprocess.run(["cmake", "-P", str(script)], cwd=scratch, capture_output=True, text=True, check=False)
        except OSError as error:
            raise Unreadable(f"cmake, which reads ode/seams.cmake, does not run: {error}") from None
        if run.returncode != 0:
            raise Unreadable(f"ode/seams.cmake cannot be read: {run.stderr.strip()}")
        lines = output.read_text().splitlines()
    for line in lines:
        kind, *fields = line.split("\t")
        if kind == "source":
            seams.compiled.append(fields[0].removeprefix("/upstream/"))
            continue
        source = next(field for field in fields if field.startswith("/upstream/")).removeprefix("/upstream/")
        if "COMPILE_DEFINITIONS" in fields:
            function, replacement = fields[-1].split("=", 1)
            seams.replaced.setdefault((function, replacement), []).append(source)
        for option, value in zip(fields, fields[1:]):
            if option == "-include":
                header = pathlib.Path(value)
                if str(header).startswith(scratch):
                    seams.renamed.append((source, header.stem))
                else:
                    seams.compiled_after.append((source, header.relative_to(repository).as_posix()))
    return seams


def read_follows(repository):
    path = repository / "ode" / "follows.toml"
    try:
        entries = tomllib.loads(path.read_text())["follows"]
        return [Follow(entry["what"], entry["ours"], entry["tests"], entry["upstream"]) for entry in entries]
    except (OSError, KeyError, tomllib.TOMLDecodeError) as error:
        raise Unreadable(f"{path} cannot be read: {error!r}") from None


def places_of(repository, path):
    """The files or folders that an entry of `ours` or `tests` names."""
    place = repository / path
    return [found for found in (place, place.with_name(place.name + ".h"), place.with_name(place.name + ".cpp")) if found.exists()]


def followed_keys(names, symbols):
    """Of a file's symbols those that an entry names. A declaration counts only where there is no definition."""
    found = set()
    for name in names:
        keys = [key for key in symbols if fnmatch.fnmatchcase(key[1], name)]
        keys = [key for key in keys if key[0] != "rest" or name == "*"]
        defined = [key for key in keys if key[0] != "declaration"]
        found.update(defined or keys)
    return found


def readable(path):
    return pathlib.Path(path).read_text(encoding="latin-1")


INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)
# As ode/CMakeLists.txt has them for ode_mt/. libccd is the system's.
HEADER_FOLDERS = ("ode/src", "ode/src/joints", "OPCODE", "OPCODE/Ice", "ou/include", "include")


def upstream_header(include, includer_folder, tree):
    """The path in upstream's sources that an include means, or None. `includer_folder`: upstream's folder of the includer, or None."""
    folders = ([includer_folder] if includer_folder else []) + list(HEADER_FOLDERS)
    for folder in folders:
        path = pathlib.PurePosixPath(folder) / include
        parts = []
        for part in path.parts:
            if part == "..":
                parts = parts[:-1]
            elif part != ".":
                parts.append(part)
        if "/".join(parts) in tree.files:
            return "/".join(parts)
    return None
