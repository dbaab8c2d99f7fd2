"""Which of upstream's headers and names our files use."""
import collections
import pathlib

from comparison.symbols import names_in, tokens_of
from comparison.tables import INCLUDE, readable, upstream_header

SUFFIXES = {".h", ".cpp", ".c", ".in"}
ROOTS = ("ode_mt", "ode/seams", "ode/releases", "tests")


class Ours:
    """Names in our files that include upstream's internal headers, themselves or through a header of ours."""

    def __init__(self, repository, tree):
        self.repository, self.tree = repository, tree
        self.headers = collections.defaultdict(set)  # upstream's headers: files of ours that include them
        texts = {}
        for root in ROOTS:
            for path in sorted((repository / root).rglob("*")):
                if path.suffix in SUFFIXES and path.is_file():
                    texts[path.relative_to(repository).as_posix()] = readable(path)
        direct = {path: set(self.includes(path, text)) for path, text in texts.items()}
        for path, headers in direct.items():
            for header in headers:
                self.headers[header].add(path)
        for header in list(self.headers):
            self.follow(header, self.headers[header])
        users = {path for path in texts if not path.startswith("tests/")}
        users |= {path for path, headers in direct.items() if any(not header.startswith("include/") for header in headers)}
        self.names = collections.defaultdict(list)  # name: files that use it
        for path in sorted(users):
            for name in names_in([token.text for token in tokens_of(texts[path])]):
                self.names[name].append(path)

    def includes(self, path, text):
        """Upstream's headers among a file's includes."""
        folder = (self.repository / path).parent
        for sign, include in INCLUDE.findall(text):
            if sign == '"' and (folder / include).exists() or any((self.repository / root / include).exists() for root in ("ode_mt", "ode/config")):
                continue
            header = upstream_header(include, None, self.tree)
            if header is not None:
                yield header

    def follow(self, header, includers):
        """Adds the headers that a header of upstream's includes."""
        folder = str(pathlib.PurePosixPath(header).parent)
        for _, include in INCLUDE.findall(self.tree.text(header)):
            inner = upstream_header(include, folder, self.tree)
            if inner is not None and not includers <= self.headers[inner]:
                self.headers[inner] |= includers
                self.follow(inner, includers)

    def users(self, names):
        """Files that use one of the names, ode_mt/ first."""
        found = {path for name in names for path in self.names.get(name, ())}
        return sorted(found, key=lambda path: (not path.startswith("ode_mt/"), path))

    def calls(self, name):
        return bool(self.names.get(name))
