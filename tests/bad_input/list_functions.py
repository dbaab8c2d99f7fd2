#!/usr/bin/env python3
"""Writes a C++ list of the functions that headers declare, with their types, for bad_calls.h.

    list_functions.py OUTPUT HEADER...

So none is forgotten. Those with a variable number of arguments are excluded: they report what they are
given.
"""
import pathlib
import re
import sys

LEFT_OUT = {
    'dGeomTriMeshDataGet': 'is declared, and not defined',
    'dJointAddPUTorque': 'is declared, and not defined',
    'dThreadingAllocateThreadPool': 'starts as many threads as requested',
}


def prototypes(header):
    text = header.read_text(encoding='latin-1')
    text = re.sub(r'//.*', '', re.sub(r'/\*.*?\*/', '', text, flags=re.S))
    text = re.sub(r'^\s*#.*(\\\n.*)*', '', text, flags=re.M)
    for result, name, parameters in re.findall(r'ODE_API\b([^;{(]*?)\b(d\w+)\s*\(([^;{]*)\)\s*;', text):
        yield ' '.join(result.split()), name, ' '.join(parameters.split())


def main(output, *headers):
    lines, seen = ['// Written by list_functions.py.', '#define BAD_INPUT_FUNCTIONS(ADD) \\'], set()
    for header in map(pathlib.Path, headers):
        for result, name, parameters in prototypes(header):
            if name in seen or name in LEFT_OUT or '...' in parameters:
                continue
            seen.add(name)
            lines.append(f'    ADD("{name}", (static_cast<{result} (*)({parameters})>({name}))) \\')
    pathlib.Path(output).write_text('\n'.join(lines) + '\n\n')


if __name__ == '__main__':
    main(*sys.argv[1:])
