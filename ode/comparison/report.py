"""Every difference of two releases in one of the groups of the report, with what ours does in its place."""
import collections
import difflib
import pathlib
import re

from comparison.changes import changes_of, diff_of, last_name, names_given, renamed_names, size_of, successor_of
from comparison.ours import Ours
from comparison.releases import version_of
from comparison.symbols import names_in, tokens_of
from comparison.tables import followed_keys, readable

# `needs_work`: the exit status says whether there are such. `diff`: lines.
Item = collections.namedtuple("Item", "needs_work text diff about")

TABLES = "The tables do not fit"
FOLLOWED = "Changed, and ours follows it"
HEADERS = "Changed in internal headers that ours includes"
EXPORTS = "Exports: new, gone, declared otherwise"
PUBLIC = "Changed in the public headers"
BUILD = "Build configuration"
FILES = "Source files: new, gone"
RENAMED = "Changed, and renamed only (signature compared)"
AS_IT_IS = "Changed, compiled as it is: nothing to do but the tests"
NOT_COMPILED = "Changed, not compiled"
GROUPS = (TABLES, FOLLOWED, HEADERS, EXPORTS, PUBLIC, BUILD, FILES, RENAMED, AS_IT_IS, NOT_COMPILED)

BUILD_FILES = re.compile(r"(configure\.ac|CMakeLists\.txt|config\.h\.cmake\.in|ode\.pc\.in|ode-config(\.cmake)?\.in|ode/src/config\.h\.in"
                         r"|include/ode/\w+\.h\.in|(ode/src|ode/src/joints|OPCODE|OPCODE/Ice|ou/src/ou|include/ode)/Makefile\.am)\Z")
GENERATED = re.compile(r"include/ode/(version|precision)\.h\Z|(.*/)?(Makefile\.in|configure|aclocal\.m4)\Z")
OTHER_FOLDERS = {"tests": "upstream's tests, which tests/upstream compiles", "libccd": "the system's is used",
                 "ode/demo": "demo_ode.cpp is compiled by tests/upstream"}
kMaxUsers = 3  # that a line names


def some(paths):
    paths = list(paths)
    return ", ".join(paths[:kMaxUsers]) + (f" and {len(paths) - kMaxUsers} more" if len(paths) > kMaxUsers else "")


def is_export(change):
    return change.kind == "declaration" and change.path.startswith("include/ode/") \
        and any(symbol is not None and "ODE_API" in symbol.text for symbol in (change.old, change.new))


