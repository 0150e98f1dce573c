"""The table of ``make status``: what it says of sections that are stale."""

from measured_report.editions.status import State, status_table


def table(*states: State) -> list[str]:
    """Its lines without the heading and without the columns that say where and when."""
    return [" ".join(line.split()).replace(" – – full", "") for line in status_table(states, "full").splitlines()[1:]]


def stale(section: str, *notes: str) -> State:
    return State(section, "stale", notes=notes)


def test_each_change_is_said_once():
    helper, task = "code: experiments/helper.py", "code: experiments/task.py"
    assert table(
        stale("a", helper, task, "packages: newton 1 → 2"),
        State("b", "fresh"),
        stale("c", "code: experiments/c.py", helper, task, "config: assets/robot.urdf", "packages: newton 1 → 2"),
        stale("d", helper),
        stale("e", helper, "code: experiments/e.py", "code: experiments/f.py"),
    ) == [
        "a stale [1] [2]",
        "b fresh",
        "c stale [1] [2] code: experiments/c.py; config: assets/robot.urdf",
        "d stale [1]",
        "e stale [1] code: experiments/e.py, experiments/f.py",
        "",
        "[1] code: experiments/helper.py",
        "[2] code: experiments/task.py; packages: newton 1 → 2",
    ]


def test_what_no_other_section_has_is_said_beside_it_and_so_is_damage():
    assert table(stale("a", "code: experiments/a.py"), stale("b", "code")) == [
        "a stale code: experiments/a.py",
        "b stale code",
    ]
    damaged = State("a", "damaged", notes=("newton-1.4.0/a.json: is empty",))
    assert table(damaged, damaged) == ["a damaged newton-1.4.0/a.json: is empty"] * 2
