"""Test the site of the tracked results in a real browser, on a screen and on a phone,
in both colour schemes.
"""

import http.server
import json
import re
import threading
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from measured_report.editions.project import own_release

sync_api = pytest.importorskip(
    "playwright.sync_api", reason="there is no Playwright to look at the site with"
)
axe_core = pytest.importorskip(
    "axe_playwright_python.base", reason="there is no axe to judge the site with"
)

pytestmark = pytest.mark.words

SCREENS = {"desk": (1280, 900), "phone": (390, 844)}
JUDGED = ("index.html", "cause.html", "compare.html", "lab.html", "replay.html")
"""Pages that together contain every kind of element."""
AXE = "axe.run({resultTypes: ['violations'], preload: false, rules: {'target-size': {enabled: true}}})"
LEAST_TEXT_PX = 9.0
MOST_STOPS = 85
WORDLESS = re.compile(r"<(svg|script|math)\b.*?</\1>|<[^>]*>", re.DOTALL)
OWN_PAGES = ("replay.html", "lab.html")
"""Pages that contain a program."""
TOO_WIDE = """[...document.querySelectorAll("body *")].filter((element) =>
  !element.closest(".wide, pre, svg, .skip") && element.checkVisibility()
  && element.getBoundingClientRect().right > innerWidth + 1).map((element) => element.outerHTML.slice(0, 99))"""
TEXT_SIZES = """[...document.querySelectorAll("svg text")].filter((text) => text.checkVisibility()).map((text) => {
  const scale = text.getScreenCTM();
  return parseFloat(getComputedStyle(text).fontSize) * Math.hypot(scale.a, scale.b);
})"""
OUTSIDE = """[...document.querySelectorAll("svg text")].filter((text) => {
  const box = text.getBoundingClientRect(), drawing = text.closest("svg").getBoundingClientRect();
  return text.checkVisibility() && (box.left < drawing.left - 2 || box.right > drawing.right + 2
    || box.top < drawing.top - 2 || box.bottom > drawing.bottom + 2);
}).map((text) => text.textContent)"""
UNREAD = """[...document.querySelectorAll("main :is(section, details, span, sup, code, data)")].filter((element) =>
  !element.closest("h1, h2, h3, summary, p, li, figcaption, th, td, pre, dt, dd, nav, svg, math, label")
  && [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim())
).map((element) => element.textContent.trim().slice(0, 99))"""
"""Text outside paragraphs, lists and tables."""
PUT_IN = """drawings => {
  for (const picture of document.querySelectorAll("main picture")) {
    const image = picture.querySelector("img"), isNarrow = matchMedia("(max-width: 30rem)").matches;
    const name = isNarrow ? picture.querySelector("source").srcset : image.getAttribute("src");
    const drawing = new DOMParser().parseFromString(drawings[name], "image/svg+xml").documentElement;
    drawing.querySelector("style").remove();
    drawing.setAttribute("role", "img");
    drawing.setAttribute("aria-label", image.alt);
    picture.replaceWith(drawing);
  }
}"""
"""Inserts drawings into the page, so that their parts can be measured."""
IN_PAGE = "test_every_page_fits_its_screen_and_can_be_read_by_all"
STOPS = """[...document.querySelectorAll("a[href], button, summary, [tabindex], video[controls]")]
  .filter((element) => element.tabIndex >= 0 && element.checkVisibility()).length"""


@pytest.fixture
def tab(browser, request) -> Iterator["sync_api.Page"]:
    """Return a tab with the screen and the colour scheme of the test, in which no error
    may occur.
    """
    screen, scheme = getattr(request, "param", ("desk", "light"))
    width, height = SCREENS[screen]
    context = browser.new_context(
        viewport={"width": width, "height": height},
        color_scheme=scheme,
        has_touch=screen == "phone",
        # This test puts drawings into pages, whose styles the policy would block.
        bypass_csp=request.node.originalname == IN_PAGE,
    )
    tab = context.new_page()
    problems: list[str] = []
    tab.on(
        "console",
        lambda said: (
            problems.append(said.text) if said.type in ("error", "warning") else None
        ),
    )
    tab.on("pageerror", lambda error: problems.append(str(error)))
    tab.on(
        "requestfailed",
        lambda request: problems.append(f"{request.failure}: {request.url}"),
    )
    yield tab
    context.close()
    # Messages about drawing without a graphics card, and about requests that a new page
    # cancels, do not count.
    assert [
        each
        for each in problems
        if "GL Driver Message" not in each and "net::ERR_ABORTED" not in each
    ] == []


