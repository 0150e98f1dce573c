"""Figures for broad and for narrow screens."""

import re

import pytest

from measured_report.parts.figures import NARROW_WIDTH, draw_svgs, is_narrow, new_figure
from measured_report.parts.macros import macros

WIDTH = re.compile(r'viewBox="0 0 ([\d.]+) ')


def test_names_of_a_legend_stand_one_below_the_other_where_it_is_narrow():
    found = []

    def draw():
        drawing, axes = new_figure()
        found.append(is_narrow())
        for label in ("a label that is long", "another one of that kind"):
            axes.plot([1.0, 500.0], label=label)
        axes.set_yscale("log")
        drawing.legend(loc="outside upper center", ncols=4)
        return drawing

    broad, narrow = (macros().drawing(picture, "", ()) for picture in draw_svgs(draw, name="toy"))
    assert found == [False, True] and not is_narrow()
    assert [float(WIDTH.search(svg)[1]) for svg in (broad, narrow)] == [7.2 * 72, pytest.approx(NARROW_WIDTH * 72)]
    places = [re.findall(r'x="([\d.]+)" y="([\d.]+)"[^>]*>a(?:nother one| label)', svg) for svg in (broad, narrow)]
    assert [len({y for _, y in each}) for each in places] == [1, 2]


def test_a_mark_says_what_it_stands_for_and_a_tick_does_not():
    def draw():
        drawing, axes = new_figure()
        axes.plot([1.0, 100.0], [0, 1], marker="o", markevery=1, label="a series")
        axes.set(xscale="log", xlabel="slip [mm]")
        axes.set_yticks([0, 1], ["shipped pads", "stiff pads"])
        axes.legend()
        return drawing

    broad, _ = draw_svgs(draw, name="toy")
    said = re.findall("<title>(.*?)</title>", broad.content)
    assert said == ["slip 1 mm, shipped pads", "slip 100 mm, stiff pads"]
