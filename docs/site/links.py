#!/usr/bin/env python3
"""Faults of a folder of HTML pages: links that lead nowhere, pages that need the network, Markdown that was not understood.

    links.py FOLDER         prints them and exits with 1 if there are any
    links.py --self-test    shows that they are found
"""
import html.parser
import pathlib
import re
import sys
import tempfile
import urllib.parse

LEFT_OVER = re.compile(r"^\s*(?:\|.*\||\|? ?-{3,} ?\|.*|\* .*|\d+\. .*|```.*)$", re.MULTILINE)  # tables, lists and fences as they are written


class Page(html.parser.HTMLParser):
    """Links, anchors, what is loaded, and the text outside of code."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.loaded, self.text, self.depth = set(), set(), set(), [], 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[key] for key in ("id", "name") if given.get(key)}
        self.depth += tag in ("pre", "code", "script", "style")
        if tag == "a" and given.get("href"):
            self.links.add(given["href"])
        elif tag == "link" and given.get("rel") not in ("canonical", "prev", "next") and given.get("href"):
            self.loaded.add(given["href"])
        elif tag in ("script", "img", "iframe") and given.get("src"):
            self.loaded.add(given["src"])

    def handle_endtag(self, tag):
        self.depth -= tag in ("pre", "code", "script", "style")

    def handle_data(self, data):
        if self.depth == 0:
            self.text.append(data)


def is_outside(link):
    return re.match(r"(?:[a-z]+:)?//|[a-z]+:", link) is not None


def faults_of(folder):
    """The faults, a sentence each."""
    folder = pathlib.Path(folder)
    pages = {path: Page(path.read_text()) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        name = path.relative_to(folder)
        for link in sorted(page.loaded):
            if is_outside(link) and not link.startswith(("data:", "javascript:")):
                yield f"{name}: needs the network for {link}"
        if name.name == "404.html":  # its links are those of a server's root
            continue
        for link in sorted(link for link in page.links | page.loaded if not is_outside(link)):
            file, _, anchor = link.partition("#")
            target = (path.parent / urllib.parse.unquote(file.partition("?")[0])).resolve() if file else path
            target = target / "index.html" if target.is_dir() else target
            if not target.is_file():
                yield f"{name}: there is no {link}"
            elif anchor and target in pages and urllib.parse.unquote(anchor) not in pages[target].anchors:
                yield f"{name}: there is no {link}: no such heading"
        if "reference" not in name.parts:
            for text in LEFT_OVER.findall("".join(page.text)):
                yield f"{name}: Markdown that was not understood: {text.strip()}"


def self_test():
    def faults(**pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                (pathlib.Path(folder) / f"{name}.html").write_text(text)
            return len(list(faults_of(folder)))

    assert faults(one='<a href="two.html#here">two</a>', two='<h1 id="here">two</h1>') == 0
    assert faults(one='<a href="two.html#there">two</a>', two='<h1 id="here">two</h1>') == 1
    assert faults(one='<a href="three.html">three</a>') == 1
    assert faults(one='<a href="https://example.org/">elsewhere</a>') == 0
    assert faults(one='<script src="https://example.org/"></script>') == 1
    assert faults(one="<p>\n* one\n| two | three |\n</p>") == 2
    assert faults(one="<pre><code>\n* one\n</code></pre>") == 0
    return 0


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        sys.exit(self_test())
    FAULTS = list(faults_of(sys.argv[1]))
    print(*FAULTS, sep="\n")
    sys.exit(1 if FAULTS else 0)
