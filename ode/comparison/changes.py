"""What differs between two trees: symbol by symbol, moved ones recognised, and where a name is used."""
import collections
import difflib

from comparison.symbols import NAME, names_in

# `state`: changed, new, gone, moved, moved and changed. `path`: in the old tree, for new symbols in the new one.
Change = collections.namedtuple("Change", "path kind name state old new")
kMinSimilarity = 0.6  # of tokens: a gone and a new symbol that agree in this part may be one that got another name


def same(old, new):
    return old.text == new.text


def new_place(path, key, old, new):
    """The file to which a symbol has moved, if there is exactly one that had none of that name."""
    places = [place for place in new.by_key.get(key, []) if key not in old.symbols.get(place, {})]
    return places[0] if len(places) == 1 and len(old.by_key.get(key, [])) == 1 else None


def changes_of(old, new):
    """All changes of sources, in the order of files."""
    found, arrived = [], set()
    for path in old.sources:
        for key, symbol in old.symbols[path].items():
            other = new.symbol(path, key)
            if other is not None:
                if not same(symbol, other):
                    found.append(Change(path, *key, "changed", symbol, other))
                continue
            place = new_place(path, key, old, new)
            if place is None:
                found.append(Change(path, *key, "gone", symbol, None))
            else:
                other = new.symbol(place, key)
                arrived.add((place, key))
                found.append(Change(path, *key, "moved" if same(symbol, other) else "moved and changed", symbol, other))
    for path in new.sources:
        for key, symbol in new.symbols[path].items():
            if old.symbol(path, key) is None and (path, key) not in arrived:
                found.append(Change(path, *key, "new", None, symbol))
    return sorted(found, key=lambda change: (change.path, first_line_order(change, old, new)))


def first_line_order(change, old, new):
    tree = old if change.old is not None else new
    return list(tree.symbols[change.path]).index((change.kind, change.name))


def last_name(name):
    return name.rsplit("::", 1)[-1]


def names_given(change):
    """The names by which others use what has changed."""
    if change.kind == "rest":
        return set()
    given = {last_name(change.name)}
    if change.kind == "enum":
        for symbol in (change.old, change.new):
            given |= names_in(symbol.text) if symbol is not None else set()
        given.discard("enum")
    return {name for name in given if NAME.match(name)}


def successor_of(change, changes):
    """A new symbol that a gone one may have become, or None."""
    best, ratio = None, kMinSimilarity
    for other in changes:
        if other.state != "new" or other.kind != change.kind:
            continue
        matcher = difflib.SequenceMatcher(None, change.old.text, other.new.text, autojunk=False)
        if matcher.real_quick_ratio() > ratio and matcher.quick_ratio() > ratio and matcher.ratio() > ratio:
            best, ratio = other, matcher.ratio()
    return best


def renamed_names(change):
    """Which names became which, if nothing else differs: {old: new}; else None."""
    if change.old is None or change.new is None or len(change.old.text) != len(change.new.text):
        return None
    names = {}
    for before, after in zip(change.old.text, change.new.text):
        if before == after and before not in names:
            continue
        if not NAME.match(before) or not NAME.match(after) or names.setdefault(before, after) != after:
            return None
    return names


def diff_of(change, before, after):
    old = change.old.lines if change.old is not None else []
    new = change.new.lines if change.new is not None else []
    return list(difflib.unified_diff(old, new, before, after, n=2, lineterm=""))


def size_of(change):
    lines = diff_of(change, "", "")[2:]
    added, removed = (sum(line.startswith(sign) for line in lines) for sign in "+-")
    return f"+{added} -{removed}"
