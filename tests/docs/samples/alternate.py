#!/usr/bin/env python3
"""Runs a program alternately with libode8 and with ODE_MT, and tells how much faster it is and whether it prints the same.

    alternate.py FOLDER THREADS ROUNDS COMMAND...

FOLDER has our libode.so.8; THREADS is what ODE_MT_THREADS is set to. The order changes from round to round, and a speed-up is the quotient of
the two times of one round, so that a disturbance of some seconds concerns both. Exits with 1 if the program prints something else.
"""
import os
import statistics
import subprocess
import sys
import time


def run(command, settings):
    begin = time.monotonic()
    result = subprocess.run(command, env={**os.environ, **settings}, stdout=subprocess.PIPE, check=True)
    return time.monotonic() - begin, result.stdout


def main(folder, threads, rounds, *command):
    engines = [{}, {"LD_LIBRARY_PATH": folder, "ODE_MT_THREADS": threads}]
    speed_ups, printed = [], set()
    for number in range(int(rounds)):
        seconds = {}
        for engine in (0, 1) if number % 2 == 0 else (1, 0):
            seconds[engine], text = run(command, engines[engine])
            printed.add(text)
        speed_ups.append(seconds[0] / seconds[1])
    quartiles = statistics.quantiles(speed_ups, n=4) if len(speed_ups) > 1 else speed_ups * 3
    print("speed-up: median {1:.2f}, quartiles {0:.2f} to {2:.2f}".format(*quartiles))
    print("the same output" if len(printed) == 1 else "ANOTHER OUTPUT")
    return 0 if len(printed) == 1 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
