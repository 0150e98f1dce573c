"""Test bisect and history on existing records and in a small repository."""

import shutil
from argparse import Namespace
from dataclasses import replace

import pytest
from toys import ROWS, SCENE, Toy, git

from measured_report.changes import bisect as module
from measured_report.changes.bisect import Bisection, first_change, points_between
from measured_report.changes.compare import flips
from measured_report.changes.query import Query, history
from measured_report.commands import bisect as command
from measured_report.editions.release import release_of
from measured_report.files.config import report
from measured_report.files.errors import ReportError, UsageError
from measured_report.findings.editions import editions_of
from measured_report.records.record import write_record

SOFT, STIFF = ROWS
WORSE = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""Rows with which the toy's claim fails."""
OLD = {"warp-lang": "1.15.0", "mujoco-warp": "3.10.0", "mujoco": "3.10.0"}
NEW = {"warp-lang": "1.16.0", "mujoco-warp": "3.11.0", "mujoco": "3.11.0"}


def test_the_first_change_is_found_wherever_it_is_and_what_cannot_tell_is_passed_over_and_named():
    for count in (2, 3, 8, 9):
        for change in range(1, count):
            assert first_change(
                range(count), lambda point, change=change: point < change
            ) == (change - 1, change, [])
    found = first_change(range(8), lambda point: None if point in (3, 4) else point < 4)
    assert found == (2, 5, [3, 4])


def keep(toy: Toy, release: str, rows, packages: dict[str, str]) -> None:
    """Record the result of a release as if it had been measured."""
    side = toy.of(release)
    newton = release.partition("+")[0]
    record = side.record(rows)
    identity = replace(record.identity, packages={"newton": newton, **packages})
    write_record(side.record_path, replace(record, identity=identity))


MIDDLE = ("1.5.9", "1.6.9", "1.7.9")


@pytest.fixture
def search(toy, monkeypatch) -> Bisection:
    """Test that the toy's claim holds up to 1.5.9 and fails from 1.6.9 on.

    These releases cannot be installed.
    """
    monkeypatch.setattr(
        module, "releases_between", lambda first, last: [*map(release_of, MIDDLE)]
    )
    keep(toy, "1.5.9", ROWS, OLD)
    for release in ("1.6.9", "1.7.9", "1.8.9"):
        keep(toy, release, WORSE, NEW)
    return Bisection(toy.project, Query("toy.helps", True), "cpu")


def searched(search: Bisection, last: str = "1.8.9") -> list[str]:
    return module.bisect(search, release_of("1.4.0"), release_of(last)).splitlines()


def test_the_release_and_then_newton_itself(toy, search, capsys):
    keep(toy, "1.5.9+warp-1.16.0", ROWS, {**OLD, "warp-lang": "1.16.0"})
    keep(toy, "1.5.9+mujoco-3.11.0+mujoco-warp-3.11.0+warp-1.16.0", ROWS, NEW)
    assert searched(search) == [
        "toy.helps changes between 1.5.9 and 1.6.9: holds → fails",
        "the cause is newton: 1.5.9+mujoco-3.11.0+mujoco-warp-3.11.0+warp-1.16.0 has the old answer, and 1.6.9 the new one",
    ]
    assert "1.7.9" not in capsys.readouterr().out, (
        "what lies behind the change is not asked"
    )
    found = searched(replace(search, query=Query("toy.soft.slip_mm", False)))
    assert found[0].startswith("toy.soft.slip_mm changes between 1.5.9")


def test_an_older_edition_that_cannot_run_with_newer_packages_gives_way_to_a_newer_one(
    toy, search, monkeypatch
):
    """The newer engine consists of one more package, which the older one lacks."""
    split = {**NEW, "mujoco-core": "3.11.0"}
    keep(toy, "1.6.9", WORSE, split)
    keep(toy, "1.5.9+warp-1.16.0", ROWS, {**OLD, "warp-lang": "1.16.0"})
    older = "1.6.9+mujoco-3.10.0+mujoco-warp-3.10.0"
    keep(toy, f"{older}+warp-1.15.0", ROWS, OLD)
    keep(toy, older, ROWS, {**OLD, "warp-lang": "1.16.0"})
    asked = []

    def fail(project, release, *others):
        asked.append(str(release))
        raise ReportError("newton 1.5.9 cannot run the scene")

    monkeypatch.setattr(module, "measure", fail)
    assert searched(search)[1] == (
        f"the cause is mujoco-warp and mujoco and mujoco-core: {older} has the old "
        "answer, and 1.6.9 the new one"
    )
    assert asked == ["1.5.9+mujoco-3.11.0+mujoco-warp-3.11.0+warp-1.16.0"]


def test_what_cannot_be_measured_is_passed_over_and_an_end_ends_the_search_as_ends_that_agree_do(
    search, monkeypatch
):
    """Test that bisect does not begin with full runs, which take hours."""

    def fail(project, release, *others):
        raise ReportError("measuring ended")

    monkeypatch.setattr(module, "measure", fail)
    shutil.rmtree(search.project.of("1.6.9").results)
    assert searched(search)[:2] == [
        "toy.helps changes between 1.5.9 and 1.7.9: holds → fails",
        "no answer from 1.6.9: the first edition with the new answer is one of these or 1.7.9",
    ]
    assert (
        searched(search)[2]
        == "the cause is one of warp-lang or mujoco-warp and mujoco and mujoco-core or newton"
    )
    with pytest.raises(ReportError, match="measuring ended") as error:
        searched(search, "1.9.0")
    assert not isinstance(error.value, UsageError)
    with pytest.raises(
        UsageError,
        match=r"claim .* does not exist: use the name of a claim \(similar: toy",
    ):
        searched(replace(search, query=Query("toy.halps", True)))
    with pytest.raises(UsageError, match=r"from A \(holds\) to B \(holds\)"):
        searched(search, "1.5.9")


