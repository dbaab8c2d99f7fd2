"""Functions, types, macros and variables of a tree of C++ sources: universal-ctags says where they are, their text is compared token by
token. Comments and white space are no tokens.

Every token belongs to one symbol, the innermost around it, or to the rest of its file, so no change of a file is lost.
"""
import collections
import json
import pathlib
import re
import shutil
import subprocess

TOKEN = re.compile(
    r"""(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)
      | (?P<space>[^\S\n]+|\\\n)
      | (?P<newline>\n)
      | (?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
      | (?P<number>\.?\d(?:[eE][+-]|[\w.])*)
      | (?P<name>[A-Za-z_]\w*)
      | (?P<sign>->|\+\+|--|::|&&|\|\||\#\#|<<=?|>>=?|[-+*/%&|^!=<>]=|.)""",
    re.VERBOSE | re.DOTALL)
NAME = re.compile(r"[A-Za-z_]\w*\Z")
KINDS = {"macro": "macro", "function": "function", "prototype": "declaration", "enum": "enum", "struct": "type", "union": "type", "class": "type",
         "typedef": "type", "variable": "variable", "externvar": "declaration"}
SUFFIXES = {".c", ".cpp", ".h"}

Token = collections.namedtuple("Token", "text line")
# `text` of a symbol is the list of its tokens' texts; `lines` is what a diff shows.
Symbol = collections.namedtuple("Symbol", "path kind name text lines")


class Unreadable(Exception):
    """What cannot be compared, as a message for the user."""


def tokens_of(text):
    """The tokens of a text; the end of a preprocessor directive is a token of its own, "\\n"."""
    tokens, line, directive, fresh = [], 1, False, True
    for match in TOKEN.finditer(text):
        kind, piece = match.lastgroup, match[0]
        if kind == "newline":
            if directive:
                tokens.append(Token("\n", line))
            directive, fresh = False, True
        elif kind not in ("comment", "space"):
            directive = directive or (fresh and piece == "#")
            fresh = False
            tokens.append(Token(piece, line))
        line += piece.count("\n")
    if directive:
        tokens.append(Token("\n", line))
    return tokens


def names_in(tokens):
    return {token for token in tokens if NAME.match(token)}


def ctags():
    """The command, which Debian's package universal-ctags brings."""
    for command in ("ctags-universal", "ctags"):
        if shutil.which(command):
            features = subprocess.run([command, "--list-features"], capture_output=True, text=True, check=False).stdout
            if re.search(r"^json\b", features, re.MULTILINE):
                return command
    raise Unreadable("universal-ctags with JSON output is not installed (Debian: universal-ctags)")


def tags_of(folder, paths):
    """What ctags finds in the files, by path."""
    run = subprocess.run(
        [ctags(), "--options=NONE", "--output-format=json", "--languages=C++", "--langmap=C++:.c.cpp.h", "--kinds-C++=dfgpstuvcx",
         "--fields=+neKSs", "--sort=no", "-L", "-", "-f", "-"],
        cwd=folder, input="\n".join(paths), capture_output=True, encoding="latin-1", check=False)
    if run.returncode != 0:
        raise Unreadable(f"ctags fails in {folder}: {run.stderr.strip()}")
    tags = collections.defaultdict(list)
    for line in run.stdout.splitlines():
        tag = json.loads(line)
        if tag.get("_type") == "tag" and tag["kind"] in KINDS:
            tags[tag["path"]].append(tag)
    return tags


def name_of(tag):
    name = f"{tag['scope']}::{tag['name']}" if tag.get("scope") else tag["name"]
    return re.sub(r"__anon[0-9a-f]+", "(anonymous)", name)


def range_of(tag, tokens, firsts):
    """The first token of a symbol and the one behind its last. `firsts`: number of the first token of each line and after."""
    begin = firsts[min(tag["line"], len(firsts) - 1)]
    while begin > 0 and tokens[begin - 1].text not in (";", "{", "}", ":", "\n"):
        begin -= 1
    if "end" in tag:
        return begin, firsts[min(tag["end"] + 1, len(firsts) - 1)]
    end, depth = firsts[min(tag["line"], len(firsts) - 1)], 0
    while end < len(tokens):
        text = tokens[end].text
        depth += (text in ("{", "(")) - (text in ("}", ")"))
        end += 1
        if depth <= 0 and text in (";", "\n") or depth < 0:
            break
    return begin, end


def lines_of(tokens):
    lines = []
    for index, token in enumerate(tokens):
        if token.text == "\n":
            continue
        if index == 0 or token.line != tokens[index - 1].line:
            lines.append(token.text)
        else:
            lines[-1] += ("" if re.match(r"[;,()\[\]]|::|\.", token.text) or lines[-1].endswith(("(", "[", "::", ".", "!", "->"))
                          or token.text == "->" else " ") + token.text
    return lines


def symbols_of(path, text, tags):
    """The symbols of one file; the rest of the file is one of kind "rest"."""
    tokens = tokens_of(text)
    firsts, line = [], 0
    for index, token in enumerate(tokens):
        while line <= token.line:
            firsts.append(index)
            line += 1
    firsts.append(len(tokens))
    owner = [None] * len(tokens)
    keys = {}
    spans = [(*range_of(tag, tokens, firsts), tag) for tag in tags]
    for number, (begin, end, tag) in enumerate(sorted(spans, key=lambda span: span[0] - span[1])):  # the largest first
        name = name_of(tag)
        if tag["kind"] == "enum" and name.endswith("(anonymous)"):
            name = "enum " + next((token.text for token in tokens[begin:end] if NAME.match(token.text) and token.text != "enum"), "")
        keys[number] = (KINDS[tag["kind"]], name)
        owner[begin:end] = [number] * (end - begin)
    pieces = collections.defaultdict(list)
    for token, number in zip(tokens, owner):
        pieces[keys.get(number, ("rest", "(rest of the file)")), number].append(token)
    found = {}
    for (key, _), piece in pieces.items():  # overloads and variants under #if have one name
        symbol = found.setdefault(key, Symbol(path, key[0], key[1], [], []))
        symbol.text.extend(token.text for token in piece)
        symbol.lines.extend(lines_of(piece))
    return found


class Tree:
    """One release's sources."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.files = {path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*") if path.is_file() and not path.is_symlink()}
        if not any(path.startswith("ode/src/") for path in self.files) or not any(path.startswith("include/ode/") for path in self.files):
            raise Unreadable(f"{folder} holds no sources of ODE: it has no ode/src or no include/ode")
        self.sources = sorted(path for path in self.files if pathlib.PurePosixPath(path).suffix in SUFFIXES
                              and path.startswith(("ode/src/", "include/ode/", "OPCODE/", "ou/")))
        tags = tags_of(self.folder, self.sources)
        self.symbols = {path: symbols_of(path, self.text(path), tags[path]) for path in self.sources}
        self.by_key = collections.defaultdict(list)
        for path in self.sources:
            for key in self.symbols[path]:
                if key[0] != "rest":
                    self.by_key[key].append(path)
        self._names = {}

    def text(self, path):
        with open(self.folder / path, encoding="latin-1") as file:
            return file.read()

    def names(self, path):
        """All names in a file, comments aside."""
        if path not in self._names:
            self._names[path] = {name for symbol in self.symbols.get(path, {}).values() for name in names_in(symbol.text)}
        return self._names[path]

    def symbol(self, path, key):
        return self.symbols.get(path, {}).get(key)
