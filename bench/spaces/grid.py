#!/usr/bin/env python3
"""Spaces of all kinds against libode8, over a grid of scenes: grid.py CELL_PROGRAM STOCK_FOLDER OUR_FOLDER [--csv FILE] [--quick] [--check]

Each cell of the grid is a space of N geoms with a given overlap, some of which move before each call (space_cell.cpp). Both
engines run its calls in turns, on one core, since two may not be equally fast, and the ratio is the median of those of adjacent turns: 2 means that
ours takes half of the time. Prints a table of ratios, and the cells below 0.9. Ends with 1 if callbacks differ.
"""
import argparse
import csv
import itertools
import os
import statistics
import subprocess
import sys

KINDS = ["simple", "hash", "sweep and prune", "quad tree"]
FIELDS = ["kind", "geoms", "crowding", "moved", "motion", "filter", "rays", "nested", "queries", "askers"]
TURNS = 5
TURN_US = 5000  # of calls in a turn, about
MOST_PAIRS = 700_000


class Engine:
    def __init__(self, program, folder):
        environment = dict(os.environ, LD_LIBRARY_PATH=folder, ODE_MT_THREADS="0")
        self.process = subprocess.Popen([program], env=environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def run(self, cell, calls):
        print(*cell, calls, file=self.process.stdin, flush=True)
        time, callbacks, digest = self.process.stdout.readline().split()
        return float(time), (int(callbacks), digest)


GEOMS = (4, 12, 40, 120, 400, 1200, 3000)
MOVED = (0, -1, 100, 500, 1000)


def is_wanted(cell):
    kind, geoms, crowding, moved, motion, bits, rays, nested, queries, askers = cell
    overlapping = geoms if crowding < 0 else min(crowding, geoms)
    if not queries and geoms * overlapping / 2 > MOST_PAIRS or crowding > geoms // 2:
        return False
    return not (moved == 0 and motion == 1) and not (nested and (bits or rays))


def cells(quick):
    collided = itertools.product(range(4), GEOMS, (0, 6, 40, -1), MOVED, (0, 1), (0, 1), (0, 50, 90), (0, 4), (0,), (0,))
    in_turns = itertools.product(range(4), GEOMS, (0, 6, 40), (1000,), (2,), (0,), (0,), (0,), (0,), (0,))
    switched = itertools.product(range(4), GEOMS, (0, 6, 40), (0, -1), (0,), (2,), (0,), (0,), (0,), (0,))
    queried = itertools.product(range(4), GEOMS, (0, 6), MOVED, (0,), (0,), (0,), (0, 4), (1, 50, 1000), (0,))
    asked = itertools.product(range(4), GEOMS, (0, 6), (0, -1, 1000), (0,), (0,), (0,), (0, 4), (8, 50), (1, 2))
    for cell in filter(is_wanted, itertools.chain(collided, in_turns, switched, queried, asked)):
        if quick and hash(cell) % 16 != 0:
            continue
        yield cell


def compare(engines, cell):
    first = [engine.run(cell, 12) for engine in engines]
    return first, first[0][1] == first[1][1]


def measure(engines, cell):
    first, agree = compare(engines, cell)
    calls = int(max(3, min(400, TURN_US / max(first[0][0], 0.1))))
    calls = max(calls, 8)
    for engine in engines:
        engine.run(cell, calls)  # what is kept has settled
    pairs = []
    for turn in range(TURNS):
        order = (0, 1) if turn % 2 == 0 else (1, 0)
        times = {which: engines[which].run(cell, calls)[0] for which in order}
        pairs.append((times[0], times[1]))
    stock, ours = sorted(pairs, key=lambda pair: pair[0] / pair[1])[TURNS // 2]
    return stock, ours, first[0][1][0], agree


def print_table(rows):
    print("| space | geoms | cells | median | worst | below 0.9 | queries: cells | median | worst | below 0.9 |\n" + "|---" * 10 + "|")
    for (kind, name), geoms in itertools.product(enumerate(KINDS), GEOMS):
        columns = []
        for is_queried in (False, True):
            ratios = [row["ratio"] for row in rows if (row["kind"], row["geoms"], row["queries"] != 0) == (kind, geoms, is_queried)]
            columns += [len(ratios), f"{statistics.median(ratios):.2f}", f"{min(ratios):.2f}", sum(ratio < 0.9 for ratio in ratios)] if ratios else [""] * 4
        if any(column != "" for column in columns):
            print("|", " | ".join(map(str, [name, geoms] + columns)), "|")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("stock")
    parser.add_argument("ours")
    parser.add_argument("--csv")
    parser.add_argument("--quick", action="store_true", help="one cell of sixteen")
    parser.add_argument("--check", action="store_true", help="compare callbacks alone")
    parser.add_argument("--only", help="a Python expression of the fields, such as 'kind == 1 and geoms > 40'")
    options = parser.parse_args()
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    engines = [Engine(options.program, options.stock), Engine(options.program, options.ours)]
    rows, differing = [], []
    for cell in cells(options.quick):
        named = dict(zip(FIELDS, cell))
        if options.only and not eval(options.only, {}, named):
            continue
        if options.check:
            _, agree = compare(engines, cell)
            rows.append({**named, "ratio": 1})
            if not agree:
                differing.append(cell)
            continue
        stock, ours, callbacks, agree = measure(engines, cell)
        rows.append({**named, "callbacks": callbacks, "stock_us": stock, "ours_us": ours, "ratio": round(stock / ours, 3)})
        if not agree:
            differing.append(cell)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, rows[0])
            writer.writeheader()
            writer.writerows(rows)
    if options.check:
        print(f"{len(rows)} cells, callbacks of {len(differing)} differ")
    if not options.check:
        print_table(rows)
    for row in sorted(rows, key=lambda row: row["ratio"])[:40]:
        if row["ratio"] < 0.9:
            print(*(f"{name} {value}" for name, value in row.items()), sep=", ")
    for cell in differing:
        print("callbacks differ:", *(f"{name} {value}" for name, value in zip(FIELDS, cell)))
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
