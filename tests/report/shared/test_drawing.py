"""Test the ticks and the numbers of figures."""

from report.shared.drawing import new_figure, tick_125, tick_at


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