def pages(site: Path) -> list[Path]:
    """Return all pages of the release that is shown first, and the front page of the
    newest other release.
    """
    return [
        *sorted(site.glob("*.html")),
        *sorted(site.glob("newton-*/index.html"))[-1:],
    ]


def open_page(tab, path: Path, fragment: str = "") -> None:
    tab.goto(path.as_uri() + fragment)


@pytest.mark.parametrize(
    "tab", [("desk", "light"), ("phone", "dark")], indirect=True, ids="-".join
)
def test_every_page_fits_its_screen_and_can_be_read_by_all(site, tab):
    axe = axe_core.AXE_FILE_PATH.read_text(encoding="utf-8")
    for path in pages(site):
        open_page(tab, path)
        drawings = {
            f"figures/{file.name}": file.read_text()
            for file in path.parent.glob("figures/*.svg")
        }
        tab.evaluate(PUT_IN, drawings)
        tab.evaluate(
            "document.querySelectorAll('.fold').forEach(each => each.open = true)"
        )
        assert (
            tab.evaluate("document.documentElement.scrollWidth")
            <= tab.viewport_size["width"]
        ), path.name
        assert tab.evaluate(TOO_WIDE) == [], path.name
        assert tab.evaluate(OUTSIDE) == [], path.name
        assert min(tab.evaluate(TEXT_SIZES), default=LEAST_TEXT_PX) >= LEAST_TEXT_PX, (
            path.name
        )
        assert tab.evaluate(STOPS) < MOST_STOPS, path.name
        if tab.viewport_size["width"] < 600:
            tab.set_viewport_size({"width": 320, "height": 640})
            assert tab.evaluate("document.documentElement.scrollWidth") <= 320, (
                path.name
            )
            tab.set_viewport_size(
                dict(zip(("width", "height"), SCREENS["phone"], strict=True))
            )
        if (
            path.name not in JUDGED
            or path.parent != site
            or (tab.viewport_size["width"] < 600 and path.stem == "cause")
        ):
            continue  # judging a page is slow, and on a phone only colours and targets differ
        tab.evaluate(axe)
        tab.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)")
        found = tab.evaluate(AXE)["violations"]
        assert [(rule["id"], rule["nodes"][0]["html"][:99]) for rule in found] == [], (
            path.name
        )


def test_the_policy_of_no_page_blocks_anything(site, tab):
    """Test that the tab collects requests that the policy blocks, and errors of
    scripts.
    """
    for path in pages(site):
        open_page(tab, path)


@pytest.mark.parametrize(
    ("tab", "screens"),
    [(("desk", "light"), 1), (("phone", "light"), 3)],
    indirect=["tab"],
)
def test_answers_come_first(site, tab, screens):
    """Test that problem, cause, fix and range of validity are on the first screen, or
    on the first three screens of a phone.
    """
    for path in site.glob("**/index.html"):
        open_page(tab, path)
        ends = {}
        for element in tab.locator("[data-answer]").all():
            box = element.bounding_box()
            ends[element.get_attribute("data-answer")] = box["y"] + box["height"]
        assert list(ends)[:4] == ["what", "why", "fix", "releases"], path
        assert max(ends.values()) < screens * tab.viewport_size["height"], (path, ends)
        assert tab.locator('[data-answer="fix"] pre').count() == 1
        for figure in tab.locator(
            "#story-frontier"
        ).all():  # the text that decides is on the next screen
            assert (
                figure.bounding_box()["y"]
                < (screens + 0.5) * tab.viewport_size["height"]
            ), path


