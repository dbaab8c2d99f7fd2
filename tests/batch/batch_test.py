#!/usr/bin/env python3
"""Tests of odemt_batch as its users see it (docs/tools.md).

    batch_test.py PROGRAM SCRATCH CASE...

CASE: expansion, bad_plans, unknown_names, parameters, same_table, kills, faults, sample PAGE; ranks and ranks_kills MPIEXEC need MPI.
KILLS=20 in the environment: 20 kills instead of the few that take seconds.
"""
import glob
import json
import os
import pathlib
import random
import signal
import sqlite3
import subprocess
import sys
import time

PROGRAM, SCRATCH = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
SMALL = {
    'worlds': 'stacks:${stacks}',
    'parameters': {'gravity': [-9.81, -3.7], 'stacks': [1, 2]},
    'seeds': {'from': 1, 'count': 6},
    'frames': 30,
    'perturbation': {'velocity': 0.1},
    'observables': {'x': 'body[0].position.x', 'lowest': 'min body[0].height', 'contacts': 'mean contacts'},
    'series': {'every': 10, 'observables': 'x', 'states': True},
}
SAME = ['plan', 'runs', 'series', 'states']  # the tables that are the same in every run


def write_plan(plan, name='plan'):
    file = SCRATCH / f'{name}.json'
    file.write_text(plan if isinstance(plan, str) else json.dumps(plan))
    return str(file)


