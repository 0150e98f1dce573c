"""The table of ``make status``: what it says of sections that are stale."""

from measured_report.editions.status import State, status_table


def test_each_change_is_said_once_with_its_sections():
    helper = "code: experiments/helper.py"
    states = [State("a", "stale", notes=(helper, "packages: newton 1 → 2")), State("b", "fresh")]
    _, *lines = status_table([*states, State("c", "stale", notes=(helper,))], "full").splitlines()
    assert [" ".join(line.split()).replace(" – – full", "") for line in lines] == [
        "a stale: code, packages",
        "b fresh",
        "c stale: code",
        "",
        f"{helper} (a, c)",
        "packages: newton 1 → 2 (a)",
    ]
    assert states[0].words == "code: experiments/helper.py; packages: newton 1 → 2"