def test_the_replay_reads_out_what_was_kept_and_moves_when_asked_to(site, tab):
    open_page(tab, site / "replay.html")
    rows = json.loads((site / f"data/newton-{own_release()}/poses.json").read_text())[
        "rows"
    ]
    slips = {row["case"]: row["slip_mm"] for row in rows}
    for number, case in enumerate(("as-shipped", "stiff-pads")):
        sync_api.expect(tab.locator(f'h2 [data-slip="{number}"]')).to_have_text(
            f"{slips[case]:.2f} mm"
        )
    clock = tab.locator("#clock")
    tab.keyboard.press("Home")
    sync_api.expect(clock).to_contain_text("−")
    start = clock.inner_text()
    tab.keyboard.press("Space")
    sync_api.expect(clock).not_to_have_text(start)
    tab.keyboard.press("Space")
    sync_api.expect(tab.locator("#play")).to_have_text("Play")


def assert_drawn(tab) -> None:
    """Test that each drawing with a file of its own is loaded when it becomes visible."""
    images = tab.locator("main picture img")
    assert images.count() > 0
    for image in images.all():
        image.scroll_into_view_if_needed()
        assert (
            image.evaluate("image => image.decode().then(() => image.naturalWidth)") > 0
        )


def test_no_markdown_is_left(site):
    """Test that the words of a claim are HTML."""
    for path in site.rglob("*.html"):
        if path.name not in OWN_PAGES:
            page = re.sub(
                r"<(pre|code|script)\b.*?</\1>",
                "",
                path.read_text(encoding="utf-8"),
                flags=re.DOTALL,
            )
            assert re.findall(r"\]\(|[*`]\w+[*`]", WORDLESS.sub(" ", page)) == [], path


def test_a_caption_has_at_most_35_words(site):
    for path in site.rglob("*.html"):
        page = re.sub(
            r"<details\b.*?</details>",
            "",
            path.read_text(encoding="utf-8"),
            flags=re.DOTALL,
        )
        for caption in re.findall(r"<figcaption.*?</figcaption>", page, re.DOTALL):
            said = (
                WORDLESS.sub("", caption).replace("\u202f", "").replace("&nbsp;", " ")
            )
            assert (
                len([word for word in said.split() if re.search(r"\w", word)]) <= 35
            ), (path.name, said)


def test_old_links_lead_on_and_the_contents_show_where_one_is(site, tab):
    open_page(tab, site / "index.html", "#friction")
    tab.wait_for_url("**/cause.html#friction")
    open_page(tab, site / "index.html", "#stability-maps")
    tab.wait_for_url("**/limits.html#stability-maps")
    open_page(tab, site / "cause.html", "#friction")
    tab.locator('.beside a[aria-current="location"][href="#friction"]').wait_for(
        timeout=5000
    )


def test_without_script_the_page_is_whole(site, browser):
    context = browser.new_context(java_script_enabled=False)
    tab = context.new_page()
    open_page(tab, site / "index.html", "#friction")
    assert (
        tab.locator(".index a#friction").get_attribute("href") == "cause.html#friction"
    )
    open_page(tab, site / "cause.html")
    assert tab.locator("main table tbody tr").count() > 1
    drawings = tab.locator("main picture img")
    assert tab.locator("main picture img:visible").count() == drawings.count() > 0
    assert_drawn(tab)
    assert tab.locator("button:visible").count() == 0
    assert tab.locator(".beside a[aria-current=page]").is_visible()
    open_page(tab, site / "replay.html")
    assert (
        tab.locator(".resting img").is_visible()
        and not tab.locator(".player").is_visible()
    )
    assert tab.locator("table tbody tr").count() > 1
    context.close()


def test_paper_has_no_controls_and_a_phone_keeps_heads_and_the_first_column(site, tab):
    tab.emulate_media(media="print")
    controls = "main :is(button, input, select):not(th button)"
    for name in ("index", "lab", "compare", "cause"):
        open_page(tab, site / f"{name}.html")
        assert tab.locator(controls).count() > 0
        assert tab.locator(f"{controls}:visible").count() == 0, name
    tab.emulate_media(media="screen")
    tab.set_viewport_size({"width": 390, "height": 844})
    open_page(tab, site / "compare.html")
    table = tab.locator("main .wide").first
    assert table.locator("thead th:visible").count() == table.locator("thead th").count()
    first = table.locator("tbody th").first
    before = first.bounding_box()["x"]
    last = table.locator("tbody tr").first.locator("td").last
    table.evaluate("box => box.scrollLeft = box.scrollWidth")
    assert first.bounding_box()["x"] == before and first.is_visible()
    assert last.bounding_box()["x"] > before + first.bounding_box()["width"] - 1


