"""Test the page that measures, in a real browser and with a real server."""

import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

sync_api = pytest.importorskip(
    "playwright.sync_api", reason="there is no Playwright to look at the site with"
)
axe_core = pytest.importorskip(
    "axe_playwright_python.base", reason="there is no axe to judge the site with"
)

FRONT_BYTES = 10_000
"""Largest size of the files that the front page may fetch for the trial before Run is
pressed.
"""


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format, *args):
        pass


@pytest.fixture(scope="module")
def address(site: Path) -> Iterator[str]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=site))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()


@pytest.fixture
def tab(browser, address, request) -> Iterator["sync_api.Page"]:
    """Yield a tab that must not raise an error or ask another server."""
    tab = browser.new_page(**getattr(request, "param", {}))
    problems: list[str] = []
    tab.on("pageerror", lambda error: problems.append(str(error)))
    tab.on(
        "request",
        lambda asked: (
            None if asked.url.startswith(address) else problems.append(asked.url)
        ),
    )
    yield tab
    tab.close()
    assert problems == []


def run(tab) -> float:
    """Press Run, wait for the end, and return the slip [mm]."""
    tab.click("#lab-run")
    tab.wait_for_selector("#lab-slip[data-slip-mm]", timeout=60_000)
    tab.wait_for_selector("#lab-run:not([disabled])")
    return float(tab.get_attribute("#lab-slip", "data-slip-mm"))


@pytest.mark.parametrize("tab", [{"color_scheme": "dark"}], indirect=True)
def test_run_shakes_the_cube_as_it_is_tracked_and_can_be_read_by_all(tab, address):
    tab.goto(f"{address}lab.html")
    assert run(tab) == pytest.approx(6.3607, abs=0.02)
    assert tab.get_attribute("#lab-slip", "data-class") == "creeping"
    assert tab.locator("#lab-results tbody tr").first.inner_text().count("6.36") == 2
    tab.evaluate(axe_core.AXE_FILE_PATH.read_text(encoding="utf-8"))
    found = tab.evaluate("axe.run({resultTypes: ['violations'], preload: false})")[
        "violations"
    ]
    assert [(rule["id"], rule["nodes"][0]["html"][:99]) for rule in found] == []


@pytest.mark.parametrize(
    "tab",
    [{"reduced_motion": "reduce", "viewport": {"width": 390, "height": 844}}],
    indirect=True,
)
def test_an_address_sets_it_and_the_keyboard_runs_it(tab, address):
    tab.goto(f"{address}lab.html#ke=250000&kd=1000&mu=nonsense")
    assert (
        tab.input_value("#lab-form-ke") == "250000"
        and tab.input_value("#lab-form-mu") == "1"
    )
    tab.focus("#lab-form-ke")
    tab.keyboard.press("Enter")
    tab.wait_for_selector("#lab-slip[data-slip-mm]", timeout=60_000)
    assert float(tab.get_attribute("#lab-slip", "data-slip-mm")) == pytest.approx(
        0.3153, abs=0.02
    )
    assert tab.url.endswith("#ke=250000&kd=1000")
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390


def test_it_is_cancelled(tab, address):
    tab.goto(f"{address}lab.html#substeps=64")
    tab.click("#lab-run")
    tab.wait_for_selector("#lab-cancel:not([disabled])")
    tab.click("#lab-cancel")
    tab.wait_for_selector("#lab-status:has-text('Cancelled')", timeout=60_000)
    assert tab.get_attribute("#lab-slip", "data-slip-mm") is None
    tab.wait_for_selector("#lab-slip:has-text('not run yet')")


def test_the_turntable_grows_by_the_law(tab, address):
    tab.goto(f"{address}lab.html")
    tab.click("#turn-run")
    tab.wait_for_selector("#turn-growth[data-growth-per-s]", timeout=60_000)
    assert float(
        tab.get_attribute("#turn-growth", "data-growth-per-s")
    ) == pytest.approx(0.0349907, rel=0.005)


def test_from_a_file_it_says_that_it_can_not(site, browser):
    tab = browser.new_page()
    tab.goto((site / "lab.html").as_uri())
    assert "from a file" in tab.text_content("#lab-status")
    tab.goto((site / "index.html").as_uri())
    assert not tab.get_by_text("press Run").is_visible()
    tab.close()


def test_the_front_page_tries_it_and_is_hardly_heavier_for_it(tab, address):
    fetched: dict[str, int] = {}
    tab.on("response", lambda answer: fetched.update({answer.url: len(answer.body())}))
    tab.goto(f"{address}index.html")
    assert sum(size for url, size in fetched.items() if "/lab/" in url) <= FRONT_BYTES
    tab.click("#try-run")
    tab.wait_for_selector("#try-slip[data-slip-mm]", timeout=60_000)
    assert float(tab.get_attribute("#try-slip", "data-slip-mm")) == pytest.approx(
        6.3607, abs=0.02
    )
    tab.locator("#try-kd").press("ArrowRight")
    assert tab.text_content("#try-slip") == "", "what was measured is of another kd"


def test_the_slider_tells_what_the_law_makes_of_it(tab, address):
    """Test that the slip at the shipped kd agrees with the tracked run, and that it
    decreases until the timeconst is two steps.
    """
    tab.goto(f"{address}index.html")
    assert "kd = 100: the law predicts 6.36 mm" in tab.inner_text("#try")
    tab.locator("#try-kd").press("End")
    assert "the law predicts 0.332 mm" in tab.inner_text("#try")


@pytest.mark.parametrize(
    "tab", [{"viewport": {"width": 320, "height": 640}}], indirect=True
)
def test_a_search_finds_what_stands_on_another_page(tab, address):
    tab.goto(f"{address}lab.html")
    tab.fill(".search input", "friction coefficient")
    tab.wait_for_selector(".search a")
    assert (
        tab.evaluate("document.documentElement.scrollWidth")
        <= tab.viewport_size["width"]
    )
    link = tab.locator('.search a[href^="cause.html#"]').first
    place = link.get_attribute("href").partition("#")[2]
    link.click()
    tab.wait_for_selector(f"#{place}:target")
    tab.fill(".search input", "xyzzy")
    tab.wait_for_selector("text=No results")
