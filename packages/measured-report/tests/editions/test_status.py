"""Test the report of ``make status`` about stale sections."""

from measured_report.commands.status import changes_text
from measured_report.editions.status import State


def test_each_change_is_said_once_with_its_sections():
    helper = "code: experiments/helper.py"
    states = [
        State("a", "stale", notes=(helper, "packages: newton 1 → 2")),
        State("c", "stale", notes=(helper,)),
    ]
    assert (
        changes_text([*states, State("b", "fresh")])
        == f"{helper} (a, c)\npackages: newton 1 → 2 (a)"
    )
    assert states[0].words == "code: experiments/helper.py; packages: newton 1 → 2"
    assert states[0].summary == "stale: code, packages"
