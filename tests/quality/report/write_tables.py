#!/usr/bin/env python3
"""Writes the tables of docs/solvers.md anew from its data: write_tables.py DATA DOCUMENT

Between <!-- NAME --> and <!-- end NAME -->, where NAME is residuals, world or closed.
"""
import csv
import pathlib
import re
import sys

DATA, DOCUMENT = map(pathlib.Path, sys.argv[1:3])


def rows_of(name):
    with open(DATA / f"solvers-{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def table(header, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [header, ["---"] * len(header)] + rows)


def short(text):
    return f"{float(text):.3g}"


def residuals():
    """At 20 iterations: both norms, and the time of a step."""
    found = {(row["scene"], row["engine"]): row for row in rows_of("residuals") if row["iterations"] == "20"}
    lines = []
    for scene in dict.fromkeys(scene for scene, _ in found):
        def pair(engine):
            row = found[scene, engine]
            return f"{short(row['worst'])} / {short(row['energy'])}"
        times = [short(found[scene, engine]["step_ms"]) for engine in ("libode8", "exact", "fast")]
        lines.append([f"`{scene}`", pair("libode8"), pair("fast"), pair("libode8_same"), pair("fast_own"), *times])
    return table(["", "`libode8`", "`fast`, cold", "`libode8` on the problems of `fast`", "`fast`", "`libode8`, ms", "`exact`, ms", "`fast`, ms"], lines)


def world():
    lines = [[f"`{row['scene']}`", row["rows"], *(short(row[f"{engine}_ms"]) for engine in ("libode8", "exact", "fast")),
              short(float(row["libode8_ms"]) / float(row["fast_ms"])), f"{float(row['difference']):.0e}"] for row in rows_of("world")]
    return table(["", "rows", "`libode8`, ms", "`exact`, ms", "`fast`, ms", "`libode8` / `fast`", "difference of velocities"], lines)


def closed():
    lines = [[row["experiment"].replace("_", " "), row["quantity"] + (f", {row['unit']}" if row["unit"] else ""), short(row["libode8"]),
              f"{short(row['least'])} to {short(row['most'])}", short(row["fast"]), f"{short(row['fast_least'])} to {short(row['fast_most'])}",
              short(row["libode8_200"])] for row in rows_of("closed")]
    return table(["experiment", "error", "`libode8`", "range", "`fast`", "range", "`libode8`, 200 iterations"], lines)


text = DOCUMENT.read_text()
for name, made in {"residuals": residuals(), "world": world(), "closed": closed()}.items():
    text, count = re.subn(rf"(<!-- {name} -->\n).*?(<!-- end {name} -->)", lambda match: match[1] + made + "\n" + match[2], text, flags=re.S)
    if count != 1:
        sys.exit(f"{DOCUMENT} has no place for the table {name}")
DOCUMENT.write_text(text)