SLIPS = 'tbody td data[data-src$="/slip_mm"]'


HAS_SEVERAL = """(table) => [...table.querySelectorAll("tbody td")].some(
    (cell) => cell.querySelectorAll("data").length > 1)"""
"""Whether some cells of a table have several numbers, as those of the advice do."""


def open_table(tab, site: Path):
    """Open a page with an unsorted table of slips, and return the table."""
    for path in pages(site):
        open_page(tab, path)
        for table in tab.locator("main table").filter(has=tab.locator(SLIPS)).all():
            if table.evaluate(HAS_SEVERAL):
                continue
            slips = numbers(table, slip_column(table))
            if len(slips) > 2 and slips not in (
                sorted(slips),
                sorted(slips, reverse=True),
            ):
                tab.evaluate(
                    "for (const each of document.querySelectorAll('details')) each.open = true"
                )
                return table
    raise AssertionError("no page has a table of slips in no order")


def slip_column(table) -> int:
    return table.locator(SLIPS).first.evaluate(
        "number => number.closest('td').cellIndex"
    )


def numbers(table, column: int) -> list[float]:
    cells = table.locator(f"tbody tr > :nth-child({column + 1}) data")
    return [float(cell.get_attribute("value")) for cell in cells.all()]


def test_tables_are_sorted_by_a_click(site, tab):
    table = open_table(tab, site)
    column = slip_column(table)
    head = table.locator("thead th").nth(column)
    before = numbers(table, column)
    for expected in (sorted(before), sorted(before, reverse=True), before):
        head.locator("button").click()
        assert numbers(table, column) == expected


@pytest.mark.parametrize(
    "tab", [("desk", "light"), ("phone", "dark")], indirect=True, ids="-".join
)
def test_a_number_says_where_it_comes_from(site, tab):
    number = open_table(tab, site).locator(SLIPS).first
    if tab.viewport_size["width"] < 600:
        number.tap()
    else:
        number.hover()
    said = tab.locator("#origin").inner_text()
    source, _, pointer = number.get_attribute("data-src").partition("#")
    record = json.loads((site / "data" / source).read_text())
    row = record["rows"][int(pointer.split("/")[2])]
    assert f"{number.get_attribute('value')} mm" in said and "±" in said
    assert f"Newton {own_release()}" in said and record["measured"]["date"][:10] in said
    assert row["case"] in said
    tab.locator("#origin button").click()
    panel = tab.get_by_role("dialog")
    told = panel.inner_text()
    for expected in (
        row["case"],
        record["measured"]["commit"],
        f"make rerun SECTION={record['section']}",
        f"report/sections/{record['section']}",
        "measurements",
    ):
        assert expected in told
    for link in panel.get_by_role("link").all():
        assert (site / link.get_attribute("href").partition("#")[0]).is_file()
    tab.keyboard.press("Escape")
    sync_api.expect(panel).to_be_hidden()
    tab.keyboard.press("Escape")
    assert tab.locator("#origin").is_hidden()
    number.focus()
    tab.keyboard.press("Enter")
    sync_api.expect(panel).to_be_visible()


def test_a_derived_number_names_its_rows(site, tab):
    open_page(tab, site / "fix.html")
    values = json.loads((site / "data/values.json").read_text())
    for number in tab.locator('main data[data-src^="values.json"]').all()[:40]:
        _, section, name = number.get_attribute("data-src").partition("#")[2].split("/")
        sources = values[section][name]["sources"]
        if not sources or not all(".json#/rows/" in source for source in sources):
            continue
        number.focus()
        tab.keyboard.press("Enter")
        rows = tab.get_by_role("dialog").locator('a[href*="/rows/"]').all()
        hrefs = {row.get_attribute("href").removeprefix("data/") for row in rows}
        hrefs -= {number.get_attribute("data-src")}
        assert hrefs and hrefs <= {source.rpartition("/")[0] for source in sources}
        return
    raise AssertionError("no derived number reads cells")


