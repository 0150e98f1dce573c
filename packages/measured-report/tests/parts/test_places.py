"""Places: points of a table's column below each other, and ticks, sizes and marks of figures."""

import re

import pandas as pd
import pytest
from matplotlib import ticker
from matplotlib.text import Text

from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.parts import figures
from measured_report.parts.figures import LogLabels, draw_svgs, fold, new_figure
from measured_report.parts.section import FIGURE_SPACE, POINT_SPACE, Figure, Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import ResultsError


def mm(
    value, noise=None, unit="mm", source="newton-1.4.0/toy.json#/rows/0/slip_mm"
) -> Quantity:
    return Quantity(
        value, unit, source, "" if value is not None else "it fell", noise=noise
    )


def cells(*column) -> list[tuple[str, str]]:
    """Return what each cell of a column is filled with, and says."""
    html = Table(pd.DataFrame({"a": pd.Series(column, dtype=object)})).rendered().frame
    cells = re.findall(
        r'<td(?: class="number")? data-head="[^"]*"(?: data-fill="([^"]*)")?>(.*?)</td>',
        html,
    )
    return [(fill, re.sub("<[^>]*>", "", text)) for fill, text in cells]


def test_numbers_of_a_column_stand_with_their_points_below_each_other():
    fills = [
        ("", "6.36"),
        (FIGURE_SPACE, "0.5"),
        (POINT_SPACE + 2 * FIGURE_SPACE, "12"),
        ("", "yes"),
    ]
    assert cells(mm(6.36, 0.01), mm(0.5, 0.1), mm(12), True) == fills
    gone = (POINT_SPACE + FIGURE_SPACE, "n/a")
    assert cells(mm(0.5, 0.1), mm(None), mm(1.5e-9)) == [
        ("", "0.5"),
        gone,
        ("", "1.5\u202f×\u202f10⁻⁹"),
    ]
    assert cells("soft", None, "", False, mm(3)) == [
        ("", text) for text in ("soft", "n/a", "n/a", "no", "3")
    ]
    assert cells(mm(0.5, 0.1), mm(12, unit="N")) == [
        ("", "0.5&nbsp;mm"),
        ("", "12&nbsp;N"),
    ]
    assert (
        '<th scope="col" class="number">a [mm]</th>'
        in Table(pd.DataFrame({"a": [mm(1)]})).rendered().frame
    )
    with pytest.raises(ResultsError, match=r"the number 1\.5 in a table says nothing"):
        cells(mm(0.5), 1.5)


def test_a_figure_is_there_where_anything_of_it_is_and_says_why_it_is_not_drawn_where_something_lacks():
    assert [
        Figure(None, [*map(mm, values)]).is_there
        for values in ((None, 1.0), (None,), ())
    ] == [True, False, False]
    assert (
        "division by zero"
        in Figure(lambda: 1 / 0, [mm(1.0), mm(None)]).drawn("a", report().columns).fault
    )
    with pytest.raises(ReportError, match="division by zero"):
        Figure(lambda: 1 / 0, [mm(1.0)]).drawn("a", report().columns)


def axis(low, high):
    _, axes = new_figure()
    axes.set(xscale="log", xlim=(low, high))
    return axes.xaxis


RANGES = [
    (1e-4, 1e5, "0.001 1 10\u202f000 20"),
    (9e-5, 1.0, "10⁻³ 10⁰ 10⁴ 20"),
    (1.0, 1.1e5, "10⁻³ 10⁰ 10⁴ 20"),
]


@pytest.mark.parametrize(("low", "high", "labels"), RANGES)
def test_a_logarithmic_axis_has_powers_where_it_reaches_beyond_what_is_written_plainly(
    low, high, labels
):
    minor, bases = (
        LogLabels(labelOnlyBase=False, minor_thresholds=(99, 99)),
        LogLabels(labelOnlyBase=True),
    )
    for each in (minor, bases):
        each.set_axis(axis(low, high))
    assert [minor(value) for value in (1e-3, 1.0, 1e4, 20.0)] == labels.split(
        " "
    ) and bases(20.0) == ""


