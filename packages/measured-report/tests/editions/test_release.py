"""Test the meaning of NEWTON and WITH, the labels of releases, and that the installed
release is the requested one. A small repository named newton stands for a checkout, and
no test simulates.
"""

import hashlib
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from toys import git

from measured_report.commands.options import read_address
from measured_report.editions import environment
from measured_report.editions.project import own_release
from measured_report.editions.release import read_label, release_of
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring import machine, measure
from measured_report.measuring.run import edition_of
from measured_report.records.identity import package_versions


@pytest.mark.parametrize(
    ("text", "label"),
    [
        ("1.8", "1.8.0"),
        ("1.8.0", "1.8.0"),
        ("1.9.0rc1", "1.9.0rc1"),
        ("1.9.0.dev20261122", "1.9.0.dev20261122"),
        ("1.8+warp-1.19+mujoco-warp-4.0.0", "1.8.0+mujoco-warp-4.0.0+warp-1.19"),
        ("1.9.0.dev0+g1a2b3c4", "1.9.0.dev0+g1a2b3c4"),
        ("1.8.0@nvidia-h100", "1.8.0@nvidia-h100"),
    ],
)
def test_a_label_is_read(text, label):
    assert str(read_label(text)) == label
    for wrong in (
        "new",
        "",
        "1",
        "1.8.0+",
        "1.8.0@",
        "1.8.0+warp",
        "../1.8.0",
        "1.8.0+g1",
        "1.8.0@A/B",
    ):
        assert read_label(wrong) is None


def test_a_commit_is_called_after_itself_wherever_it_is_from(checkout):
    first = git(checkout, "rev-parse", "HEAD")
    (checkout / "pyproject.toml").write_text(
        '[project]\nname = "newton"\nversion = "1.10.0.dev0"\n'
    )
    git(checkout, "commit", "--quiet", "-a", "-m", "two")
    named = {
        release_of(f"{where}@{first}") for where in (checkout, f"git+file://{checkout}")
    }
    assert {str(release) for release in named} == {f"1.9.0.dev0+g{first[:7]}"}
    assert {release.requirement for release in named} == {
        f"newton[sim] @ git+file://{checkout}@{first}"
    }
    assert str(release_of(f"{checkout}@main")).startswith("1.10.0.dev0+g")
    with pytest.raises(UsageError, match="cannot be fetched"):
        release_of(f"{checkout}@nothing")


@pytest.mark.parametrize(
    "address",
    ["http://user:TOKEN@h/x.git@m", "https://TOKEN@h/x.git@m", "ssh://a:TOKEN@h/x@m"],
)
@pytest.mark.parametrize("ending", ["", "?private=TOKEN"])
def test_an_address_with_what_opens_it_is_refused_and_not_printed(address, ending):
    for spec in (f"git+{address}{ending}", f"git+{address.removesuffix('@m')}"):
        with pytest.raises(UsageError, match=r"^[^\n]+$") as error:
            release_of(spec)
        assert "TOKEN" not in str(error.value)
    with pytest.raises(UsageError):
        read_address(address)


def test_what_is_kept_of_a_path_names_nobody(
    toy, checkout, monkeypatch, tmp_path_factory
):
    home = tmp_path_factory.mktemp("home") / "NAME"
    monkeypatch.setenv("HOME", str(home))
    shutil.copytree(checkout, home / "x/newton")
    specs = {
        f"{checkout}@main": "../newton@main",
        f"{home}/x/newton@main": "~/x/newton@main",
        f"git+file://{checkout}@main": "../newton@main",
    }
    for spec, asked in specs.items():
        release = release_of(spec)
        assert (
            release.spec == asked
            and release_of(asked).package_version == release.package_version
        )
    # The home folder of somebody else, by each way in which a folder can be named.
    other = shutil.copytree(checkout, tmp_path_factory.mktemp("other") / "ALICE/newton")
    (toy.project.root / "linked").symlink_to(other)
    for spec in (
        f"{other}@main",
        f"git+file://{other}@main",
        f"{os.path.relpath(other, toy.project.root)}@main",
        "linked@main",
    ):
        assert release_of(spec).spec == "newton@main"
    assert str(UsageError(f"{home}/x and file://{home}/x")) == "~/x and file://~/x"


def test_a_host_s_name_is_in_no_record(monkeypatch):
    machine.machine.cache_clear()
    named = machine.machine("cpu")["host"]
    monkeypatch.setattr("platform.node", lambda: "another")
    machine.machine.cache_clear()
    assert (
        machine.machine("cpu")["host"]
        == named
        != hashlib.sha256(b"another").hexdigest()[:12]
    )


