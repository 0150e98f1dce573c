"""Figures for broad and for narrow screens."""

import re

from measured_report.parts.figures import draw_svgs, new_figure


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
