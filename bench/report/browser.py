"""Headless Chromium for pages of odemt_report, without a network: for tests and pictures."""
import pathlib
import shutil
import sys
import tempfile

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    webdriver = None

# The first line is for containers, the second draws with the processor, the rest keeps Chromium from looking up hosts.
ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
             "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
             "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic",
             "--disable-extensions", "--hide-scrollbars", "--force-device-scale-factor=1"]
SECONDS = 60  # until a page counts as hanging: the machine may be busy


class Browser:
    """A browser with a profile of its own: `with Browser() as browser: browser.open(page)`."""

    def __init__(self, width=1200, height=900, dark=False):
        self._profile = tempfile.mkdtemp(prefix="odemt_report_")
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ARGUMENTS + [f"--user-data-dir={self._profile}", f"--window-size={width},{height}"]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        if dark:
            scheme = {"features": [{"name": "prefers-color-scheme", "value": "dark"}]}
            self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", scheme)

    def open(self, page, view=""):
        """Opens a page of odemt_report; `view`: what stands behind # in its address."""
        self.driver.get("about:blank")  # another view of the same page is another page
        self.driver.get(pathlib.Path(page).resolve().as_uri() + (f"#{view}" if view else ""))
        self.wait("return document.documentElement.dataset.ready === 'true' || document.querySelector('main > .warning') !== null")

    def close(self):
        self.driver.quit()
        shutil.rmtree(self._profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait(self, script):
        WebDriverWait(self.driver, SECONDS).until(lambda driver: driver.execute_script(script))

    def settle(self):
        """Waits until what was changed is drawn."""
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def errors(self):
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]


def exit_if_missing():
    missing = [name for name, there in (("python3-selenium", webdriver), ("chromium", shutil.which("chromium")),
                                        ("chromium-driver", shutil.which("chromedriver"))) if not there]
    if missing:
        print("skipped: not installed:", ", ".join(missing))
        sys.exit(1)


if __name__ == "__main__":
    exit_if_missing()
