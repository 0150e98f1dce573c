"""Test the environment of another release: its requirements, and the packages of its
release date.
"""

from dataclasses import replace

import pytest
from toys import ROWS

from measured_report.editions import environment
from measured_report.editions.environment import python_of, requirements
from measured_report.editions.release import release_of
from measured_report.editions.status import expected_packages
from measured_report.files.config import report
from measured_report.records.identity import MISSING
from measured_report.records.record import write_record

DEPENDENCIES = """
[project]
dependencies = ["newton[sim]==1.4.0", "numpy>=2", "warp-lang==1.15.0", "mujoco", "tqdm"]
"""


@pytest.mark.parametrize(
    ("packages", "expected"),
    [
        ({}, ["numpy>=2", "tqdm"]),
        ({"newton": "1.8.0"}, ["numpy>=2", "tqdm", "newton[sim]==1.8.0"]),
        (
            {"newton": MISSING, "warp-lang": "1.16.0", "mujoco": "3.11.0"},
            ["numpy>=2", "tqdm", "warp-lang==1.16.0", "mujoco==3.11.0"],
        ),
    ],
)
def test_measured_packages_are_replaced_and_all_others_are_kept(
    toy, packages, expected
):
    """Test that a measured package without a version is installed as the release
    requires it.
    """
    toy.write("pyproject.toml", DEPENDENCIES)
    assert requirements(toy.project.root, packages, report().settings) == expected


@pytest.fixture
def commands(toy, monkeypatch) -> list[list[str]]:
    """Test the commands that are passed to uv.

    Their effects are tested in test_rehearsal.py.
    """
    called = []
    monkeypatch.setattr(
        environment, "_run", lambda words, name: called.append([*words])
    )
    monkeypatch.setattr(environment, "release_date", lambda release: "2026-02-28")
    monkeypatch.delenv(environment.FILTER, raising=False)
    toy.write("pyproject.toml", DEPENDENCIES)
    return called


def test_an_environment_has_the_packages_of_the_release_date(toy, commands, capsys):
    packages = {"newton": "1.4.0", "warp-lang": "1.15.0", "mujoco": MISSING}
    release = release_of("1.8.0", "mujoco==3.12.0")
    python = python_of(release, packages, toy.project.root)
    folder = toy.project.root / ".venv-newton-1.8.0+mujoco-3.12.0"
    assert python == folder / "bin/python"
    made, installed = commands
    assert made[:2] == ["venv", "--clear"]
    options = installed[installed.index("--exclude-newer") :]
    assert options == [
        *("--exclude-newer", "2026-03-01T00:00:00Z"),
        *("--exclude-newer-package", "warp-lang=2100-01-01"),
        *("--exclude-newer-package", "mujoco=2100-01-01"),
        *("numpy>=2", "tqdm", "warp-lang==1.15.0", "mujoco==3.12.0"),
        "newton[sim]==1.8.0",
    ]
    assert (folder / "overrides.txt").read_text() == "mujoco==3.12.0"
    assert "was released on 2026-02-28" in capsys.readouterr().out
    python_of(release, packages, toy.project.root)
    assert len(commands) == 2  # it is complete


def test_an_environment_follows_pyproject(toy, commands):
    release = release_of("1.8.0")
    python_of(release, {}, toy.project.root)
    own = DEPENDENCIES.replace("1.4.0", "1.9.0").replace("1.15.0", "1.16.0")
    toy.write("pyproject.toml", own)
    python_of(release, {"warp-lang": "1.16.0"}, toy.project.root)
    assert len(commands) == 2, "packages that are measured are those of the release"
    toy.write("pyproject.toml", DEPENDENCIES.replace('"tqdm"', '"tqdm", "torch"'))
    python_of(release, {}, toy.project.root)
    assert len(commands) == 4 and "torch" in commands[-1]


def test_the_date_can_be_replaced_and_the_installed_release_needs_nothing(
    toy, commands, monkeypatch
):
    monkeypatch.setenv(environment.FILTER, "2026-05-01")
    python_of(release_of("1.8.0"), {}, toy.project.root)
    assert "--exclude-newer" not in commands[1]
    commands.clear()
    assert python_of(release_of("1.4.0"), {}, toy.project.root) == environment.Path(
        environment.sys.executable
    )
    assert commands == []


def test_an_environment_that_could_not_be_made_is_removed(toy, commands, monkeypatch):
    def fail(words, name):
        commands.append([*words])
        if words[0] == "pip":
            raise KeyboardInterrupt

    monkeypatch.setattr(environment, "_run", fail)
    with pytest.raises(KeyboardInterrupt):
        python_of(release_of("1.8.0"), {}, toy.project.root)
    assert not (toy.project.root / ".venv-newton-1.8.0").exists()


def test_the_newest_record_names_the_packages_of_an_edition(toy):
    newer = toy.of("1.8.0")
    for section, version, day in (
        ("a", "1.16.0", "03"),
        ("toy", "1.17.0", "05"),
        ("z", "1.18.0", "04"),
    ):
        toy.write(f"report/sections/{section}.py", "def derive(results): ...\n")
        record = newer.record(ROWS, section=section)
        packages = {**record.identity.packages, "warp-lang": version}
        measured = {**record.measured, "date": f"2026-01-{day}T03:04:05+00:00"}
        record = replace(
            record,
            identity=replace(record.identity, packages=packages),
            measured=measured,
        )
        write_record(newer.project.record_path(section), record)
    assert expected_packages(newer.project)["warp-lang"] == "1.17.0"
