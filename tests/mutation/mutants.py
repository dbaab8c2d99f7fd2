"""Mutants of C++ text: small defects, each at one place, as people make them.

Works on text that clang-format has laid out, so that a small tokenizer is enough: binary operators stand between spaces,
brackets of templates do not, and a statement that fits ends on its line.

A mutant is text that holds the original, too, and chooses between the two when it runs (`dxMutant`, chosen_mutant.h): so
hundreds are compiled at once, and a variable selects the one of a process.
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

# What is decided when it is compiled cannot be chosen when it runs.
_FIXED = re.compile(r"^.*(?:\bconstexpr\b|\bstatic_assert\b|\benum\b|\bcase\b|\btemplate <).*$", re.M)

# Numbers that only tune speed: how many of something are taken at once, what is worth a worker.
_TUNING = re.compile(r"^\s*(?:static |inline )*constexpr .*\bk[A-Z]\w*", re.M)

# Where an expression begins, read backwards from within it, and ends; at brackets that it does not close in any case.
_BEGINS = re.compile(r"(?:[;{}]| = |, ?|\breturn |\? | : )$")
_ENDS = re.compile(r"[;{},]| \? | : ")


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    begin: int  # offsets of the replaced text
    end: int
    line: int
    operator: str
    old: str
    new: str
    site: tuple  # offsets of the whole expression or statement around it

    @property
    def name(self):
        return f"{self.file}:{self.line}:{self.begin}:{self.operator}:{self.new}"

    def choosing(self, text, number):
        """Returns the replacement of the site: the mutant if it is chosen, else the original."""
        begin, end = self.site
        original = text[begin:end]
        mutant = (text[begin:self.begin] + self.new + text[self.end:end]).replace("\n", " ")  # lines keep their numbers
        if self.operator == "statement":
            return f"{{ if (!dxMutant({number})) {original} }}"
        if self.operator == "return":
            return f"{{ if (dxMutant({number})) {mutant} {original} }}"
        return f"(dxMutant({number}) ? ({mutant}) : ({original}))"


def with_mutants(text, mutants):
    """The text with several of them, given as pairs of number and mutant, whose sites do not touch."""
    for number, mutant in sorted(mutants, key=lambda pair: -pair[1].site[0]):
        begin, end = mutant.site
        text = text[:begin] + mutant.choosing(text, number) + text[end:]
    return text


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


def _expression_around(code, begin, end):
    """Offsets of the smallest whole expression around a part of it."""
    depth, left = 0, begin
    while left > 0:
        before = code[left - 1]
        if before in ")]":
            depth += 1
        elif before in "([":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0 and _BEGINS.search(code[max(0, left - 8):left]):
            break
        left -= 1
    depth, right = 0, end
    while right < len(code):
        if code[right] in "([":
            depth += 1
        elif code[right] in ")]":
            if depth == 0:
                break
            depth -= 1
        elif depth == 0 and _ENDS.match(code, right):
            break
        right += 1
    while code[left].isspace():
        left += 1
    while code[right - 1].isspace():
        right -= 1
    return left, right


def _replacements(text):
    """Yields (operator, begin, end, new text, site)."""
    for found in _BINARY_AT.finditer(text):
        yield "operator", found.start(), found.end(), _BINARY[found.group()], _expression_around(text, *found.span())
    for found in _STEP_AT.finditer(text):
        yield "step", found.start(), found.end(), "--" if found.group() == "++" else "++", _expression_around(text, *found.span())
    for found in _NUMBER_AT.finditer(text):
        yield "constant", found.start(1), found.end(1), str(int(found.group(1)) + 1), _expression_around(text, *found.span(1))
    for found in _CONDITION_AT.finditer(text):
        opening = found.end() - 1
        end = closing(text, opening)
        condition = text[opening + 1:end] if end else ""
        if condition and ";" not in condition and not re.match(r"(?:const )?\w+[ *&]+\w+ = ", condition):
            yield "condition", opening + 1, end, f"!({condition})", (opening + 1, end)
    for found in _RETURN_AT.finditer(text):
        value = found.group(1)
        boolean = re.search(r"[<>!=]=| [<>] |&&|\|\||^!|^true$|^false$|^is[A-Z]\w*\(|^has[A-Z]\w*\(", value)
        if value in ("0", "nullptr", "{}"):
            continue  # what {} is, too
        yield "return", found.start(1), found.end(1), f"!({value})" if boolean else "{}", found.span()
    for found in _STATEMENT_AT.finditer(text):
        yield "statement", found.start(1), found.end(1), "", (found.start(1), found.end(2))


def mutants_of(file, text):
    """All mutants of a file, in the order of its text."""
    code = blanked(text)
    left_out = [range(found.start(), code.find("\n", found.start())) for found in _TUNING.finditer(code)]
    left_out += [range(*found.span()) for found in _FIXED.finditer(code)]
    for operator, begin, end, new, site in sorted(set(_replacements(code)), key=lambda r: (r[1], r[0])):
        if not any(begin in lines for lines in left_out) and "//" not in text[slice(*site)]:
            yield Mutant(file, begin, end, text.count("\n", 0, begin) + 1, operator, text[begin:end], new, site)
