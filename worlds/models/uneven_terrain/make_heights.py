#!/usr/bin/env python3
"""Makes heights.png, the ground of the world uneven_terrain: 65 x 65 heights of 16 bits, hills that end at the edges.

    make_heights.py heights.png

White is 10 m. The height at x and y, in m from the middle, and each between -25 and 25, is

    (1 - (x/25)^8) (1 - (y/25)^8) (5.5 + 2 sin(x/4 + 1) cos(y/5) + 0.7 sin(x/1.9) sin(y/2.3))
"""
import math
import struct
import sys
import zlib

POINTS = 65
SIDE = 50.0
HIGHEST = 10.0


def height(x, y):
    edge = (1 - (x / 25) ** 8) * (1 - (y / 25) ** 8)
    return edge * (5.5 + 2 * math.sin(x / 4 + 1) * math.cos(y / 5) + 0.7 * math.sin(x / 1.9) * math.sin(y / 2.3))


def rows():
    for row in range(POINTS):  # the first one at +y
        y = SIDE / 2 - row * SIDE / (POINTS - 1)
        line = bytearray([0])  # no filter
        for column in range(POINTS):
            x = column * SIDE / (POINTS - 1) - SIDE / 2
            line += struct.pack(">H", round(height(x, y) / HIGHEST * 0xffff))
        yield bytes(line)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    header = struct.pack(">IIBBBBB", POINTS, POINTS, 16, 0, 0, 0, 0)  # grey
    with open(sys.argv[1], "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows()), 9)) +
                   chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