class Report:
    """The groups of items, in order."""

    def __init__(self, repository, old, new, seams, follows):
        self.repository, self.old, self.new, self.seams, self.follows = repository, old, new, seams, follows
        self.ours = Ours(repository, old)
        self.items = {group: collections.OrderedDict() for group in GROUPS}  # heading: items
        self.gathered = collections.OrderedDict()
        self.changes = [change for change in changes_of(old, new) if not GENERATED.match(change.path)]
        self.changed_functions = {(change.path, change.name) for change in self.changes if change.kind == "function"}
        self.releases = (version_of(old.folder), version_of(new.folder))
        self.find_followed()
        self.check_seams()
        self.build()
        self.files()
        for change in self.changes:
            self.place(change)
        self.flush()

    # ---- what the tables say

    def find_followed(self):
        """followed: {(path, key): entries}, those that name it most exactly; used: {name: followed functions that use it, with their files}."""
        exactness = collections.Counter()
        self.followed = collections.defaultdict(list)
        for entry in self.follows:
            for path, names in entry.upstream.items():
                symbols = {**self.old.symbols.get(path, {}), **self.new.symbols.get(path, {})}
                for name in names:
                    keys = followed_keys([name], symbols)
                    if not keys:
                        self.add(TABLES, True, f"ode/follows.toml ({entry.what}): neither release has {name} in {path}")
                    exact = len(name.replace("*", "")) + 1
                    for key in keys:
                        if exact > exactness[path, key]:
                            exactness[path, key] = exact
                            self.followed[path, key] = []
                        if exact == exactness[path, key]:
                            self.followed[path, key].append(entry)
        self.used = collections.defaultdict(set)
        for path, key in self.followed:
            if key[0] in ("function", "macro"):
                for tree in (self.old, self.new):
                    symbol = tree.symbol(path, key)
                    for name in names_in(symbol.text) if symbol is not None else ():
                        self.used[name].add((key[1], path))

    def check_seams(self):
        for path, function in self.seams.renamed:
            if self.new.symbol(path, ("function", function)) is None:
                places = self.new.by_key.get(("function", function), [])
                self.add(TABLES, True, f"ode/seams.cmake renames {function} in {path}; it is {'in ' + some(places) if places else 'gone'}")
        for (function, replacement), paths in self.seams.replaced.items():
            for path in paths:
                if function in self.old.names(path) and function not in self.new.names(path):
                    self.add(TABLES, True, f"ode/seams.cmake has {path} call {replacement} instead of {function}, which it does not use any more")
            for path in self.seams.compiled:
                if path not in paths and function in self.new.names(path) and function not in self.old.names(path):
                    self.add(TABLES, True, f"{path} uses {function} as well, and ode/seams.cmake does not name that file ({replacement})")
        before, after = (set().union(*(tree.names(path) for path in tree.sources)) for tree in (self.old, self.new))
        for path, header in self.seams.compiled_after:
            if path not in self.new.files:
                self.add(TABLES, True, f"{path}, which is compiled after {header}, is gone")
            names = names_in([token.text for token in tokens_of(readable(self.repository / header))])
            for name in sorted((names & before) - after):
                self.add(TABLES, True, f"{header} names {name}, which is gone")

    # ---- files

    def build(self):
        (old_release, old_library), (new_release, new_library) = self.releases
        if old_library != new_library:
            self.add(BUILD, True, f"shared library: {old_library} is {new_library}")
        hide = [release for release in (old_release, new_release) if release]
        for path in sorted(filter(BUILD_FILES.match, self.old.files | self.new.files)):
            texts = []
            for tree in (self.old, self.new):
                text = tree.text(path) if path in tree.files else ""
                for release in hide:
                    text = text.replace(release, "RELEASE")
                lines = (" ".join(line.split()) for line in text.splitlines())
                texts.append([line for line in lines if line and not re.match(r"dnl\b|#(?!\s*(undef|define|if|el|endif|include|cmakedefine))", line)])
            if texts[0] == texts[1]:
                continue
            options = [set(re.findall(r"AC_ARG_(?:ENABLE|WITH)\(\[?([\w-]+)|#\s*(?:undef|cmakedefine)\s+(\w+)|^option\( ?(\w+)", "\n".join(text),
                                      re.MULTILINE)) for text in texts]
            notes = [f"{word}: {', '.join(sorted(name for names in found for name in names if name))}"
                     for word, found in (("new", options[1] - options[0]), ("gone", options[0] - options[1])) if found]
            diff = list(difflib.unified_diff(*texts, f"old/{path}", f"new/{path}", n=1, lineterm=""))
            state = "new" if path not in self.old.files else "gone" if path not in self.new.files else "changed"
            self.add(BUILD, True, f"{path} {state}" + (f"; options {'; '.join(notes)}" if notes else ""), diff, path)

    def files(self):
        """Files that are there in one release alone, and those that differ but are not compiled."""
        self.lone = self.old.files ^ self.new.files
        for path in sorted(self.lone):
            state = "new" if path in self.new.files else "gone"
            if path in self.old.sources or path in self.new.sources:
                code = path.endswith((".c", ".cpp"))
                if code and state == "new" and path not in self.seams.compiled:
                    self.add(FILES, True, f"{path} new: compile it (ode/sources.cmake), or leave it out", about=path)
                elif code and state == "gone" and path in self.seams.compiled:
                    self.add(FILES, True, f"{path} gone: ode/sources.cmake compiles it", about=path)
                elif path.startswith("include/ode/"):
                    self.add(FILES, True, f"{path} {state}: a public header", about=path)
                else:
                    self.add(FILES, False, f"{path} {state}", about=path)
        counts = collections.Counter()
        for path in sorted((self.old.files & self.new.files) - set(self.old.sources) - set(filter(BUILD_FILES.match, self.old.files))):
            if GENERATED.match(path) or self.old.text(path) == self.new.text(path):
                continue
            if path.endswith((".c", ".cpp", ".h")):
                texts = ([token.text for token in tokens_of(tree.text(path))] for tree in (self.old, self.new))
                if next(texts) == next(texts):
                    continue
            folder = "/".join(path.split("/")[:-1][:2 if path.startswith("ode/") else 1]) or path
            counts[next((other for other in OTHER_FOLDERS if path.startswith(other + "/")), folder)] += 1
        for folder, count in sorted(counts.items()):
            note = f", files: {count}" if (self.new.folder / folder).is_dir() else ""
            self.add(NOT_COMPILED, False, folder + note + (f" ({OTHER_FOLDERS[folder]})" if folder in OTHER_FOLDERS else ""))

    # ---- symbols

    def place(self, change):
        """Puts a change into its group."""
        if change.kind == "declaration" and (change.path, change.name) in self.changed_functions:
            return  # its definition is listed
        if is_export(change):
            lost = "" if any(tree.by_key.get(("function", change.name)) for tree in (self.old, self.new)) else ", declared and never defined"
            self.add_change(EXPORTS, True, change, lost)
        elif entries := self.entries_of(change):
            for entry in entries:
                heading = f"{entry.what}\n      ours: {', '.join(entry.ours)}\n      tests: {', '.join(entry.tests)}"
                self.add_change(FOLLOWED, change.state != "moved", change, heading=heading)
        elif change.path in self.lone:
            pass  # the file is listed
        elif change.path.startswith("include/ode/"):
            self.add_change(PUBLIC, change.kind != "rest", change)
        elif self.is_replaced(change):
            replacement = next(other for (function, other) in self.seams.replaced if function == change.name)
            self.add_change(FOLLOWED, True, change, heading=f"called by another name\n      ours: {replacement} (ode/seams.cmake)")
        elif (change.path, change.name) in self.seams.renamed and change.kind == "function":
            self.place_renamed(change)
        elif self.is_included(change) and (users := self.ours.users(names_given(change))):
            self.add_change(HEADERS, True, change, f"; used in {some(users)}")
        elif callers := self.callers(change):
            self.gather(FOLLOWED, True, change, "not in ode/follows.toml, but used by functions that are", callers)
        elif header := next((header for path, header in self.seams.compiled_after if path == change.path), None):
            self.add_change(FOLLOWED, True, change, heading=f"in a file that is compiled after a header of ours\n      ours: {header}")
        elif self.is_included(change) and change.path.endswith(".h"):
            self.gather(HEADERS, False, change)
        elif change.path.endswith((".c", ".cpp")) and change.path not in self.seams.compiled:
            self.gather(NOT_COMPILED, False, change)
        else:
            self.gather(AS_IT_IS, False, change)

    def entries_of(self, change):
        """The entries of ode/follows.toml that name the change; a declaration has those of the function, wherever that is defined."""
        found = self.followed.get((change.path, (change.kind, change.name)), [])
        if found or change.kind != "declaration":
            return found
        paths = self.old.by_key.get(("function", change.name), [])
        return [entry for path in paths for entry in self.followed.get((path, ("function", change.name)), [])]

    def place_renamed(self, change):
        upstreams = re.sub("^d", "dxUpstream", change.name)
        users = self.ours.users([upstreams])
        declared = [tree.by_key.get(("declaration", change.name), []) for tree in (self.old, self.new)]
        texts = [[tree.symbol(path, ("declaration", change.name)).text for path in paths if path.startswith("include/ode/")]
                 for tree, paths in zip((self.old, self.new), declared)]
        note = "; signature unchanged" if texts[0] == texts[1] else "; SIGNATURE CHANGED"
        if users:
            self.add_change(RENAMED, texts[0] != texts[1], change, f"{note}; {upstreams} is called in {some(users)}")
        else:
            self.add_change(FOLLOWED, True, change, heading=f"renamed, and never called: ours takes its place\n      ours: "
                                                            f"{some(self.ours.users([change.name]))}")

    def is_replaced(self, change):
        return change.kind in ("function", "variable") and any(function == change.name for function, _ in self.seams.replaced)

    def is_included(self, change):
        return change.path in self.ours.headers and not change.path.startswith("include/")

    def callers(self, change):
        """Followed functions that use what has changed: in the same file, or if it is in a header."""
        if change.kind == "rest" or "::" in change.name:
            return set()
        return {name for given in names_given(change) for name, path in self.used.get(given, ())
                if path == change.path or change.path.endswith(".h")}

    # ---- items

    def add(self, group, needs_work, text, diff=(), about="", heading=""):
        self.items[group].setdefault(heading, []).append(Item(needs_work, text, list(diff), about))

    def add_change(self, group, needs_work, change, note="", heading=""):
        self.add(group, needs_work, f"{change.path}: {self.describe(change)}{note}", self.diff(change), f"{change.path} {change.name}", heading)

    def describe(self, change):
        label = f"declaration of {change.name}" if change.kind == "declaration" else change.name
        if change.kind not in ("function", "rest", "declaration") and not change.name.startswith(change.kind):
            label = f"{change.kind} {label}"
        text = f"{label} {change.state}"
        if change.state.startswith("moved"):
            text += f" (to {change.new.path})"
        if change.state in ("changed", "moved and changed"):
            text += f" {size_of(change)}"
            names = renamed_names(change)
            if names:
                text += " (only names: " + some(f"{before} is {after}" for before, after in names.items() if before != after) + ")"
        if change.state == "gone" and (successor := successor_of(change, self.changes)):
            text += f", perhaps now {successor.name}" + (f" in {successor.path}" if successor.path != change.path else "")
        return text

    def diff(self, change):
        new_path = change.new.path if change.new is not None else change.path
        return diff_of(change, f"old/{change.path} {change.name}", f"new/{new_path} {change.name}")

    def gather(self, group, needs_work, change, heading="", callers=()):
        """One line for all such changes of a file."""
        self.gathered.setdefault((group, needs_work, heading, change.path), []).append((change, callers))

    def flush(self):
        for (group, needs_work, heading, path), found in self.gathered.items():
            parts, users = [], set()
            for change, callers in found:
                called = self.ours.users([change.name]) if change.kind == "function" and group == AS_IT_IS and change.state != "new" else ()
                parts.append(self.describe(change) + (f" (called in {some(called)})" if called else ""))
                users |= set(callers)
            diff = [line for change, _ in found for line in self.diff(change)]
            note = f"; used by {some(sorted(users, key=last_name))}" if users else ""
            self.add(group, needs_work, f"{path}: {'; '.join(parts)}{note}", diff, " ".join([path, *(change.name for change, _ in found)]), heading)

    # ---- output

    def needs_work(self):
        return any(item.needs_work for group in self.items.values() for items in group.values() for item in items)

    def lines(self, with_diff=False, wanted=lambda about: True):
        (old_release, _), (new_release, _) = self.releases
        yield f"ODE {old_release or self.old.folder} and {new_release or self.new.folder}. ! needs work, - does not."
        for group in GROUPS:
            shown = [(heading, [item for item in items if wanted(item.about)]) for heading, items in self.items[group].items()]
            shown = [(heading, items) for heading, items in shown if items]
            if not shown:
                continue
            yield ""
            yield f"{group}: {sum(len(items) for _, items in shown)}"
            for heading, items in shown:
                if heading:
                    yield f"  {heading}"
                for item in items:
                    yield f"{'    ' if heading else '  '}{'!' if item.needs_work else '-'} {item.text}"
                    if with_diff:
                        yield from (f"        {line}" for line in item.diff)
        yield ""
        count = sum(item.needs_work for group in self.items.values() for items in group.values() for item in items)
        yield f"{count} need work." if count else "Nothing needs work."
