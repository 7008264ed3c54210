"""A report in a real browser: browser.py REPORT FOLDER. Leaves screenshots and the printed page in FOLDER."""

import base64
import json
import pathlib
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request

ARROW_RIGHT = "\ue014"
END = "\ue010"


class Browser:
    """Chromium through chromedriver: https://www.w3.org/TR/webdriver2/."""

    def __init__(self, folder):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.log = open(folder / "chromedriver.txt", "w")
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=self.log, stderr=self.log)
        self.url = f"http://127.0.0.1:{port}"
        self.session = ""
        self.wait_for_driver()
        options = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
                   "--disable-component-update", "--disable-sync", "--no-first-run", "--disable-dev-shm-usage",
                   f"--user-data-dir={folder / 'profile'}", "--window-size=1100,1400"]
        wanted = {"browserName": "chrome", "goog:chromeOptions": {"args": options},
                  "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
        found = self.call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
        self.session = "/session/" + found["sessionId"]

    def wait_for_driver(self):
        for _ in range(200):
            try:
                return self.call("GET", "/status")
            except (urllib.error.URLError, ConnectionError):
                time.sleep(0.1)
        raise SystemExit("report: chromedriver does not answer")

    def call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + self.session + path, data, {"Content-Type": "application/json"},
                                         method=method)
        with urllib.request.urlopen(request, timeout=120) as answer:
            return json.load(answer)["value"]

    def devtools(self, command, **parameters):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def run(self, script):
        return self.call("POST", "/execute/sync", {"script": script, "args": []})

    def keys(self, element, text):
        self.call("POST", f"/element/{element}/value", {"text": text})

    def find(self, selector):
        found = self.call("POST", "/element", {"using": "css selector", "value": selector})
        return next(iter(found.values()))

    def messages(self, kind):
        return self.call("POST", "/se/log", {"type": kind})

    def close(self):
        if self.session:
            self.call("DELETE", "")
        self.driver.terminate()
        self.driver.wait()
        self.log.close()


def expect(truth, what):
    if not truth:
        raise SystemExit(f"report: {what}")


def after_width(browser):
    """The visible share of the view after, by what the browser computes."""
    clip = browser.run("return getComputedStyle(document.querySelector('.frame .after')).clipPath")
    hidden = re.fullmatch(r"inset\(0px 0px 0px ([\d.]+)%\)", clip)
    expect(hidden, f"the view after is clipped by '{clip}'")
    return 100 - float(hidden.group(1))


def check_slider(browser):
    slider = browser.find(".slide input")
    expect(after_width(browser) == 50, "the slider does not begin in the middle")
    browser.keys(slider, ARROW_RIGHT * 3)
    expect(after_width(browser) == 47, "the arrow keys do not move the slider")
    browser.keys(slider, END)
    expect(after_width(browser) == 0, "the view before cannot be seen whole")
    browser.run("const r = document.querySelector('.slide input'); r.value = 20; r.dispatchEvent(new Event('input'))")
    expect(after_width(browser) == 80, "the slider does not follow its value")
    name = browser.run("return document.querySelector('.slide input').labels[0].textContent")
    expect(name == "Before or after", "the slider has no name")
    said = browser.run("return document.querySelector('.slide input').getAttribute('aria-valuetext')")
    expect(said.startswith("20 %"), f"the slider says '{said}'")


def check_content(browser):
    expect(browser.run("return document.characterSet + document.documentElement.lang") == "UTF-8en", "no UTF-8 or en")
    expect(browser.run("return document.title") == "project", "the title is another")
    expect(browser.run("return document.querySelectorAll('script').length") == 1, "a name became a script")
    expect(browser.run("return document.querySelectorAll('[onload]').length") == 0, "a name became an attribute")
    expect(browser.run("return document.querySelectorAll('section.viewpoint').length") == 2, "viewpoints are missing")
    broken = "return [...document.images].filter(i => !i.complete || i.naturalWidth === 0).length"
    expect(browser.run(broken) == 0, "a picture cannot be shown")
    expect(browser.run("return document.images.length") == 4, "pictures are missing")
    expect(browser.run("return [...document.images].every(i => i.alt)"), "a picture has no text")
    wide = "return document.documentElement.scrollWidth <= document.documentElement.clientWidth"
    expect(browser.run(wide), "the page is wider than the window")


def check_silence(browser, report):
    said = [one["message"] for one in browser.messages("browser")]
    expect(not said, f"the console says {said}")
    for one in browser.messages("performance"):
        message = json.loads(one["message"])["message"]
        # The browser's own first page asks for things, too.
        if message["method"] == "Network.requestWillBeSent" and message["params"]["documentURL"] == report.as_uri():
            url = message["params"]["request"]["url"]
            expect(url.startswith(("file:", "data:")), f"the page asks for {url}")


def check_print(browser, folder):
    browser.devtools("Emulation.setEmulatedMedia", media="print")
    places = browser.run("return ['before', 'after'].map(s => document.querySelector('.frame .' + s)"
                         ".getBoundingClientRect()).map(r => [r.left, r.right, r.top])")
    expect(places[0][1] <= places[1][0] and places[0][2] == places[1][2], "printed, the views are not side by side")
    expect(browser.run("return getComputedStyle(document.querySelector('.slide')).display") == "none",
           "the slider is printed")
    browser.devtools("Emulation.setEmulatedMedia", media="")
    pdf = base64.b64decode(browser.devtools("Page.printToPDF", preferCSSPageSize=True, printBackground=False)["data"])
    (folder / "report.pdf").write_bytes(pdf)
    pages = len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf))
    expect(5 <= pages <= 8, f"it prints on {pages} pages")
    size = re.search(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", pdf)
    expect(abs(float(size.group(1)) - 595) < 2 and abs(float(size.group(2)) - 842) < 2, "the paper is not A4")


def main(report, folder):
    browser = Browser(folder)
    try:
        browser.call("POST", "/url", {"url": report.as_uri()})
        check_content(browser)
        check_slider(browser)
        (folder / "report.png").write_bytes(base64.b64decode(
            browser.devtools("Page.captureScreenshot", captureBeyondViewport=True)["data"]))
        check_silence(browser, report)
        check_print(browser, folder)
    finally:
        browser.close()


main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
