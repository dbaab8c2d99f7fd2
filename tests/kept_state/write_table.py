#!/usr/bin/env python3
"""Writes the page of kept state, which the site has, from the files in table/, and refuses tables that are not complete.

write_table.py LIBODE HEADERS CALLS SCENARIOS PAGE

LIBODE is Debian's library, HEADERS the folder of upstream's public headers, CALLS the program every_call and SCENARIOS
the program odemt_scenario. PAGE is the file to write.
"""
import fnmatch
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
problems = []


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def rows(name, separator='|'):
    with open(os.path.join(HERE, 'table', name), encoding='utf-8') as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith('#')]
    return [[cell.strip() for cell in line.split(separator)] for line in lines]


def exported_symbols(library):
    """The C symbols, without those of C++."""
    names = {line.split()[2].split('@')[0] for line in output('nm', '-D', '--defined-only', library).splitlines()}
    return {name for name in names if not name.startswith('_Z')}


def functions_of(header):
    """Public functions, as declared in a header."""
    with open(header, encoding='latin-1') as file:
        text = re.sub(r'//.*', '', re.sub(r'/\*.*?\*/', '', file.read(), flags=re.S))
    text = re.sub(r'^\s*#.*', '', text, flags=re.M)
    return re.findall(r'ODE_API\b[^;{(]*?\b(d\w+)\s*\([^;{]*;', text)


def header_of_functions(folder):
    """Upstream's public functions, and the header of each."""
    headers = {}
    for header in sorted(os.listdir(folder)):
        if header.endswith('.h') and header != 'ode_MT.h':
            for name in functions_of(os.path.join(folder, header)):
                headers.setdefault(name, header)
    return headers


def added_functions():
    """Public functions that a release of ode/releases/ added, and the header of each. The tables have them, whatever release is built."""
    headers = {}
    for release in sorted(os.listdir(os.path.join(ROOT, 'ode', 'releases'))):
        path = os.path.join(ROOT, 'ode', 'releases', release, 'new_functions.txt')
        if os.path.exists(path):
            with open(path, encoding='utf-8') as file:
                headers.update(reversed(line.split()) for line in file if line.strip() and not line.startswith('#'))
    return headers


def matches(name, pattern):
    """A pattern may except others: dGeomGet*!dGeomGetAABB."""
    wanted, *others = pattern.split('!')
    return fnmatch.fnmatchcase(name, wanted) and not any(fnmatch.fnmatchcase(name, other) for other in others)


def facts_of_functions(functions, facts):
    """The facts that each function changes; each function must be in one row."""
    result = {}
    for row in rows('functions.txt', ':'):
        changed = [] if row[0] == '-' else [fact.strip() for fact in row[0].split(',')]
        for fact in changed:
            if fact not in facts:
                problems.append(f'functions.txt: no fact "{fact}"')
        for pattern in row[1].split():
            found = [name for name in functions if matches(name, pattern)]
            if not found:
                problems.append(f'functions.txt: "{pattern}" is no function')
            for name in found:
                if name in result:
                    problems.append(f'functions.txt: {name} is listed twice')
                result[name] = changed
    problems.extend(f'functions.txt: {name} is missing' for name in sorted(functions - result.keys()))
    return result


class Tests:
    def __init__(self, calls, scenarios):
        self.calls = set(output(calls, '--functions').split())
        names = [line.split('\t')[0] for line in output(scenarios, '--list').splitlines()]
        self.scenarios = {re.sub(r'/(quick|world)$', '', name) for name in names}

    def check(self, where, names):
        if not names:
            problems.append(f'{where}: no test')
        for name in names:
            kind, _, rest = name.partition(':')
            exists = (kind == 'call' or kind == 'scenario' and rest in self.scenarios or
                      kind == 'gtest' and os.path.exists(os.path.join(ROOT, 'tests', rest + '.cpp')))
            if not exists:
                problems.append(f'{where}: no test "{name}"')


def shown(test):
    kind, _, rest = test.partition(':')
    return {'call': 'call test', 'scenario': f'`{rest}`', 'gtest': f'`tests/{rest}.cpp`'}[kind]


def table(head, lines):
    return ['| ' + ' | '.join(head) + ' |', '|' + '---|' * len(head)] + ['| ' + ' | '.join(line) + ' |' for line in lines]


