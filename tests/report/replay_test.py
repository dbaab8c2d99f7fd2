#!/usr/bin/env python3
"""The replay in a browser: two recordings of one world, by libode8 and by ODE_MT, and a third that differs in one number.

    replay_test.py ODEMT_REPORT ODEMT_RECORD
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import accessibility
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench/report"))
from browser import Browser  # noqa: E402

REPORT, RECORD = sys.argv[1:3]
CHANGED_FRAME, CHANGED_BODY, CHANGED_FIELD = 4, 3, 1  # place of the frame in the file, body, y

# Number of colours in a picture, and in how many of a hundred points two pictures differ.
COLOURS = """const copy = document.createElement('canvas'), canvas = document.getElementById(arguments[0]);
[copy.width, copy.height] = [canvas.width, canvas.height];
const context = copy.getContext('2d');
context.drawImage(canvas, 0, 0);
const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
return [new Set(pixels).size, pixels.reduce((sum, pixel) => (31 * sum + pixel) % 4294967291, 7)];"""


# Number of colours along the edge of a picture.
COLOURS_OF_THE_EDGE = """const copy = document.createElement('canvas'), canvas = document.getElementById(arguments[0]);
[copy.width, copy.height] = [canvas.width, canvas.height];
const context = copy.getContext("2d", { willReadFrequently: true }), { width, height } = copy;
context.drawImage(canvas, 0, 0);
const strips = [[0, 0, width, 1], [0, height - 1, width, 1], [0, 0, 1, height], [width - 1, 0, 1, height]];
return new Set(strips.flatMap(strip => [...new Uint32Array(context.getImageData(...strip).data.buffer)])).size;"""

# Where on the time line (0 to 1) the colour of a difference is seen.
DIFFERENCE_MARKS = """const canvas = document.querySelector('.timeline canvas'), probe = document.createElement('canvas').getContext('2d');
probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--warning').trim();
probe.fillRect(0, 0, 1, 1);
const row = (context, width) => new Uint32Array(context.getImageData(0, 0, width, 1).data.buffer), [sought] = row(probe, 1);
return [...row(canvas.getContext('2d'), canvas.width).entries()].filter(([x, pixel]) => pixel === sought).map(([x]) => x / canvas.width);"""

# How many pixels of a colour stand above the middle of the time line, and below it: for each place on it (0 to 1).
EVENT_MARKS = """const [colour, places] = arguments, canvas = document.querySelector('.timeline canvas'), { width, height } = canvas;
const channels = [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16)), inset = 8;
const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
copy.drawImage(canvas, 0, 0);
const pixels = copy.getImageData(0, 0, width, height).data;
const isSought = (x, y) => [...channels, 255].every((channel, i) => pixels[4 * (y * width + x) + i] === channel);
const count = (x, from, to) => Array.from({ length: to - from }, (_, i) => from + i).filter(y => isSought(x, y)).length;
return places.map(place => {
    const columns = [-1, 0, 1].map(offset => Math.round(inset + (width - 2 * inset) * place) + offset);
    return [Math.max(...columns.map(x => count(x, 0, height / 2))), Math.max(...columns.map(x => count(x, height / 2, height)))];
});"""
MERGE, SPLIT, HALF_HEIGHT = "#0072b2", "#e69f00", 13  # pixels


def record(file, *options, world="pile:20"):
    subprocess.run([RECORD, world, "--frames", "60", "--every", "6", "--contacts", "--cells", "8", *options, "--output", str(file)], check=True)


def write_changed(original, changed):
    lines = original.read_text().splitlines()
    frame = json.loads(lines[1 + CHANGED_FRAME])
    frame["frame"]["bodies"][CHANGED_BODY][CHANGED_FIELD] += 1e-12
    lines[1 + CHANGED_FRAME] = json.dumps(frame)
    changed.write_text("\n".join(lines) + "\n")


class ReplayTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(width=800, height=800)
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        cls.stock, cls.ours, cls.changed = (folder / name for name in ("stock.jsonl", "ours.jsonl", "changed.jsonl"))
        record(cls.stock, "--stock")
        record(cls.ours)
        write_changed(cls.ours, cls.changed)
        cls.soccer = folder / "soccer.jsonl"
        record(cls.soccer, "--threads", "2", world="soccer")
        cls.frames = [json.loads(line)["frame"] for line in cls.ours.read_text().splitlines()[1:]]

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def open(self, *recordings, view=""):
        page = pathlib.Path(self.folder.name) / "page.html"
        subprocess.run([REPORT, *(word for file in recordings for word in ("--recording", str(file))), "--output", str(page)], check=True)
        self.browser.open(page, view)
        self.browser.wait("return document.getElementById('replay')?.dataset.drawn !== undefined")
        return self.browser

    def state(self, name):
        return self.browser.run("return document.getElementById('replay').dataset[arguments[0]]", name)

    def wait_for(self, name, value):
        self.browser.wait(f"return document.getElementById('replay')?.dataset.{name} === '{value}'")

    def press(self, *keys):
        self.browser.driver.switch_to.active_element.send_keys(*keys)

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).innerText", selector)

    def choose(self, name, value):
        self.browser.run("""const control = document.getElementById(arguments[0]);
            control.value = arguments[1]; for (const kind of ['input', 'change']) control.dispatchEvent(new Event(kind));""", name, value)

    def picture(self, canvas=0):
        self.browser.settle()
        return self.browser.run(COLOURS, f"replay-canvas-{canvas}")

    def test_one_recording(self):
        browser = self.open(self.ours)
        numbers = [frame["number"] for frame in self.frames]

        with self.subTest("a picture is drawn, and another one of another frame"):
            colours, first = self.picture()
            self.assertGreater(colours, 20)
            self.choose("replay-frame", 5)
            self.wait_for("drawn", numbers[5])
            self.assertNotEqual(self.picture()[1], first)
            self.assertIn(f"frame {numbers[5]},", browser.run("return document.getElementById('replay-frame').getAttribute('aria-valuetext')"))

        with self.subTest("the keyboard steps, jumps, plays, turns, comes nearer"):
            browser.run("document.getElementById('replay-canvas-0').focus()")
            self.press(Keys.ARROW_RIGHT)
            self.wait_for("frame", numbers[6])
            self.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
            self.wait_for("frame", numbers[4])
            for key in ("d", "w", "+", "-"):
                before = self.picture()[1]
                self.press(key)
                self.assertNotEqual(self.picture()[1], before, key)
            self.press(Keys.END)
            self.wait_for("frame", numbers[-1])
            self.press(Keys.HOME)
            self.wait_for("frame", numbers[0])
            self.choose("replay-speed", "10")
            browser.run("document.getElementById('replay-canvas-0').focus()")
            self.press(Keys.SPACE)
            self.wait_for("frame", numbers[-1])
            self.wait_for("playing", "false")

        with self.subTest("a picked body is described"):
            self.press("n", "n")
            self.wait_for("picked", 1)
            x, y, z = self.frames[-1]["bodies"][1][:3]
            shown = browser.run("return document.querySelector('.inspector').innerText.replace(/[^0-9.e, -]/g, '')")
            for value in (x, y, z, *self.frames[-1]["velocities"][1]):
                self.assertIn(browser.run("return arguments[0].toPrecision(9)", value), shown)

        with self.subTest("a body is picked by its number"):
            self.choose("replay-body", "4")
            self.wait_for("picked", 4)
            self.choose("replay-body", "400")
            self.wait_for("picked", "")

        with self.subTest("a click picks what is under it, or nothing"):
            canvas = browser.driver.find_element(By.ID, "replay-canvas-0")
            picked = set()
            for x in range(-120, 121, 40):
                ActionChains(browser.driver).move_to_element_with_offset(canvas, x, 60).click().perform()
                picked.add(self.state("picked"))
            self.assertGreater(len(picked), 2)
            ActionChains(browser.driver).move_to_element_with_offset(canvas, -300, -210).click().perform()
            self.wait_for("picked", "")

        with self.subTest("colours and overlays change the picture"):
            pictures = set()
            for colouring in ("cluster", "body", "island", "sleep"):
                self.choose("replay-colour", colouring)
                pictures.add(self.picture()[1])
            self.assertGreater(len(pictures), 2)  # one island or one cluster looks as all awake bodies do
            for overlay in ("cells", "contacts", "forces"):
                before = self.picture()[1]
                browser.run("document.getElementById(arguments[0]).click()", f"replay-{overlay}")
                self.assertNotEqual(self.picture()[1], before, overlay)

        self.assertIn("which thread", self.text("#replay"))
        self.assertEqual(browser.errors(), [])

        with self.subTest("a screen reader has a name for everything, and the keyboard reaches it"):
            self.assertEqual(accessibility.without_names(browser), [])
            self.assertEqual(accessibility.not_reached_by_tab(browser), [])

    def test_threads_and_names(self):
        lines = [json.loads(line) for line in self.soccer.read_text().splitlines()]
        names, workers = lines[0]["recording"]["bodyNames"], lines[-1]["frame"]["workers"]
        body = max(range(len(names)), key=lambda i: workers[i])
        browser = self.open(self.soccer, view=f"frame=last&colour=thread&pick={body}")
        self.wait_for("picked", body)
        inspector = self.text(".inspector")
        self.assertIn(f"Body {body} ({names[body]})", inspector)
        self.assertRegex(inspector, rf"thread\s+{workers[body]}")
        self.assertIn(names[body], self.text("[role=status]"))
        self.assertNotIn("which thread", self.text("#replay"))
        colours, threads = self.picture()
        self.assertGreater(colours, 20)
        self.choose("replay-colour", "body")
        self.assertNotEqual(self.picture()[1], threads)
        self.assertEqual(browser.errors(), [])

    def event_marks(self, browser, colour, frames):
        return browser.run(EVENT_MARKS, colour, [i / (len(frames) - 1) for i in range(len(frames))])

    # Each frame has the marks of its own merges and splits, as high as there are many, and no others.
    def test_merges_and_splits_stand_on_the_time_line(self):
        frames = [json.loads(line)["frame"] for line in self.soccer.read_text().splitlines()[1:]]
        merges, splits = ([sum(event["kind"] == kind for event in frame["events"]) for frame in frames] for kind in ("merge", "split"))
        for kind in (merges, splits):
            self.assertGreater(sum(kind), 0, "the recording has none")
            self.assertIn(0, kind, "every frame has one")
        most = max(merges + splits)
        browser = self.open(self.soccer)
        for colour, numbers, side in ((MERGE, merges, 0), (SPLIT, splits, 1)):
            for frame, number, pixels in zip(frames, numbers, self.event_marks(browser, colour, frames)):
                with self.subTest(colour=colour, frame=frame["number"], number=number):
                    self.assertAlmostEqual(pixels[side], HALF_HEIGHT * number / most, delta=1)
                    self.assertEqual(pixels[1 - side], 0)
        rows = browser.run("return [...document.querySelectorAll('.timeline tbody tr')].map(row => [...row.cells].map(cell => Number(cell.textContent)))")
        self.assertEqual(rows, [[frame["number"], m, s] for frame, m, s in zip(frames, merges, splits) if m + s > 0])
        self.assertEqual(browser.errors(), [])

    def test_a_recording_without_merges_and_splits_has_no_marks(self):
        lines = [json.loads(line) for line in self.soccer.read_text().splitlines()]
        for line in lines[1:]:
            line["frame"]["events"] = []
        quiet = pathlib.Path(self.folder.name) / "quiet.jsonl"
        quiet.write_text("\n".join(map(json.dumps, lines)) + "\n")
        browser = self.open(quiet)
        for colour in (MERGE, SPLIT):
            self.assertEqual(self.event_marks(browser, colour, lines[1:]), [[0, 0]] * (len(lines) - 1))
        self.assertIn("No merges or splits of clusters are recorded.", self.text(".timeline"))

    def test_an_address_is_a_view(self):
        number = self.frames[3]["number"]
        browser = self.open(self.ours, view=f"frame={number}&colour=island&show=contacts,nothing&pick=2&azimuth=10&elevation=80&distance=4")
        self.wait_for("drawn", number)
        self.wait_for("picked", 2)
        self.assertEqual(browser.run("return document.getElementById('replay-colour').value"), "island")
        self.assertTrue(browser.run("return document.getElementById('replay-contacts').checked"))
        self.assertFalse(browser.run("return document.getElementById('replay-cells').checked"))
        self.assertEqual(browser.errors(), [])

    # One recording of a body of a shape, which does not move: a tall one is seen whole, whatever it is and however the picture is cut.
    def open_shape(self, shape, size, *, copies=1):
        header = {"algorithm": "none", "geoms": [{"body": 0, "shape": shape, "size": size}], "library": "none", "stepSize": 0.01, "world": "one"}
        pose = [0, 0, 5, 1, 0, 0, 0]
        frame = {"awake": [True], "bodies": [pose], "bodyClusters": [0], "cells": [], "clusters": 0, "events": [], "geoms": [pose],
                 "grid": {"cells": 0, "centre": [0, 0, 0], "edge": 0}, "islands": [0], "memberships": [{"cluster": 0, "static": 0, "testedWith": []}],
                 "number": 1, "time": 0.01, "velocities": [[0] * 6]}
        file = pathlib.Path(self.folder.name) / "shape.jsonl"
        file.write_text(json.dumps({"recording": header}) + "\n" + json.dumps({"frame": frame}) + "\n")
        return self.open(*[file] * copies)

    def test_tall_bodies_are_seen_whole(self):
        for shape, size in (("box", [1, 1, 10]), ("capsule", [0.5, 9]), ("cylinder", [0.5, 10]), ("sphere", [5]), ("mesh", [-1, -1, -5, 1, 1, 5])):
            for copies in (1, 2):  # side by side they are narrow
                with self.subTest(shape=shape, copies=copies):
                    browser = self.open_shape(shape, size, copies=copies)
                    self.assertGreater(self.picture()[0], 1)
                    self.assertEqual(browser.run(COLOURS_OF_THE_EDGE, "replay-canvas-0"), 1)

    def test_picked_bodies_are_marked_whatever_their_shape(self):
        for shape, size in (("box", [1, 1, 1]), ("capsule", [0.5, 1]), ("cylinder", [0.5, 1]), ("sphere", [0.5]), ("mesh", [-1, -1, -1, 1, 1, 1]),
                            ("bounds", [1, 1, 1])):
            with self.subTest(shape=shape):
                browser = self.open_shape(shape, size)
                browser.run("document.getElementById('replay-canvas-0').focus()")
                before = self.picture()[1]
                self.press("n")
                self.wait_for("picked", 0)
                self.assertNotEqual(self.picture()[1], before)

    def test_stock_and_ours_are_equal(self):
        browser = self.open(self.stock, self.ours)
        self.assertIn(f"Equal in all {len(self.frames)} frames", self.text("#replay-difference"))
        self.assertGreater(self.picture(0)[0], 20)
        self.assertEqual(self.picture(0)[1], self.picture(1)[1])
        self.assertEqual(browser.run(DIFFERENCE_MARKS), [])
        self.assertIn("clusters and grid", self.text("#replay"))
        self.assertEqual(browser.errors(), [])

    def test_different_worlds_are_warned_of(self):
        browser = self.open(self.ours, self.soccer)
        self.assertIn("different worlds: 'pile:20' and 'soccer'", self.text("#replay-worlds"))
        self.assertEqual(browser.errors(), [])
        browser = self.open(self.stock, self.changed)
        self.assertEqual(browser.run("return document.getElementById('replay-worlds')"), None)

    def test_the_first_difference_is_found(self):
        browser = self.open(self.ours, self.changed)
        number = self.frames[CHANGED_FRAME]["number"]
        value = self.frames[CHANGED_FRAME]["bodies"][CHANGED_BODY][CHANGED_FIELD]
        told = self.text("#replay-difference")
        self.assertIn(f"First difference in frame {number}: position y of body {CHANGED_BODY} is", told)
        self.assertIn(browser.run("return String(arguments[0])", value), told)
        marks = browser.run(DIFFERENCE_MARKS)
        self.assertGreater(len(marks), 1)
        for mark in marks:
            self.assertAlmostEqual(mark, CHANGED_FRAME / (len(self.frames) - 1), delta=0.03)
        browser.run("document.getElementById('replay-canvas-1').focus()")
        self.press("f")
        self.wait_for("frame", number)
        self.wait_for("picked", CHANGED_BODY)
        self.choose("replay-colour", "difference")
        self.assertNotEqual(self.picture(0)[0], 1)
        self.assertEqual(browser.errors(), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
