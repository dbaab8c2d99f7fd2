#!/usr/bin/env python3
"""One page of all that odemt_report needs, before data is put into it.

    bundle.py --esbuild PROGRAM --three FOLDER --chart FOLDER --licence NAME=FILE... --output PAGE.cpp

Joins page/main.js and what it imports with three.js and Chart.js (whose unused parts are left out), puts script, style and licences
into page/page.html, and writes the result as a string of C++.
"""
import argparse
import html
import pathlib
import subprocess

SOURCES = pathlib.Path(__file__).resolve().parent / "page"
DELIMITER = "page"  # of the raw string


def script_of(options):
    command = [options.esbuild, str(SOURCES / "main.js"), "--bundle", "--minify", "--format=iife", "--target=es2020", "--charset=utf8",
               "--legal-comments=none", "--log-level=warning",
               f"--alias:three={options.three / 'three.module.js'}",
               f"--alias:three-controls={options.three / 'examples/jsm/controls/OrbitControls.js'}",
               f"--alias:chart.js={options.chart / 'chart.esm.js'}"]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout


def licences(files):
    texts = []
    for entry in files:
        name, file = entry.split("=", 1)
        texts.append(f"==== {name} ====\n\n{pathlib.Path(file).read_text(encoding='utf-8')}")
    return html.escape("\n\n".join(texts))


def page_of(options):
    parts = {"style": (SOURCES / "page.css").read_text(), "script": script_of(options), "licences": licences(options.licence)}
    page = (SOURCES / "page.html").read_text()
    for name, text in parts.items():
        placeholder = "{{" + name + "}}"
        if page.count(placeholder) != 1:
            raise SystemExit(f"page.html has not one {placeholder}")
        page = page.replace(placeholder, text)
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--esbuild", required=True)
    parser.add_argument("--three", type=pathlib.Path, required=True)
    parser.add_argument("--chart", type=pathlib.Path, required=True)
    parser.add_argument("--licence", action="append", default=[])
    parser.add_argument("--output", type=pathlib.Path, required=True)
    options = parser.parse_args()
    page = page_of(options)
    if f"){DELIMITER}\"" in page:
        raise SystemExit("the page holds the end of a raw string")
    options.output.write_text(f'#include "report/page.h"\n\nconst char *const report::kEmptyPage = R"{DELIMITER}({page}){DELIMITER}";\n',
                              encoding="utf-8")


if __name__ == "__main__":
    main()