INTRODUCTION = '''# What is kept from call to call, and how it is notified of changes

This page is for developers who add a function, or state that is kept from call to call.

ODE computes nearly everything anew in each call. This library keeps results from one call to the next: pairs of a space,
boxes, ranks, contacts of callbacks that are still to come. What is kept depends on *facts*, such as where a geom is, and
nearly every function of ODE's may change a fact. A result whose fact changed without a notification is wrong from then on.
So each fact is listed here with the functions that change it, and each piece of kept state with the facts it depends on,
what notifies it, and the tests that verify it. If you add a function or keep something new, add its row.

`tests/kept_state/write_table.py` writes this page from `tests/kept_state/table/`. The test `kept_state.table` fails if a
function that Debian's library exports is missing or listed twice, if a row has no test, or if a test does not exist.

*Call test* is `kept_state.every_call`: it calls every exported function on live objects, between frames, between collision
and step, twice, undone, before the end, and in every kind of code that a program gives to ODE (callbacks, functions of
classes, handlers, allocators, a thread's end), where upstream survives it, in spaces of all kinds. It compares the three
frames that follow with Debian's library (serial, two threads, clusters). `every_call --show CASE` prints the results of a
case on the library that the loader finds.
'''


def document(functions, headers, facts, states, notified, user_code):
    lines = [INTRODUCTION, '## Facts, and the functions that change them', '']
    meanings = {fact: meaning for fact, meaning in facts}
    for fact, meaning in facts:
        by_header = {}
        for name in sorted(functions):
            if fact in functions[name]:
                by_header.setdefault(headers.get(name, 'no header'), []).append(name)
        lines += [f'**{fact}**: {meanings[fact]}.', '']
        lines += [f'* {header}: ' + ', '.join(f'`{name}`' for name in names) for header, names in sorted(by_header.items())]
        lines += [''] if by_header else ['* changed by no call', '']
    lines += ['## Kept state, and the facts it depends on', '']
    for state, where, meaning in states:
        lines += [f'### {state}', '', f'{meaning[0].upper() + meaning[1:]} (`{where}`).', '']
        lines += table(['fact', 'notified by', 'tests'],
                       [[row[1], row[2], ', '.join(shown(test) for test in row[3].split())] for row in notified if row[0] == state])
        lines += ['']
    lines += ['## Where the user\'s code runs', '', 'What is held while it runs, and what happens if it calls an exported '
              'function, leaves by an exception or a jump, or ends its thread or the process.', '']
    lines += table(['code', 'held', 'calls a function', 'throws, jumps', 'ends thread or process', 'tests'],
                   [row[:5] + [', '.join(shown(test) for test in row[5].split())] for row in user_code])
    count = sum(1 for name in functions if not functions[name])
    lines += ['', '## Functions that change no fact', '', f'{count} functions, by header:', '']
    by_header = {}
    for name in sorted(functions):
        if not functions[name]:
            by_header.setdefault(headers.get(name, 'no header'), []).append(name)
    lines += [f'* {header}: ' + ', '.join(f'`{name}`' for name in names) for header, names in sorted(by_header.items())]
    return '\n'.join(lines) + '\n'


def main(library, header_folder, calls, scenarios, page):
    listed = {name for row in rows('internals.txt', ' ') for name in row}
    internals = {name.lstrip('?') for name in listed}
    symbols = exported_symbols(library)
    added = added_functions()
    headers = {**added, **header_of_functions(header_folder)}
    problems.extend(f'internals.txt: {name} is not exported' for name in sorted(listed - symbols) if not name.startswith('?'))
    problems.extend(f'internals.txt: {name} is in {headers[name]}' for name in sorted(internals & headers.keys()))
    names = symbols - internals
    facts = rows('facts.txt')
    functions = facts_of_functions(names | added.keys(), {fact for fact, _ in facts})
    tests = Tests(calls, scenarios)
    problems.extend(f'every_call does not call {name}' for name in sorted(names - tests.calls))
    states, notified, user_code = rows('states.txt'), rows('notified.txt'), rows('user_code.txt')
    for state, where, _ in states:
        if not os.path.exists(os.path.join(ROOT, where)):
            problems.append(f'states.txt: no file {where}')
        if state not in {row[0] for row in notified}:
            problems.append(f'notified.txt: nothing about "{state}"')
    known = {fact for fact, _ in facts}
    problems.extend(f'notified.txt: fact "{fact}" reaches no state' for fact in sorted(known - {row[1] for row in notified}))
    for row in notified:
        if row[0] not in {state for state, _, _ in states} or row[1] not in known:
            problems.append(f'notified.txt: "{row[0]}" or "{row[1]}" is unknown')
        tests.check(f'notified.txt: {row[0]}, {row[1]}', row[3].split())
    for row in user_code:
        if len(row) != 6:
            problems.append(f'user_code.txt: "{row[0]}" has {len(row)} cells')
        tests.check(f'user_code.txt: {row[0]}', row[-1].split())
    if not problems:
        os.makedirs(os.path.dirname(page), exist_ok=True)
        with open(page, 'w', encoding='utf-8') as file:
            file.write(document(functions, headers, facts, states, notified, user_code))
    print('\n'.join(problems) or f'{len(functions)} functions, {len(states)} pieces of state, {len(notified)} rows, '
          f'{len(user_code)} places of user code')
    return 1 if problems else 0


if __name__ == '__main__':
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
