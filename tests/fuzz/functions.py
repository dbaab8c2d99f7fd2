#!/usr/bin/env python3
"""Every function that ODE exports is one that scripts call, or stands in not_drawn.txt with a reason.

functions.py LIBODE PLAYER OUR_HEADER [--write]

LIBODE is Debian's library, PLAYER the program odemt_fuzz_player, OUR_HEADER ode_MT.h. The table in docs/fuzzing.md has to be
that of not_drawn.txt; --write puts it there.
"""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
DOCUMENT = os.path.join(ROOT, 'docs', 'fuzzing.md')
BEGIN, END = '<!-- functions.py writes from here -->', '<!-- to here -->'
sys.path.insert(0, os.path.join(ROOT, 'tests', 'kept_state'))
from write_table import added_functions, exported_symbols, functions_of, matches  # noqa: E402


def is_ode_name(name):
    return len(name) > 1 and name[0] == 'd' and name[1].isupper()


def drawn_functions(player):
    """Those of ODE's: the player also has some of its own, such as `look`."""
    names = subprocess.run([player, '--functions'], check=True, capture_output=True, text=True).stdout.split()
    return {name for name in names if is_ode_name(name)}


def reasons():
    with open(os.path.join(HERE, 'not_drawn.txt'), encoding='utf-8') as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith('#')]
    return [(reason.strip(), names.split()) for reason, names in (line.split('|') for line in lines)]


def classify(functions, drawn, rows):
    """Returns for each row the functions that it excludes, and what is wrong."""
    problems = [f'{name} is drawn, but is no exported function' for name in sorted(drawn - functions)]
    excluded, reason_of = [], {}
    for reason, patterns in rows:
        found = []
        for pattern in patterns:
            names = sorted(name for name in functions if matches(name, pattern))
            if not names:
                problems.append(f'not_drawn.txt: "{pattern}" is no function')
            found += names
        for name in found:
            if name in drawn:
                problems.append(f'not_drawn.txt: {name} is drawn')
            if name in reason_of:
                problems.append(f'not_drawn.txt: {name} stands there twice')
            reason_of[name] = reason
        excluded.append(sorted(set(found)))
    problems += [f'{name} is neither drawn nor in not_drawn.txt' for name in sorted(functions - drawn - reason_of.keys())]
    return excluded, problems


def table(functions, drawn, rows, excluded):
    lines = [f'Of {len(functions)} functions that ODE and ODE_MT export scripts call {len(drawn)}. The others:', '',
             '| functions | why |', '|---|---|']
    for (reason, _), names in zip(rows, excluded):
        lines.append('| ' + ', '.join(f'`{name}`' for name in names) + f' | {reason} |')
    return '\n'.join(lines)


def main(library, player, our_header, *options):
    functions = {name for name in exported_symbols(library) if is_ode_name(name)} | set(functions_of(our_header))
    others = added_functions().keys() - functions  # a newer release has them, with which they are drawn
    functions |= others
    drawn, rows = drawn_functions(player) | others, reasons()
    excluded, problems = classify(functions, drawn, rows)
    if not problems:
        with open(DOCUMENT, encoding='utf-8') as file:
            text = file.read()
        before, rest = text.split(BEGIN)
        wanted = f'{before}{BEGIN}\n{table(functions, drawn, rows, excluded)}\n{END}{rest.split(END)[1]}'
        if '--write' in options:
            with open(DOCUMENT, 'w', encoding='utf-8') as file:
                file.write(wanted)
        elif wanted != text:
            problems.append('docs/fuzzing.md: the table of functions is another one; functions.py --write writes it')
    print('\n'.join(problems) or f'{len(functions)} functions, {len(drawn)} of them drawn')
    return 1 if problems else 0


if __name__ == '__main__':
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
