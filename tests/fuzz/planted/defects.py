"""The table of planted defects, checked against the source.

`defects.py` alone fails and names the rows whose text does not stand in its file exactly once, or changes nothing.
"""
import dataclasses
import os
import sys
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
FEWEST = 12


@dataclasses.dataclass
class Defect:
    name: str
    part: str
    breaks: str
    file: str
    old: str
    new: str

    def planted(self, source):
        """The text of the file with the defect in it."""
        return source.replace(self.old, self.new)


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def defects():
    with open(os.path.join(HERE, 'defects.toml'), 'rb') as file:
        return [Defect(**row) for row in tomllib.load(file)['defect']]


def problems(rows, root):
    found = []
    if len(rows) < FEWEST:
        found.append(f'{len(rows)} defects, fewer than {FEWEST}')
    names = [row.name for row in rows]
    found += [f'"{name}" stands twice' for name in sorted(set(names)) if names.count(name) > 1]
    for row in rows:
        path = os.path.join(root, row.file)
        if not os.path.exists(path):
            found.append(f'"{row.name}": no file {row.file}')
            continue
        count = read(path).count(row.old)
        if count != 1:
            found.append(f'"{row.name}": its text stands {count} times in {row.file}')
        if row.old.split() == row.new.split():
            found.append(f'"{row.name}": changes nothing')
    return found


if __name__ == '__main__':
    all_problems = problems(defects(), ROOT)
    print('\n'.join(all_problems) or f'{len(defects())} defects, each with its place in the source')
    sys.exit(bool(all_problems))