def test_with_names_packages(tmp_path):
    release = release_of("1.8", "warp-lang==1.19.0 mujoco-warp==4.0.0")
    assert str(release) == "1.8.0+mujoco-warp-4.0.0+warp-1.19.0"
    assert release_of(str(release)) == replace(release, spec=str(release))
    core = (
        {"mujoco": "4.0.0", "mujoco-core": version} for version in ("4.0.0", "4.0.1")
    )
    pins = [" ".join(map("==".join, packages.items())) for packages in core]
    assert [str(release_of("1.8", pin)) for pin in pins] == [
        "1.8.0+mujoco-4.0.0",  # MuJoCo 4.0.0 itself requires this version
        "1.8.0+mujoco-4.0.0+mujoco-core-4.0.1",
    ]
    for bad in ("warp", "numpy==1.0", "warp-lang>=1", "warp-lang==1.0;x"):
        with pytest.raises(UsageError, match="WITH="):
            release_of("1.8.0", bad)


@pytest.mark.skipif(
    not shutil.which("uv", path=Path(sys.executable).parent), reason="there is no uv"
)
def test_nothing_of_the_generator_is_installed_beside_what_is_measured_and_all_of_it_measures(
    tmp_path,
):
    """Test that an environment without the generator's other dependencies can measure
    any edition.
    """
    requirements = ["--requirement", os.devnull]
    folder = tmp_path / ".venv-numpy-1.26.4"
    environment._make(folder, "NUMPY=1.26.4", requirements, requirements)
    environment._link_generator(folder)
    environment._link_generator(folder)
    (tmp_path / "report.toml").write_text('edition = "numpy"\n')
    code = "import measured_report.measuring.run, measured_report.records.traces, sys; print('pandas' in sys.modules)"
    bare = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run(
        [folder / "bin/python", "-c", code],
        cwd=tmp_path,
        env=bare,
        capture_output=True,
        text=True,
    )
    assert done.stdout == "False\n", done.stderr
    assert (
        sum(path.stat().st_size for path in folder.rglob("*") if not path.is_symlink())
        < 1 << 20
    )


def test_why_nothing_could_be_installed_is_said_with_its_cause(tmp_path, monkeypatch):
    said = "error: none\n  cause: Because Python 3.11 is no\n     Python>=3.12, it\n         And because a is b, no."
    (tmp_path / "uv").write_text(f"#!/bin/sh\necho '{said}'\nexit 1\n")
    (tmp_path / "uv").chmod(0o700)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    with pytest.raises(
        UsageError, match=r": Because Python 3.11 is no Python>=3.12, it And because"
    ):
        environment._run(["sync"], "numpy")


def test_a_release_of_two_numbers_is_the_one_with_a_zero_behind_them(toy):
    for path in toy.project.root.glob("newton-*.dist-info/METADATA"):
        path.write_text("Name: newton\nVersion: 2.0\n")
    toy.write("pyproject.toml", '[project]\ndependencies = ["newton[sim]==2.0"]\n')
    assert own_release() == edition_of("2.0") == edition_of(None) == "2.0.0"
    assert release_of("2.0").is_installed_with(package_versions())


def test_a_measurement_refuses_what_is_not_installed():
    installed = package_versions()["newton"]
    assert (
        edition_of(None)
        == edition_of(f"{installed}@cpu").removesuffix("@cpu")
        == installed
    )
    for other in ("1.0.0", f"{installed}+warp-0.1.0", "nonsense"):
        with pytest.raises(ReportError, match="is not installed here"):
            edition_of(other)


def test_one_machine_never_takes_the_place_of_another(toy, capsys):
    assert measure.project_of(toy.project, "cpu") == toy.project
    assert measure.project_of(toy.project, "nvidia-h200").release == "1.4.0@nvidia-h200"
    assert "1.4.0@nvidia-h200" in capsys.readouterr().out
    apart = toy.project.of("1.4.0@nvidia-h200")
    assert measure.project_of(apart, "nvidia-h200") == apart
    with pytest.raises(UsageError, match="nvidia-h200"):
        measure.project_of(apart, "cpu")
    record = toy.record(machine={"device": "cuda", "gpu": "NVIDIA H100 80GB HBM3"})
    assert machine.machine_of(record) == "nvidia-h100-80gb-hbm3"
