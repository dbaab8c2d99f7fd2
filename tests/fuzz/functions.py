#!/usr/bin/env python3
"""Every function that ODE exports is one that scripts call, or stands in not_drawn.txt with a reason.

functions.py LIBODE PLAYER OUR_HEADER

LIBODE is Debian's library, PLAYER the program odemt_fuzz_player, OUR_HEADER ode_MT.h.
"""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
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


def problems_of(functions, drawn, rows):
    """What is wrong with the list: each function is drawn, or excluded by one row."""
    problems = [f'{name} is drawn, but is no exported function' for name in sorted(drawn - functions)]
    excluded = set()
    for _, patterns in rows:
        found = []
        for pattern in patterns:
            names = sorted(name for name in functions if matches(name, pattern))
            if not names:
                problems.append(f'not_drawn.txt: "{pattern}" is no function')
            found += names
        for name in found:
            if name in drawn:
                problems.append(f'not_drawn.txt: {name} is drawn')
            if name in excluded:
                problems.append(f'not_drawn.txt: {name} stands there twice')
            excluded.add(name)
    problems += [f'{name} is neither drawn nor in not_drawn.txt' for name in sorted(functions - drawn - excluded)]
    return problems


def main(library, player, our_header):
    functions = {name for name in exported_symbols(library) if is_ode_name(name)} | set(functions_of(our_header))
    others = added_functions().keys() - functions  # a newer release has them, with which they are drawn
    functions |= others
    drawn = drawn_functions(player) | others
    problems = problems_of(functions, drawn, reasons())
    print('\n'.join(problems) or f'{len(functions)} functions, {len(drawn)} of them drawn')
    return 1 if problems else 0


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
