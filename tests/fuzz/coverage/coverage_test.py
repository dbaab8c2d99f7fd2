#!/usr/bin/env python3
"""libFuzzer finds no difference in some time, and its corpus reaches more of ode_mt/ than seeded scripts alone.

coverage_test.py ODEMT_FUZZ_COVERAGE ODEMT_FUZZ [--seconds S] [--seeds N] [--corpus FOLDER]

libFuzzer begins with the scripts of N seeds. It fails if a script differs, or if coverage does not grow: then counts of
children do not reach it, or nothing that it makes is of use.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile


def coverage_of(line):
    """Edges that were taken, and features: edges with how often."""
    return tuple(int(number) for number in re.search(r'cov: (\d+) ft: (\d+)', line).groups())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('coverage')
    parser.add_argument('fuzz')
    parser.add_argument('--seconds', type=int, default=60)
    parser.add_argument('--seeds', type=int, default=100)
    parser.add_argument('--corpus', help='folder that is kept')
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        corpus = options.corpus or os.path.join(scratch, 'corpus')
        seeds = os.path.join(scratch, 'seeds')
        os.makedirs(corpus, exist_ok=True)
        subprocess.run([options.fuzz, '--write', seeds, '--scripts', str(options.seeds)], check=True)
        run = subprocess.run([options.coverage, f'-max_total_time={options.seconds}', '-seed=1', '-print_final_stats=1',
                              f'-artifact_prefix={scratch}/', f'--keep={scratch}', corpus, seeds],
                             stderr=subprocess.PIPE, text=True, errors='replace')
        print(run.stderr)
        if run.returncode != 0:
            return 1
        begun = [line for line in run.stderr.splitlines() if '\tINITED' in line]
        ended = [line for line in run.stderr.splitlines() if '\tDONE' in line]
        if not begun or not ended:
            print('libFuzzer has reported no coverage')
            return 1
        (edges, features), (edges_then, features_then) = coverage_of(begun[0]), coverage_of(ended[0])
        print(f'{options.seeds} seeds reach {edges} edges, {features} features; after {options.seconds} s '
              f'{edges_then} and {features_then}')
        return 0 if edges > 0 and edges_then > edges and features_then > features else 1


if __name__ == '__main__':
    sys.exit(main())
