#!/usr/bin/env python3
"""Measures what docs/solvers.md shows: residuals over iterations and time, the same solution, and what becomes of scenes.

    measure.py PROGRAM LIBODE8 ODE_MT OUTPUT

PROGRAM: odemt_quality; LIBODE8, ODE_MT: folders of the two libraries; OUTPUT: folder of solvers-residuals.csv, solvers-world.csv and
solvers-closed.csv. All engines have one thread.
"""
import csv
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

PROGRAM, LIBODE8, ODE_MT, OUTPUT = sys.argv[1:5]
ITERATIONS = [2, 4, 6, 8, 10, 12, 16, 20, 30, 40, 60, 100, 200]
DEFAULT = 20
NEAR = (18, 19, 20, 21, 22)
REPEATS = 3  # of a dWorldStep, of which the fastest counts
# Name and frames before the first problem.
QUICK_SCENES = [("pile:1000", 150), ("stacks:40", 100), ("wall:8", 60), ("spheres:1000", 200)]
WORLD_SCENES = [("wall:6", 60), ("pile:200", 200), ("stacks:10", 100), ("spheres:200", 200), ("humanoids:22", 60), ("ragdolls:20", 100),
                ("chain:250", 20), ("bridge", 60)]
ENGINES = {"libode8": (LIBODE8, ""), "exact": (ODE_MT, "exact"), "fast": (ODE_MT, "fast")}


def ask(engine, *arguments):
    folder, solver = ENGINES[engine]
    variables = {key: value for key, value in os.environ.items() if not key.startswith("ODE_MT_")}
    variables.update(LD_LIBRARY_PATH=folder, ODE_MT_THREADS="0", ODE_MT_SOLVER=solver or "exact")
    command = [PROGRAM, *map(str, arguments)]
    return json.loads(subprocess.run(command, env=variables, check=True, capture_output=True, text=True).stdout)


def mean_square_root(numbers):
    return math.sqrt(statistics.fmean(number * number for number in numbers))


def norms(steps):
    return [mean_square_root([step["worst"] for step in steps]), mean_square_root([math.sqrt(step["energy"]) for step in steps])]


def write(name, header, rows):
    with open(pathlib.Path(OUTPUT) / name, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header] + [[f"{x:.6g}" if isinstance(x, float) else x for x in row] for row in rows])


def residuals(folder):
    """Engine "fast_own": the problems of its own run, whose steps begin with the forces of the last one; "libode8_same": libode8 on those."""
    rows = []
    listed = ",".join(map(str, ITERATIONS))
    for scene, frames in QUICK_SCENES:
        problems, own = f"{folder}/problems", f"{folder}/own"
        ask("libode8", "run", scene, "--frames", frames, "--problems", 6, "--iterations", DEFAULT, "--save", problems)
        cold = {engine: {replay["iterations"]: norms(replay["steps"]) for replay in ask(engine, "replay", scene, problems, "--iterations", listed)["replays"]}
                for engine in ENGINES}
        for iterations in ITERATIONS:
            for engine in ENGINES:
                run = ask(engine, "run", scene, "--frames", frames, "--problems", 6, "--iterations", iterations, "--save", own)
                milliseconds = 1000 * min(run["seconds"])  # other programs disturb the others
                rows.append([scene, engine, iterations, milliseconds, *cold[engine][iterations]])
                if engine != "fast":
                    continue
                rows.append([scene, "fast_own", iterations, milliseconds, *norms(run["steps"])])
                same = ask("libode8", "replay", scene, own, "--iterations", iterations)["replays"][0]["steps"]
                rows.append([scene, "libode8_same", iterations, milliseconds, *norms(same)])
    write("solvers-residuals.csv", ["scene", "engine", "iterations", "step_ms", "worst", "energy"], rows)


def world_steps(folder):
    rows = []
    for scene, frames in WORLD_SCENES:
        problems = f"{folder}/problems"
        ask("libode8", "run", scene, "--frames", frames, "--problems", 3, "--save", problems)
        solved = {engine: [ask(engine, "replay", scene, problems, "--world", "--velocities", "--warm-up")["replays"][0]["steps"] for _ in range(REPEATS)]
                  for engine in ENGINES}
        difference = max(max(abs(a - b) for a, b in zip(ours["velocities"], theirs["velocities"])) / theirs["change"]
                         for ours, theirs in zip(solved["fast"][0], solved["libode8"][0]))
        milliseconds = [1000 * statistics.median(min(times) for times in zip(*([step["seconds"] for step in steps] for steps in solved[engine])))
                        for engine in ENGINES]
        rows.append([scene, solved["fast"][0][0]["rows"], *milliseconds, difference])
    write("solvers-world.csv", ["scene", "rows"] + [f"{engine}_ms" for engine in ENGINES] + ["difference"], rows)


def experiments():
    quick = {iterations: ask("libode8", "measure", "--iterations", iterations)["experiments"] for iterations in (*NEAR, 200)}
    near = {iterations: ask("fast", "measure", "--iterations", iterations)["experiments"] for iterations in NEAR}
    fast = near[DEFAULT]
    right = [name for name, quantities in fast.items() if any(quantity["reference"] for quantity in quantities.values())]
    references = ask("libode8", "measure", "--world", *right)["experiments"]
    rows = []
    for experiment, quantities in fast.items():
        for name, quantity in quantities.items():
            def error(measured):
                value = measured[experiment][name]["value"]
                return abs(value - references[experiment][name]["value"]) if quantity["reference"] else value
            theirs, ours = ([error(measured[iterations]) for iterations in NEAR] for measured in (quick, near))
            numbers = [statistics.median(theirs), min(theirs), max(theirs), statistics.median(ours), min(ours), max(ours), error(quick[200]),
                       quantity["slack"]]
            rows.append([experiment, name, quantity["unit"], *map(float, numbers)])
    write("solvers-closed.csv", ["experiment", "quantity", "unit", "libode8", "least", "most", "fast", "fast_least", "fast_most", "libode8_200", "slack"], rows)


def main():
    with tempfile.TemporaryDirectory() as folder:
        experiments()
        residuals(folder)
        world_steps(folder)


main()
