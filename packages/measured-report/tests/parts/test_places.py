"""Test the alignment of a table's columns, and the ticks, sizes and marks of figures."""

import re

import pandas as pd
import pytest
from matplotlib import ticker
from matplotlib.text import Text

from measured_report.files.errors import ReportError
from measured_report.parts import figures
from measured_report.parts.figures import draw_svgs, fold, new_figure
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
    """Return the fill and the text of each cell in a column."""
    html = Table(pd.DataFrame({"a": pd.Series(column, dtype=object)})).rendered().frame
    cells = re.findall(
        r'<td(?: class="number")?(?: data-fill="([^"]*)")?>(.*?)</td>',
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
    with pytest.raises(
        ResultsError, match=r"the number 1\.5 in a table does not have a source"
    ):
        cells(mm(0.5), 1.5)


def test_a_figure_is_there_where_anything_of_it_is_and_says_why_it_is_not_drawn_where_something_lacks():
    assert [
        Figure(None, [*map(mm, values)]).is_there
        for values in ((None, 1.0), (None,), ())
    ] == [True, False, False]
    assert (
        "division by zero"
        in Figure(lambda: 1 / 0, [mm(1.0), mm(None)]).drawn("a").fault
    )
    with pytest.raises(ReportError, match="division by zero"):
        Figure(lambda: 1 / 0, [mm(1.0)]).drawn("a")


def axis(low, high):
    _, axes = new_figure()
    axes.set(xscale="log", xlim=(low, high))
    return axes.xaxis


RANGES = [
    (1e-4, 1e5, "0.001 1 10\u202f000"),
    (9e-5, 1.0, "10⁻³ 10⁰ 10⁴"),
    (1.0, 1.1e5, "10⁻³ 10⁰ 10⁴"),
]


@pytest.mark.parametrize(("low", "high", "labels"), RANGES)
def test_a_logarithmic_axis_has_powers_where_it_reaches_beyond_what_is_written_plainly(
    low, high, labels
):
    ticks = axis(low, high)
    figures._label_decades(ticks)
    label = ticks.get_major_formatter()
    assert [label(value) for value in (1e-3, 1.0, 1e4)] == labels.split(" ")
    assert not len(ticks.get_minorticklocs())


def test_a_text_is_folded_and_a_number_stays_with_the_word_before_it():
    assert fold("a" * 30 + " bbbbb") == "a" * 30 + " bbbbb"
    assert fold("a" * 30 + " bbbbbb") == "a" * 30 + "\nbbbbbb"
    assert fold("slips of 12 mm\nb", 9) == "slips\nof 12 mm\nb"


@pytest.mark.parametrize(("points", "marks"), [(7, 7), (40, 40), (1000, 20)])
def test_each_point_has_a_mark_unless_a_line_is_long(points, marks):
    def draw():
        drawing, axes = new_figure()
        axes.plot([x**0.1 for x in range(points)], [x**3 for x in range(points)])
        return drawing

    broad, _ = draw_svgs(draw, name="a")
    found = broad[broad.index("line2d_") :].count("fill: var(--series-1)")
    assert found == marks if points < 1000 else 3 < found < marks


def line_in(**settings):
    drawing, axes = new_figure()
    axes.plot([0.0, 1.0, 2.0], [-1.0, 1.0, 2.0], label="a line")
    axes.set(**settings)
    return drawing, axes


@pytest.mark.parametrize("settings", [{"yscale": "log"}, {"ylim": (0.0, 5.0)}])
def test_a_line_above_or_below_its_axes_is_refused(settings):
    drawing, axes = line_in(**settings)
    axes.legend()
    with pytest.raises(ReportError, match="the line 'a line' leaves its axes"):
        draw_svgs(lambda: drawing, name="a")


def test_a_label_that_no_legend_shows_is_refused_and_a_part_of_a_line_can_be_left_out():
    drawing, axes = line_in(xlim=(0.5, 3.0), ylim=(0.5, 3.0))
    axes.axvline(1.0, label="a mark")
    with pytest.raises(ReportError, match="the label 'a line' is not shown"):
        draw_svgs(lambda: drawing, name="a")
    axes.legend()
    assert draw_svgs(lambda: drawing, name="a")


def test_a_narrow_figure_has_its_panels_below_each_other_and_texts_that_can_be_read():
    seen = []

    def draw():
        drawing, (axes, other) = new_figure(7.2, 4.0, ncols=2)
        seen.append((figures.is_narrow(), [*drawing.get_size_inches()], drawing))
        axes.plot([0.0, 100.0], [1.0, 2.0], color=figures.FAINT)
        axes.text(0.0, 1.0, "small", fontsize=3)
        other.text(0.5, 0.5, mm(6.36, 0.01).written, fontsize=8.5)
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
    # There are 72 points in an inch.
    assert 'viewBox="0 0 518.4 288"' in broad
    assert 'viewBox="0 0 259.2 576"' in narrow
    assert not figures.is_narrow()
    assert "var(--faint)" in broad
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
    assert not re.search(r'(?<= )[xyd]="[^"]*\.\d{3}', broad)
    assert ">6.36</text>" in narrow
