"""What MkDocs asks of this site while it builds it: the reference in the navigation, and links from names of functions to the reference."""
import os
import pathlib
import re
import xml.etree.ElementTree

from mkdocs.structure.nav import Link

CODE = re.compile(r"(?<!<pre>)<code>(d[A-Z]\w+)(\([^<]*\))?</code>")
HEADING = re.compile(r"<h\d.*?</h\d>|<a .*?</a>", re.DOTALL)
places = {}  # of functions: page and anchor


def on_config(config):
    for member in xml.etree.ElementTree.parse(os.environ["ODE_MT_REFERENCE_TAGS"]).iter("member"):
        if member.get("kind") == "function":
            places[member.findtext("name")] = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
    return config


def on_nav(nav, config, files):
    nav.items.append(Link("Reference of functions", "reference/index.html"))
    return nav


def on_page_content(html, page, config, files):
    reference = os.path.relpath("reference", pathlib.PurePosixPath(page.url).parent)

    def link(match):
        place = places.get(match[1])
        return f'<a href="{reference}/{place}">{match[0]}</a>' if place else match[0]

    parts, end = [], 0  # names in headings and in links stay as they are
    for kept in HEADING.finditer(html):
        parts += [CODE.sub(link, html[end:kept.start()]), kept[0]]
        end = kept.end()
    return "".join(parts) + CODE.sub(link, html[end:])
