#!/usr/bin/env python3
"""Results on the page, in a browser: the figures of results.json, plots that are not empty, labels, the keyboard.

    results_test.py ODEMT_REPORT
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import accessibility
from selenium.webdriver.common.keys import Keys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench/report"))
from browser import Browser  # noqa: E402

RESULTS = pathlib.Path(__file__).with_name("results.json")
DRAWN = """return [...document.querySelectorAll('.plot canvas')].map(canvas => {
    const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    return new Set(new Uint32Array(pixels.buffer)).size;
});"""

# Of the whisker of the bar of a colour against what is beside it (WCAG 2's contrast), 5 pixels above the end of the bar and 5 below.
WHISKER_CONTRASTS = """const [bar] = arguments, canvas = document.querySelector('#speed-ups canvas'), { width, height } = canvas, kLegend = 40;
const pixels = canvas.getContext('2d').getImageData(0, 0, width, height).data;
const surface = getComputedStyle(document.documentElement).getPropertyValue('--background').trim();
const ofPage = [1, 3, 5].map(i => parseInt(surface.slice(i, i + 2), 16));
const at = (x, y) => {
    const [r, g, b, a] = pixels.slice(4 * (y * width + x), 4 * (y * width + x) + 4);
    return [r, g, b].map((channel, i) => Math.round((channel * a + ofPage[i] * (255 - a)) / 255));
};
const isBar = (x, y) => bar.every((channel, i) => at(x, y)[i] === channel);
const rows = Array.from({ length: height - kLegend }, (_, i) => i + kLegend), columns = Array.from({ length: width }, (_, i) => i);
const middleRow = Math.round(height / 2), inBar = columns.filter(x => isBar(x, middleRow));
const top = rows.find(y => isBar(inBar[0] + 5, y)), centre = Math.round((inBar[0] + inBar[inBar.length - 1]) / 2);
const linear = value => value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4;
const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
const contrast = (x, y, around) => {
    const [one, other] = [luminance(at(x, y)), luminance(at(around, y))].sort();
    return (other + 0.05) / (one + 0.05);
};
return [top - 5, top + 5].map(y => Math.max(...[-1, 0, 1].flatMap(offset => [-2, 2].map(beside =>
    contrast(centre + offset, y, centre + offset + beside)))));"""


class ResultsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        page = pathlib.Path(cls.folder.name) / "page.html"
        subprocess.run([sys.argv[1], str(RESULTS), "--output", str(page)], check=True)
        cls.browser = Browser(dark=True)
        cls.browser.open(page)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).innerText", selector)

    def test_nothing_is_wrong_or_loaded(self):
        self.assertEqual(self.browser.errors(), [])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').length"), 0)

    def test_tables_show_the_figures(self):
        self.assertIn("Processor <of> the test & more, 2 cores", self.text("#machine"))
        self.assertIn("2.25 [2.14, 2.36]", self.text("#speed-ups"))
        self.assertIn("4.21", self.text("#speed-ups"))
        self.assertIn("1.41 [1.33, 1.52]", self.text("#threads"))
        self.assertIn("9.13", self.text("#sizes"))
        self.assertIn("1.12", self.text("#sizes"))
        self.assertIn("5.35 (5.29 [5.10, 5.50])", self.text("#real-time"))
        self.assertIn("0123456789abcdef", self.text("#summary"))

    def test_frame_times_have_their_quantiles(self):
        middle = 2 ** (0.5 / 8)
        self.assertIn(f"{4 * middle:.2f}", self.text("#frame-times"))
        self.assertIn(f"{5 * middle:.2f}", self.text("#frame-times"))

    def test_other_results_are_a_warning(self):
        self.assertIn("ours:2 gave other results, found after frame 150", self.text("#summary .warning"))

    def test_plots_are_drawn_and_described(self):
        colours = self.browser.run(DRAWN)
        self.assertEqual(len(colours), 6)
        self.assertTrue(all(count > 10 for count in colours), colours)
        labels = self.browser.run("return [...document.querySelectorAll('.plot canvas')].map(c => c.getAttribute('aria-label'))")
        self.assertTrue(all(len(label) > 40 for label in labels), labels)

    def test_whiskers_are_seen_above_bars(self):
        for contrast in self.browser.run(WHISKER_CONTRASTS, [0x00, 0x9E, 0x73]):  # of ours:2
            self.assertGreater(contrast, 4.5)

    def test_a_screen_reader_has_a_name_for_everything(self):
        self.assertEqual(accessibility.without_names(self.browser), [])
        self.browser.run("document.querySelector('main').append(document.createElement('button'))")
        self.assertEqual(accessibility.without_names(self.browser), ["button"])
        self.browser.run("document.querySelector('main > button').remove()")
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('table')].filter(t => !t.caption?.innerText).length"), 0)

    def test_the_keyboard_reaches_everything(self):
        self.assertEqual(accessibility.not_reached_by_tab(self.browser), [])

    def test_the_keyboard_chooses(self):
        self.browser.run("document.getElementById('frame-times-world').focus()")
        self.assertEqual(self.browser.driver.switch_to.active_element.get_attribute("id"), "frame-times-world")
        self.browser.driver.switch_to.active_element.send_keys(Keys.TAB)
        self.assertEqual(self.browser.driver.switch_to.active_element.get_attribute("role"), "region")  # a table that scrolls


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
