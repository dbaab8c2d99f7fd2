"""Where the sources of a release are: a release number, an unpacked folder or an archive."""
import os
import pathlib
import re
import tarfile

from comparison.symbols import Unreadable

RELEASE = re.compile(r"\d+(\.\d+)+\Z")


def cache():
    root = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    return pathlib.Path(root) / "ode_mt"


def unpack(archive, scratch):
    """The folder in `scratch` that has the archive's sources."""
    scratch.mkdir(parents=True)
    try:
        with tarfile.open(archive) as packed:
            packed.extractall(scratch, **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))
    except (tarfile.TarError, EOFError, OSError) as error:
        raise Unreadable(f"{archive} cannot be unpacked: {error}") from None
    folders = [path for path in scratch.iterdir() if path.is_dir()]
    return folders[0] if len(folders) == 1 else scratch


def folder_of(name, repository, scratch):
    """The folder with the sources that the user calls `name`. An archive is unpacked into the folder `scratch`."""
    path = pathlib.Path(name)
    if RELEASE.match(name) and not path.exists():
        unpacked = repository / "ode" / "upstream" / f"ode-{name}"
        archive = cache() / f"ode_{name}.orig.tar.gz"
        if unpacked.is_dir():
            return unpacked
        if archive.is_file():
            return unpack(archive, scratch)
        raise Unreadable(f"release {name} is not here: there is neither {unpacked} nor {archive}")
    if path.is_dir():
        return path
    if path.is_file():
        return unpack(path, scratch)
    raise Unreadable(f"{name}: no release number, no folder, no archive")


def version_of(folder):
    """The release number and the number of the shared library (libtool's CURRENT, REVISION, AGE), as configure.ac has them."""
    try:
        text = (folder / "configure.ac").read_text(encoding="latin-1")
    except OSError:
        return "", ""
    release = re.search(r"AC_INIT\(\[?ODE\]?, *\[?([\w.]+)", text)
    numbers = [re.search(rf"^{name}=(\d+)", text, re.MULTILINE) for name in ("CURRENT", "REVISION", "AGE")]
    library = ""
    if all(numbers):
        current, revision, age = (int(number[1]) for number in numbers)
        library = f"libode.so.{current - age}.{age}.{revision}"
    return release[1] if release else "", library