def test_what_a_search_measured_by_code_of_before_is_measured_again(
    toy, search, monkeypatch
):
    side = replace(search.project.of("1.5.9"), aside=module.ASIDE)
    side.results.parent.mkdir(parents=True)
    search.project.of("1.5.9").results.rename(side.results)
    assert searched(search)[0].startswith("toy.helps changes between 1.5.9")
    toy.write("experiments/scene.py", SCENE.replace("1.0 if", "2.0 if"))
    monkeypatch.setattr(
        module, "measure", lambda side, release, *_: 1 / (str(release) != "1.5.9")
    )
    with pytest.raises(ZeroDivisionError):
        searched(search)


def test_between_two_commits_of_one_repository_its_commits_are_searched(toy, checkout):
    for value in range(2, 5):
        (checkout / "newton/__init__.py").write_text(f"x = {value}\n")
        git(checkout, "commit", "--quiet", "-a", "-m", f"x is {value}")
    commits = git(checkout, "rev-list", "--reverse", "HEAD").split()
    first, last = (
        release_of(f"{checkout}@{reference}") for reference in (commits[0], "main")
    )
    points = points_between(toy.project, first, last)
    folder = first.spec.rpartition("@")[0]
    assert points == [
        first.spec,
        *(f"{folder}@{commit}" for commit in commits[1:3]),
        last.spec,
    ]
    assert release_of(points[1]).source == f"g{commits[1][:7]}"
    assert points_between(toy.project, first, release_of("1.4.0")) == [
        first.spec,
        "1.4.0",
    ]


@pytest.fixture
def told(search, toy):
    """Return the answers of all the toy's editions in the form that a history reads."""
    editions = editions_of(toy.project)
    return {release: edition.uncompared for release, edition in editions.items()}


def test_a_history_has_every_edition_and_says_what_moved_and_flipped(told):
    lines = history(told, Query("toy.soft.slip_mm", False)).splitlines()
    assert [line.split() for line in lines[1:4]] == [
        ["1.4.0", "6.362"],
        ["1.5.9", "6.362"],
        ["1.6.9", "0.4", "better"],
    ]
    lines = history(told, Query("toy.helps", True)).splitlines()
    assert [" ".join(line.split()) for line in lines[1:4]] == [
        "1.4.0 holds",
        "1.5.9 holds",
        "1.6.9 fails flipped",
    ]
    assert history(told, Query("toy.soft.dropped", False)).splitlines()[1].split() == [
        "1.4.0",
        "0",
    ]
    assert history(told, Query("toy.soft.nothing_mm", False)).splitlines()[1:] == [
        "no edition can tell"
    ]
    (flip,) = flips(told, "1.4.0")
    said = {tuple(names): claim.outcome.answer for names, claim in flip.answers}
    assert said == {("1.4.0", "1.5.9"): "holds", ("1.6.9", "1.7.9", "1.8.9"): "fails"}


def test_a_search_writes_nothing_beside_the_tracked_results_and_names_full_runs(
    toy, search, monkeypatch, capsys
):
    measured = []

    def note(project, release, sections, device):
        measured.append(project)
        return toy.project.of("1.5.9")

    monkeypatch.setattr(module, "measure", note)
    monkeypatch.setattr(
        module, "releases_between", lambda first, last: [release_of("1.5.9")]
    )
    search.answer(release_of("1.4.9"))
    assert [
        side.results.relative_to(toy.project.root).as_posix() for side in measured
    ] == ["results/bisect/full/newton-1.4.9"]
    assert capsys.readouterr().out == "1.4.9: toy.helps holds\n"
    ends = {"a": release_of("1.4.0"), "b": release_of("1.5.9")}
    asked = Namespace(claim="toy.helps", value="", device="cpu", **ends)
    with pytest.raises(UsageError, match="PROFILE=full measures more precisely"):
        command.run(replace(toy.project, profile="quick"), asked)


@pytest.mark.parametrize(
    ("noise", "first", "asked"),
    [("toy", "holds", 1), ("toy", None, 2), ("", "holds", 1), ("", None, 1)],
)
def test_the_section_on_noise_is_measured_only_if_nothing_can_be_told_without_it(
    search, monkeypatch, noise, first, asked
):
    calls = []

    def measured(self, release, names):
        calls.append(names)
        return first if len(calls) == 1 else "fails"

    monkeypatch.setattr(Bisection, "_measured", measured)
    settings = replace(report().settings, noise_section=noise)
    monkeypatch.setitem(vars(report()), "settings", settings)
    answer = search.answer(release_of("1.5.9"))
    assert calls == [["toy"], ["toy", "toy"]][:asked]
    assert answer == ("fails" if asked == 2 else first)
