"""Test the ticks and the numbers of figures."""

from itertools import combinations

from report.shared.drawing import format_short, name_ends, new_figure, tick_125, tick_at


def test_ticks_stand_at_one_two_and_five_of_each_decade_or_where_they_are_asked_for():
    _, axes = new_figure()
    axes.set(xscale="log", xlim=(1.0, 50.0))
    ticks = axes.xaxis
    tick_125(ticks)
    labels = {
        place: ticks.get_major_formatter()(place)
        for place in ticks.get_majorticklocs()
        if 1.0 <= place <= 50.0
    }
    assert labels == {1.0: "1", 2.0: "2", 5.0: "5", 10.0: "10", 20.0: "20", 50.0: "50"}
    tick_at(ticks, [1.5, 100 / 3], digits=3)
    assert [
        ticks.get_major_formatter()(place) for place in ticks.get_majorticklocs()
    ] == ["1.5", "33.3"]
    assert not len(ticks.get_minorticklocs())


def test_names_of_lines_that_end_close_together_do_not_overlap():
    """Lines end at 0.116 and 0.111 mm, as in the figure of the time step in 1.8.0."""
    drawing, axes = new_figure(7.2, 4.2)
    axes.set(xscale="log", yscale="log", xlim=(0.02, 20.0), ylim=(0.01, 5.0))
    ends = [
        (0.13, 0.111, "the rule", "k"),
        (0.13, 0.116, "the same stiff pads", "k"),
        (0.26, 0.055, "MuJoCo C, the rule", "k"),
        (8.0, 0.1, "far away", "k"),
    ]
    name_ends(axes, ends, offset=-6, near=3.0, ha="right")
    drawing.draw_without_rendering()
    boxes = {text.get_text(): text.get_window_extent() for text in axes.texts}
    assert not any(boxes[a].overlaps(boxes[b]) for a, b in combinations(boxes, 2))
    assert [text.xy[1] for text in axes.texts if text.get_text() == "far away"] == [0.1]


def test_a_short_number_has_two_digits_and_halves_go_up():
    short = {
        0.0: "<.01",
        0.00499: "<.01",
        0.005: ".01",
        0.0949: ".09",
        0.095: "0.1",
        0.25: "0.3",
        1.25: "1.3",
    }
    short |= {9.949: "9.9", 9.95: "10", 10.5: "11", 98.4: "98"}
    short |= {-5.0: "−5.0", -0.02: "−.02", -0.001: "<.01"}
    assert {value: format_short(value) for value in short} == short
