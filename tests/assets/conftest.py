"""Provide a browser if one is installed."""

import shutil
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser

BROWSERS = ("chromium", "chromium-browser", "google-chrome")


@pytest.fixture(scope="module")
def browser() -> Iterator["Browser"]:
    sync_api = pytest.importorskip(
        "playwright.sync_api", reason="there is no Playwright: run make test"
    )
    if not (program := next(filter(None, map(shutil.which, BROWSERS)), None)):
        pytest.skip(
            f"there is no browser ({', '.join(BROWSERS)}): run apt-get install chromium, or playwright install"
        )
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=program, args=["--no-sandbox"]
        )
        yield browser
        browser.close()
