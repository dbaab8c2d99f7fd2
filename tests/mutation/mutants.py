"""Mutants of C++ text: small defects, each at one place, as people make them.

Works on text that clang-format has laid out, so that a small tokenizer is enough: binary operators stand between spaces,
brackets of templates do not, and a statement that fits ends on its line.
"""
import dataclasses
import re

# Comments, texts, characters, lines of the preprocessor: nothing in them is changed.
_IGNORED = re.compile(
    r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)

_BINARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
           "+": "-", "-": "+", "+=": "-=", "-=": "+="}
_BINARY_AT = re.compile(r"(?<= )(<=|>=|==|!=|&&|\|\||\+=|-=|<|>|\+|-)(?= )")
_STEP_AT = re.compile(r"\+\+|--")
_NUMBER_AT = re.compile(r"(?<![\w.'])(\d+)(?=[uUlL]*(?![\w.']))")
_CONDITION_AT = re.compile(r"\b(?:if|while) \(")
_RETURN_AT = re.compile(r"\breturn ([^;{}]+);")
_STATEMENT_AT = re.compile(r"^[ ]{4,}(?!return\b|using\b|static_assert\b|throw\b|delete\b|else\b|case\b|const\b|auto\b)"
                           r"(?:if \([^;]*\) )?((?:\*|\+\+|--)?[\w:.\[\]>()-]+?(?:\(.*\)| [-+|&]?= .*))(;)$", re.M)

# Numbers that only tune speed: how many of something are taken at once, what is worth a worker.
_TUNING = re.compile(r"^\s*(?:static |inline )*constexpr .*\bk[A-Z]\w*", re.M)


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    begin: int  # offsets of the replaced text
    end: int
    line: int
    operator: str
    old: str
    new: str

    @property
    def name(self):
        return f"{self.file}:{self.line}:{self.begin}:{self.operator}:{self.new}"

    def applied(self, text):
        assert text[self.begin:self.end] == self.old
        return text[:self.begin] + self.new + text[self.end:]


def blanked(text):
    """The text with what is ignored as spaces, so that places stay."""
    return _IGNORED.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def closing(text, opening):
    """The place of the bracket that closes the one at `opening`, or None."""
    depth = 0
    for place in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    return None


def _replacements(text):
    """Yields (operator, begin, end, new text)."""
    for found in _BINARY_AT.finditer(text):
        yield "operator", found.start(), found.end(), _BINARY[found.group()]
    for found in _STEP_AT.finditer(text):
        yield "step", found.start(), found.end(), "--" if found.group() == "++" else "++"
    for found in _NUMBER_AT.finditer(text):
        yield "constant", found.start(1), found.end(1), str(int(found.group(1)) + 1)
    for found in _CONDITION_AT.finditer(text):
        opening = found.end() - 1
        end = closing(text, opening)
        condition = text[opening + 1:end] if end else ""
        if condition and ";" not in condition and not re.match(r"(?:const )?\w+[ *&]+\w+ = ", condition):
            yield "condition", opening + 1, end, f"!({condition})"
    for found in _RETURN_AT.finditer(text):
        value = found.group(1)
        boolean = re.search(r"[<>=!]=| [<>] |&&|\|\||^!|^true$|^false$|^is[A-Z]\w*\(|^has[A-Z]\w*\(", value)
        if value in ("0", "nullptr", "{}"):
            continue  # what {} is, too
        yield "return", found.start(1), found.end(1), f"!({value})" if boolean else "{}"
    for found in _STATEMENT_AT.finditer(text):
        yield "statement", found.start(1), found.end(1), ""


def mutants_of(file, text):
    """All mutants of a file, in the order of its text."""
    code = blanked(text)
    tuning = [range(found.start(), code.find("\n", found.start())) for found in _TUNING.finditer(code)]
    for operator, begin, end, new in sorted(set(_replacements(code)), key=lambda r: (r[1], r[0])):
        if not any(begin in lines for lines in tuning):
            yield Mutant(file, begin, end, text.count("\n", 0, begin) + 1, operator, text[begin:end], new)
