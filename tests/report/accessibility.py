"""What a screen reader is told of a page, and what the keyboard reaches on it."""
from selenium.webdriver.common.keys import Keys

# Marks what takes part in the order of the Tab key, and returns what it is, in words for a failure.
MARK_STOPS = """return [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')]
    .filter(element => element.checkVisibility() && !element.disabled)
    .map((element, place) => { element.dataset.stop = place; return element.outerHTML.slice(0, 100); });"""
FOCUSED = "return document.activeElement.dataset.stop ?? null"


def without_names(browser):
    """Roles of what can be focused, and of images and tables, that the browser's accessibility tree has no name for."""
    nodes = browser.driver.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
    found = []
    for node in nodes:
        role = node.get("role", {}).get("value")
        focusable = any(entry["name"] == "focusable" and entry["value"].get("value") for entry in node.get("properties", []))
        if not node["ignored"] and role != "RootWebArea" and (focusable or role in ("img", "image", "table", "Canvas")):
            found.append((role, node.get("name", {}).get("value", "")))
    assert len(found) > 5, found
    return [role for role, name in found if not name.strip()]


def not_reached_by_tab(browser):
    """Controls, links and scrolling parts on which the Tab key does not stop."""
    stops = browser.run(MARK_STOPS)
    browser.run("document.activeElement.blur(); getSelection().removeAllRanges(); scrollTo(0, 0)")
    reached = set()
    for _ in range(len(stops) + 2):
        browser.driver.switch_to.active_element.send_keys(Keys.TAB)
        stop = browser.run(FOCUSED)
        if stop is not None:
            reached.add(int(stop))
    assert len(stops) > 3, stops
    return [text for place, text in enumerate(stops) if place not in reached]
