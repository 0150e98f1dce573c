"""Test the field for the reader's own time step on the front page, in a real browser."""

import re
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread

import pytest

sync_api = pytest.importorskip(
    "playwright.sync_api", reason="there is no Playwright to look at the site with"
)

pytestmark = pytest.mark.words


@pytest.fixture
def tab(browser, site):
    context = browser.new_context()
    tab = context.new_page()
    tab.goto((site / "index.html").as_uri())
    yield tab
    context.close()


def slips(tab, column: int) -> list[tuple[float, float]]:
    """Return the steps [ms] and slips [mm] in a column of the table of steps."""
    rows = tab.locator("main table", has_text="run time").first.locator("tbody tr")
    values = rows.evaluate_all(
        """(rows, column) => rows.map((row) => [0, column].map(
            (place) => row.children[place].querySelector("data")?.value))""",
        column,
    )
    return [(float(step), float(slip)) for step, slip in values if slip]


@pytest.mark.parametrize(("contacts", "share"), [(0, 4), (1, 64)])
def test_a_measured_step_gives_its_pads_and_its_slip(tab, contacts, share):
    tab.select_option("#step-contacts", index=contacts)
    for step, slip in slips(tab, 4 + contacts):
        tab.fill("#step-ms", str(step))
        said = tab.inner_text("#step-slip")
        kd = round(1000 / step)
        assert f"kd {kd:g}," in said and f"about {float(f'{slip:.2g}'):g} mm" in said
        code = tab.inner_text("main pre >> nth=0")
        assert f"shape_material_kd[shape] = {kd:g}" in code
        ke = float(code.split("shape_material_ke[shape] = ")[1].split()[0])
        assert ke == pytest.approx(kd**2 / share, rel=0.006)


def test_between_two_steps_the_slip_is_between_theirs(tab):
    pairs = slips(tab, 4)
    (long, most), (short, least) = pairs[2], pairs[3]
    tab.fill("#step-ms", str((long + short) / 2).replace(".", ","))
    slip = float(tab.inner_text("#step-slip").split("about ")[1].split()[0])
    assert least < slip < most


def test_a_range_is_given_where_the_slip_is_not_proportional_to_the_step(tab):
    """Test a step at which the interpolated slip is 26 % below that of a run."""
    tab.fill("#step-ms", "0.347")
    low, high = (
        float(number)
        for number in re.search(
            r"between (\S+) and (\S+) mm", tab.inner_text("#step-slip")
        ).groups()
    )
    assert low < 0.1207 < high


def test_the_code_changes_only_if_the_reader_chooses_a_step(tab):
    code = "document.querySelector('main pre code').textContent"
    before = tab.evaluate(code)
    assert "[shape] = 250000" in before, "the measured stiff pads"
    tab.fill("#step-ms", "2.08")
    assert "[shape] = 250000" not in tab.evaluate(code)


def test_a_step_that_was_not_measured_leaves_the_code_as_it_is(tab):
    original = tab.inner_text("main pre >> nth=0")
    tab.fill("#step-ms", "2")
    assert tab.inner_text("main pre >> nth=0") != original
    tab.fill("#step-ms", "0.05")
    assert "shape_material_ke[shape] = 250000" in tab.inner_text("main pre >> nth=0")


@pytest.mark.parametrize(
    ("text", "said"), [("100", "was not measured"), ("", "type the length"), ("x", "type")]
)
def test_an_unusable_step_is_named(tab, text, said):
    tab.fill("#step-ms", text)
    assert said in tab.inner_text("#step-slip")


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def test_the_circle_in_the_figure_follows_the_step(browser, site):
    """Test the circle at a run, between two runs, and with other contacts."""
    server = ThreadingHTTPServer(("localhost", 0), partial(Quiet, directory=site))
    Thread(target=server.serve_forever, daemon=True).start()
    tab = browser.new_page()
    messages = []
    tab.on("console", lambda message: messages.append(message.text))
    tab.goto(f"http://localhost:{server.server_port}/index.html")
    mark = tab.locator("#step-mark")
    mark.wait_for(state="attached")
    tab.locator("#story-frontier img").scroll_into_view_if_needed()

    def place(step: float) -> list[float]:
        tab.fill("#step-ms", str(step))
        mark.wait_for(state="visible")
        return mark.evaluate(
            """mark => {
                const [circle, picture] = [mark, document.querySelector("#story-frontier img")]
                    .map((each) => each.getBoundingClientRect());
                return [
                    100 * (circle.x + circle.width / 2 - picture.x) / picture.width,
                    100 * (circle.y + circle.height / 2 - picture.y) / picture.height,
                ];
            }"""
        )

    (long, _), (short, _) = slips(tab, 4)[2:4]
    drawing = (site / "figures" / "story-frontier.svg").read_text(encoding="utf-8")
    width, height = map(float, re.search(r'viewBox="0 0 (\S+) (\S+)"', drawing).groups())
    line = drawing.split('id="line-by-rule"')[1]
    runs = [
        [100 * float(x) / width, 100 * float(y) / height]
        for x, y in re.findall(r'<use [^>]*x="(\S+)" y="(\S+)"', line)[2:4]
    ]
    assert place(long) == pytest.approx(runs[0], abs=0.3)
    assert place(short) == pytest.approx(runs[1], abs=0.3)
    between = place((long * short) ** 0.5)
    assert between == pytest.approx([sum(pair) / 2 for pair in zip(*runs)], abs=0.3)
    tab.select_option("#step-contacts", index=1)
    mark.wait_for(state="hidden")
    assert messages == []
    server.shutdown()
    tab.close()


def test_without_script_the_note_and_the_table_remain(browser, site):
    context = browser.new_context(java_script_enabled=False)
    tab = context.new_page()
    tab.goto((site / "index.html").as_uri())
    assert tab.locator("#step-note").is_visible()
    assert not tab.locator("#step-choice").is_visible()
    assert len(slips(tab, 4)) >= 7
    context.close()