def run(*arguments, before=(), timeout=100):
    return subprocess.run([*before, PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=timeout)


def fresh(name):
    for file in SCRATCH.glob(name + '.sqlite*'):
        file.unlink()
    return str(SCRATCH / f'{name}.sqlite')


def table(file):
    """All rows that must be the same."""
    with sqlite3.connect(file) as database:
        return {name: database.execute(f'SELECT * FROM {name}').fetchall() for name in SAME}


def batch(plan, name, *options, before=()):
    file = fresh(name)
    done = run(write_plan(plan, name), '-o', file, '--quiet', *options, before=before)
    assert done.returncode == 0, done.stderr
    return table(file)


def listed(plan):
    done = run(write_plan(plan), '--list')
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def expansion():
    runs = listed({'worlds': ['chain:3', 'chain:4'], 'frames': 1, 'seeds': [7, 8],
                   'parameters': {'erp': {'from': 0.1, 'to': 0.3, 'step': 0.1}, 'iterations': [5, 6]}})
    assert [line['run'] for line in runs] == list(range(24)), runs
    assert [line['seed'] for line in runs[:4]] == [7, 8, 7, 8], runs
    assert [line['iterations'] for line in runs[:6]] == [5, 5, 6, 6, 5, 5], runs
    assert [line['world'] for line in runs[::12]] == ['chain:3', 'chain:4'], runs
    assert [round(line['erp'], 12) for line in runs[:12:4]] == [0.1, 0.2, 0.3], runs
    runs = listed({'worlds': 'chain:3', 'frames': 1, 'expand': 'list', 'parameters': {'erp': [0.1, 0.2], 'cfm': [1, 2]}})
    assert [(line['erp'], line['cfm'], line['seed']) for line in runs] == [(0.1, 1, 1), (0.2, 2, 1)], runs


def bad_plans():
    good = {'worlds': 'chain:3', 'frames': 1}
    cases = [
        ('{', 'not JSON'), ('[]', 'not a JSON object'), ({'frames': 1}, 'worlds: there are none'), ({**good, 'seed': 1}, 'seed: unknown key'),
        ({**good, 'worlds': 'chian:3'}, "'chian:3'"), ({**good, 'worlds': []}, 'worlds: the list is empty'), ({**good, 'frames': 0}, 'frames:'),
        ({**good, 'seconds': 1}, 'frames: one of'), ({**good, 'frames': 1.5}, "'1.5' is not a whole number"), ({**good, 'frames': 1e10}, 'frames:'), ({**good, 'parameters': {'gravty': 1}}, 'parameters.gravty: unknown'),
        ({**good, 'parameters': {'erp': 2}}, 'parameters.erp:'), ({**good, 'parameters': {'iterations': 1.5}}, 'parameters.iterations:'),
        ({**good, 'parameters': {'erp': {'from': 0, 'to': 1}}}, "parameters.erp: a range has no 'step'"),
        ({**good, 'parameters': {'erp': {'from': 0, 'to': 1, 'step': -1}}}, 'parameters.erp: a step'),
        ({**good, 'parameters': {'/sdf/world/a': 1}}, 'parameters./sdf/world/a:'), ({**good, 'parameters': {'Run': 1}}, 'parameters.Run:'),
        ({**good, 'expand': 'all'}, 'expand:'), ({**good, 'seeds': -1}, 'seeds:'), ({**good, 'seeds': {'from': 1}}, 'seeds:'),
        ({**good, 'expand': 'list', 'parameters': {'erp': [0.1, 0.2], 'cfm': 1}}, 'parameters.cfm:'),
        ({**good, 'observables': {'a': 'hight'}}, 'observables.a:'), ({**good, 'observables': {'time': 'energy'}}, 'observables.time:'),
        ({**good, 'series': {'every': 1, 'observables': 'a'}}, 'series.observables:'), ({**good, 'perturbation': {'velocity': -1}}, 'perturbation.velocity:'),
        ({**good, 'observables': {'a': 'energy'}, 'series': {'every': 1, 'observables': ['a', 'a']}}, "series.observables: 'a' is there twice"),
        ({**good, 'observables': {'Frame': 'energy'}, 'series': {'every': 1, 'observables': 'Frame'}}, "series.observables: 'Frame' is the name"),
        ({**good, 'observables': {'a': 'energy', 'A': 'energy'}}, 'observables.A: there is a column'), ({**good, 'observables': {'a\0b': 'energy'}}, 'null character'),
        ('{"worlds": "chain:3", "frames": 1, "frames": 2}', 'frames: the key is there twice'),
        ('{"worlds": "chain:3", "frames": 1, "observables": {"a": "energy", "a": "awake"}}', 'observables.a: the key is there twice'),
        ('{"worlds": ' + 100000 * '[' + 100000 * ']' + '}', 'worlds: is nested more than'),
    ]
    for plan, words in cases:
        done = run(write_plan(plan), '--list')
        assert done.returncode == 1 and words in done.stderr, (plan, words, done.returncode, done.stderr)
    done = run(SCRATCH / 'none.json')
    assert done.returncode == 1 and 'none.json' in done.stderr, done.stderr
    assert run(write_plan(good), '--wrong').returncode == 2
    done = run('.', '-o', fresh('folder'))
    assert done.returncode == 1 and '.: is a folder' in done.stderr, done.stderr


def unknown_names():
    """What the first run's world has not ends the batch before that run, and leaves no file."""
    good = {'worlds': ['chain:3'], 'frames': 1, 'seeds': [1, 2]}
    cases = [(good['worlds'], name, 'plan: observables.o: there is no ' + words) for name, words in (
        ('body[99].position.x', 'body[99]: the world has'), ('body[-1].height', "body 'body[-1]'"), ('nosuch::link.height', "body 'nosuch::link'"),
        ('reading[0]', 'reading[0]: the world has 0'), ('max reading[999]', 'reading[999]: the world has 0'))]
    cases += [(['stacks:1'], 'joint[0].angle', 'joint[0]: the world has 0'), (['stacks:1'], 'a::b.rate', "joint 'a::b'"),
              (['chain:30', 'chain:3'], 'body[20].height', "body[20]: the world has"), (['epuck'], 'reading[0]', 'reading[0]')]
    for worlds, observable, words in cases:
        file = fresh('unknown')
        done = run(write_plan({**good, 'worlds': worlds, 'observables': {'o': observable}}, 'unknown'), '-o', file, '--quiet')
        assert done.returncode == 1 and words in done.stderr, (worlds, observable, done.returncode, done.stderr)
        assert not list(SCRATCH.glob('unknown.sqlite*')), list(SCRATCH.glob('unknown.sqlite*'))
    for seconds in (1e12, 9.2233720368547758e16, 1e300):
        file = fresh('unknown')
        done = run(write_plan({'worlds': 'chain:3', 'seconds': seconds}, 'unknown'), '-o', file, '--quiet')
        assert done.returncode == 1 and 'seconds: are more than 1000000000 frames' in done.stderr and not os.path.exists(file), done.stderr
    for path, value, words in (('/sdf/world/model[nobody]/pose', '0', 'there is no /sdf/world/model[nobody]'), ('/sdf/world/gravity', '0 0 ${none}', 'names a parameter')):
        file = fresh('unknown')
        done = run(write_plan({'worlds': 'epuck', 'frames': 1, 'parameters': {path: value}}, 'unknown'), '-o', file, '--quiet')
        assert done.returncode == 1 and words in done.stderr and not os.path.exists(file), done.stderr
    # More columns than SQLite has: the file is refused by it, and not left.
    many = {**good, 'observables': {f'o{i}': 'energy' for i in range(3000)}}
    done = run(write_plan(many, 'unknown'), '-o', file, '--quiet')
    assert done.returncode == 1 and 'too many columns' in done.stderr and not list(SCRATCH.glob('unknown.sqlite*')), done.stderr


def parameters():
    """Each changes what it names; elements of SDF worlds, too."""
    rows = batch({'worlds': 'chain:3', 'frames': 20, 'parameters': {'gravity': [0, -9.81]}, 'observables': {'z': 'body[1].height'}}, 'gravity')['runs']
    assert rows[0][-1] > rows[1][-1], rows
    rows = batch({'worlds': 'epuck', 'frames': 50, 'parameters': {'/sdf/world/gravity': ['0 0 -9.81', '0 0 -1']},
                  'observables': {'e': 'energy'}}, 'elements')['runs']
    assert [row[4] for row in rows] == ['done', 'done'] and rows[0][-1] > 5 * rows[1][-1], rows


def same_table():
    """Whoever runs them, and beside whom; the rows are read as pandas does."""
    one = batch(SMALL, 'one', '-j1')
    assert len(one['runs']) == 24 and len(one['series']) == 72 and len(one['states']) == 3 * 6 * 2 * (10 + 20), {k: len(v) for k, v in one.items()}
    assert len({row[9] for row in one['runs']}) == 24, 'two worlds have ended alike'
    for workers in ('2', '4'):
        assert batch(SMALL, 'some', '-j' + workers) == one, workers
    with sqlite3.connect(SCRATCH / 'one.sqlite') as database:
        names = [column[0] for column in database.execute('SELECT * FROM runs').description]
        assert names == ['run', 'world', 'gravity', 'stacks', 'seed', 'status', 'message', 'frames', 'time', 'hash', 'x', 'lowest', 'contacts'], names
        mean, = database.execute("SELECT avg(lowest) FROM runs WHERE gravity = -9.81 AND status = 'done'").fetchone()
        assert 0.2 < mean < 0.26, mean
        assert database.execute('SELECT count(*) FROM times WHERE mean_ms > 0').fetchone() == (24,)
    # A worker runs a world of another plan before: nothing of it is left.
    last = batch({**SMALL, 'seeds': [6]}, 'last', '-j1')
    assert [row[9] for row in last['runs']] == [row[9] for row in one['runs']][5::6]


def descendants(process):
    found, todo = [], [process]
    while todo:
        parent = todo.pop()
        for task in pathlib.Path(f'/proc/{parent}/task').glob('*/children'):
            try:
                children = [int(child) for child in task.read_text().split()]
            except OSError:
                continue
            found += children
            todo += children
    return found


def is_batch(process):
    try:
        return 'odemt_batch' in pathlib.Path(f'/proc/{process}/comm').read_text()
    except OSError:
        return False


def await_end(processes):
    end = time.monotonic() + 30
    while any(is_batch(process) for process in processes):
        assert time.monotonic() < end, 'a process has outlived the one that was killed'
        time.sleep(0.02)


def kills(before=(), name='killed', options=('-j2',)):
    """SIGKILL for the master, a worker, or whatever else there is, at random; then --resume."""
    plan = {**SMALL, 'seeds': {'count': 60}}
    whole = batch(plan, 'whole', '-j2')
    wanted = int(os.environ.get('KILLS', 4))
    file, dice, count, known = fresh(name), random.Random(), 0, 0
    started = [*before, PROGRAM, write_plan(plan, name), '-o', file, '--quiet', '--resume', *options]
    while True:
        program = subprocess.Popen(started, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if count < wanted:
            time.sleep(dice.uniform(0.03, 0.35) + (0.5 if before else 0))
            everyone = descendants(program.pid)
            victim = dice.choice([program.pid, *everyone])
            if program.poll() is None:
                os.kill(victim, signal.SIGKILL)
                count += 1
            program.communicate(timeout=100)
            await_end(everyone)
            if os.path.exists(file):
                with sqlite3.connect(file) as database:
                    runs = database.execute('SELECT count(*) FROM sqlite_master WHERE name = ?', ('runs',)).fetchone()[0]
                    done = database.execute('SELECT count(*) FROM runs').fetchone()[0] if runs else 0
                assert done >= known, 'a row has been lost'
                known = done
            if known == len(whole['runs']):  # all is done: begin again
                file, known = fresh(name), 0
            continue
        error = program.communicate(timeout=100)[1]
        assert program.returncode == 0, error
        break
    assert table(file) == whole
    print(f'{count} kills, the same table of {len(whole["runs"])} rows')


def faults():
    file = fresh('twice')
    plan = write_plan({'worlds': 'chain:3', 'frames': 1}, 'twice')
    assert run(plan, '-o', file, '--quiet').returncode == 0
    done = run(plan, '-o', file, '--quiet')
    assert done.returncode == 1 and '--resume' in done.stderr, done.stderr
    assert run(plan, '-o', file, '--quiet', '--resume').returncode == 0
    done = run(write_plan({'worlds': 'chain:3', 'frames': 2}, 'other'), '-o', file, '--quiet', '--resume')
    assert done.returncode == 1 and 'another plan' in done.stderr, done.stderr
    done = run(plan, '-o', SCRATCH / 'nowhere' / 'a.sqlite')
    assert done.returncode == 1 and 'nowhere' in done.stderr, done.stderr
    assert not glob.glob(file + '-*'), 'what is refused leaves something beside the table'
    # A world without the body that is asked for costs its row, if others with it have it.
    file = fresh('no_body')
    done = run(write_plan({'worlds': 'chain:${n}', 'parameters': {'n': [30, 4, 3]}, 'frames': 1, 'observables': {'z': 'body[20].height'}}, 'no_body'), '-o', file, '--quiet')
    rows = table(file)['runs']
    assert done.returncode == 1 and [row[4] for row in rows] == ['done', 'error', 'error'] and 'body[20]' in rows[1][5], rows
    assert '2 runs have failed, the first of them run 1: there is no body[20]' in done.stderr, done.stderr
    again = run(SCRATCH / 'no_body.json', '-o', file, '--quiet', '--resume')
    assert (again.returncode, again.stderr) == (done.returncode, done.stderr), (again.returncode, again.stderr)
    # Two that write to one file at a time.
    file = fresh('locked')
    long = write_plan({**SMALL, 'seeds': {'count': 300}}, 'locked')
    program = subprocess.Popen([PROGRAM, long, '-o', file, '--quiet'])
    while not os.path.exists(file):
        time.sleep(0.01)
    names = [file, fresh('locked_symbolic'), fresh('locked_hard')]
    os.symlink(file, names[1])
    os.link(file, names[2])
    others = [run(long, '-o', name, '--quiet', '--resume') for name in names]
    program.kill()
    program.wait()
    for done in others:
        assert done.returncode == 1 and 'another odemt_batch' in done.stderr, done.stderr
    # A name that SQLite takes for something else than a file.
    for name in (':memory:', 'file:a?mode=memory'):
        assert subprocess.run([PROGRAM, plan, '-o', name, '--quiet'], cwd=SCRATCH, timeout=100).returncode == 0
        assert len(table(os.path.join(SCRATCH, name))['runs']) == 1, name
        os.unlink(os.path.join(SCRATCH, name))


def sample(page):
    """The example of docs/tools.md."""
    file = fresh('sample')
    plan = pathlib.Path(page).read_text().split('```json\n')[1].split('```')[0]
    done = run(write_plan(plan, 'sample'), '-o', file, '--quiet')
    assert done.returncode == 0, done.stderr
    rows = table(file)['runs']
    assert rows and all('done' in row for row in rows), rows


def launcher(mpiexec, ranks):
    settings = (pathlib.Path(__file__).resolve().parents[2] / 'bench/scale/mpi_environment').read_text().splitlines()
    os.environ.update(line.split('=', 1) for line in settings if not line.startswith('#'))
    command = [mpiexec, '-n', str(ranks)]
    if subprocess.run(command + ['true'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0:
        print('skipped: processes of MPI cannot be started here')
        sys.exit(77)
    return command


def ranks(mpiexec):
    one = batch(SMALL, 'one', '-j1')
    for count in (1, 2, 3):
        assert batch(SMALL, 'ranks', '-j1', before=launcher(mpiexec, count)) == one, count
    with sqlite3.connect(SCRATCH / 'ranks.sqlite') as database:
        assert database.execute('SELECT count(DISTINCT rank) FROM times').fetchone() >= (2,), 'one rank has done all'
    file = fresh('nowhere')
    done = run(write_plan('{'), '-o', file, before=launcher(mpiexec, 2))
    assert done.returncode != 0 and 'not JSON' in done.stderr, done.stderr


def ranks_kills(mpiexec):
    kills(launcher(mpiexec, 2), 'ranks_killed', ('-j1',))


if __name__ == '__main__':
    SCRATCH.mkdir(parents=True, exist_ok=True)
    globals()[sys.argv[3]](*sys.argv[4:])