def test_ticks_stand_at_one_two_and_five_of_each_decade_or_where_they_are_asked_for():
    ticks = axis(1.0, 50.0)
    figures.tick_125(ticks)
    labels = {
        place: ticks.get_major_formatter()(place)
        for place in ticks.get_majorticklocs()
        if 1.0 <= place <= 50.0
    }
    assert labels == {1.0: "1", 2.0: "2", 5.0: "5", 10.0: "10", 20.0: "20", 50.0: "50"}
    figures.tick_at(ticks, [1.5, 100 / 3], digits=3)
    assert [
        ticks.get_major_formatter()(place) for place in ticks.get_majorticklocs()
    ] == ["1.5", "33.3"]
    assert not len(ticks.get_minorticklocs())
    assert (
        fold("a" * 30 + " bbbbb") == "a" * 30 + " bbbbb"
        and fold("a" * 30 + " bbbbbb") == "a" * 30 + "\nbbbbbb"
    )
    assert fold("slips of 12 mm\nb", 9) == "slips\nof 12 mm\nb"


def test_a_narrow_figure_has_its_panels_below_each_other_and_texts_that_can_be_read():
    seen = []

    def draw():
        drawing, (axes, other) = new_figure(7.2, 4.0, ncols=2)
        seen.append((figures.is_narrow(), [*drawing.get_size_inches()], drawing))
        axes.plot([0.0, 100.0], [1.0, 2.0], color=figures.FAINT)
        axes.text(0.0, 1.0, "small", fontsize=3)
        figures.say_value(other, 0.5, 0.5, figures.write(mm(6.36, 0.01)))
        other.set_yticks([0.0], ["a name of nineteen "])
        for name in ("a" * 17, "b" * 18, "c" * 19):
            axes.plot([0.0], [1.0], label=name)
        drawing.legend(loc="outside right upper", ncols=2)
        return drawing

    broad, narrow = draw_svgs(draw, name="n")
    assert [(is_small, size) for is_small, size, _ in seen] == [
        (False, [7.2, 4.0]),
        (True, [3.6, 8.0]),
    ]
    assert (broad.view, narrow.view) == ("0 0 518.4 288", "0 0 259.2 576"), (
        "72 points an inch"
    )
    assert (
        broad.size == [518, 288]
        and not figures.is_narrow()
        and "var(--faint)" in broad.content
    )
    texts = {
        text.get_text(): text.get_fontsize()
        for text in seen[1][2].findobj(Text)
        if text.get_text()
    }
    assert (
        min(texts.values()) == texts["small"] == texts["a name of nineteen"] == 7.0
        and texts["6.36"] == 8.5
    )
    x = seen[1][2].axes[0].xaxis
    assert x.get_ticklabels()[0].get_fontsize() == 8.0 and isinstance(
        x.get_major_locator(), ticker.MaxNLocator
    )
    assert x.get_major_locator().tick_values(0.0, 70.0).tolist() == [0, 20, 40, 60, 80]
    assert [each[2].legends[0]._ncols for each in seen] == [2, 1], (
        "one of its names has more than 18 characters"
    )
    assert (
        not re.search(r'(?<= )[xyd]="[^"]*\.\d{3}', broad.content)
        and 'data-src="newton' in narrow.content
    )


def test_a_mark_says_four_digits_and_the_nearest_name_and_numbers_are_told_apart_by_their_order():
    def draw():
        drawing, axes = new_figure()
        axes.plot([0.12341, 0.9], [0.1, 0.6], linestyle="", marker="o", markevery=1)
        axes.set(xlabel="slip [mm]", xlim=(0.0, 1.0), ylim=(-1.0, 2.0))
        axes.set_yticks([0, 1], ["soft", "stiff"])
        texts = [
            figures.write(mm(value, 0.01, source=f"a#{value}"), is_short=value > 7)
            for value in (6.36, 6.361, 7.361)
        ]
        axes.text(0.5, 0.5, " ".join(texts))
        return drawing

    broad, _ = draw_svgs(draw, name="m")
    assert re.findall("<title>(.*?)</title>", broad.content) == [
        "slip 0.1234 mm, soft",
        "slip 0.9 mm, stiff",
    ]
    assert (
        'data-src="a#6.36 a#6.361 a#7.361"' in broad.content
        and ">6.36 6.36 7.4</text>" in broad.content
    )