FIRST_RESULTS = {
    "16384": ("One core or many worlds", "How fast do many worlds run?"),
    "16 384": ("One core or many worlds", "How fast do many worlds run?"),
    "license": ("Sources, licence and data",),
    "citation": ("Cite it",),
    "repository": ("Sources, licence and data",),
    "rerun": ("Sources, licence and data",),
    "nconmax": ("How fast do many worlds run?",),
    "njmax": ("How fast do many worlds run?",),
    "Isaac": ("How do other engines behave?", "The shake itself, in other engines"),
    "fp64": ("How large is the numerical error at a given run time?", "Does the cube also creep without the shake?", "Which runs are the results compared with?"),
    "rubber": ("Does the cube's material affect the contact?",),
    "tuning": ("Which setup to use",),
    "friction": ("Does too little friction cause the slip?",),
    "contact gap": ("Does the contact gap cause the slip?",),
    "noslip": ("Does the solver or the time step cause the slip?",),
    "memory per world": ("How fast do many worlds run?",),
    "1.6.1": ("How do the results change with another release?",),
}
"""A search for each word must find one of these sections first."""


def test_a_search_finds_the_section_about_a_word_first(site, tab):
    handler = partial(http.server.SimpleHTTPRequestHandler, directory=str(site))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        tab.goto(f"http://127.0.0.1:{server.server_port}/index.html")
        links = tab.locator(".search li a")
        for query, expected in FIRST_RESULTS.items():
            tab.locator(".search input").fill(query)
            sync_api.expect(links.first).to_have_text(re.compile("|".join(map(re.escape, expected))))
        tab.locator(".search input").fill("zebra")
        sync_api.expect(tab.locator(".search li")).to_have_text("No results.")
        server.shutdown()


def test_all_text_is_in_elements_that_the_search_reads(site, tab):
    for path in pages(site):
        if path.name not in OWN_PAGES:
            open_page(tab, path)
            assert tab.evaluate(UNREAD) == [], path


def test_the_reader_chooses_the_two_releases_that_are_compared(site, tab):
    open_page(tab, site / "compare.html")
    shown = tab.locator(".pairs > section:visible")
    assert shown.count() == 1
    tab.wait_for_load_state("load")
    assert tab.evaluate("scrollY") == 0, "the reader starts at the headlines"
    first, second = tab.locator(".choice select").all()
    first.select_option("1.8.0")
    second.select_option("1.4.0")
    assert shown.get_attribute("id") == "1.4.0..1.8.0"
    assert tab.url.endswith("#1.4.0..1.8.0")
    assert shown.locator("table").bounding_box()["width"] < 1000, "a text is too long"
    head = shown.locator("tbody tr").first
    assert head.get_attribute("class") == "relevant" and "flipped" in head.inner_text()
    second.select_option("1.7.0")
    rows = shown.locator("tbody tr").filter(has_text="slip")
    slip = rows.filter(has_text="0.317").first
    assert slip.get_attribute("class") is None, "its change is below the threshold"
    open_page(tab, site / "compare.html", "#1.5.0..1.6.1")
    assert shown.get_attribute("id") == "1.5.0..1.6.1"
    first.select_option("1.6.1")
    assert shown.count() == 0


def test_a_folded_section_opens_by_a_link_and_is_printed(site, tab):
    open_page(tab, site / "cause.html")
    text = sync_api.expect(tab.locator("#friction .claim").first)
    text.to_be_hidden()
    tab.emulate_media(media="print")
    text.to_be_visible()
    tab.emulate_media(media="screen")
    text.to_be_hidden()
    tab.evaluate("location.hash = 'friction'")
    text.to_be_visible()
    tab.locator("#friction summary").first.click()
    text.to_be_hidden()
    tab.locator('.beside a[href="#friction"]').click()
    text.to_be_visible()
