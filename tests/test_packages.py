"""Build the four packages and run each one in a fresh environment.

With WEEKLY=1 every supported Python that uv finds is used, with wheels and with sdists.
"""

import json
import os
import re
import subprocess
import sys
import tarfile
import textwrap
import time
import zipfile
from email.parser import Parser
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.files.settings import read_toml

PACKAGES = ("contact-bias", "measured-report", "newton-lint", "number-audit")
PYTHONS = ("3.10", "3.11", "3.12", "3.13")
UV = Path(sys.executable).with_name("uv")
SECONDS = 60
"""Longest time of a smoke test, without the installation."""

SCENE = """<mujoco><worldbody><geom name="floor" type="plane" size="1 1 1"/>
<body pos="0 0 .1"><freejoint/><geom name="box" type="box" size=".1 .1 .1" mass="1"/>
</body></worldbody></mujoco>"""
BOX = """
import contact_bias, contact_bias_c, contact_place, contact_tumbles
import mujoco
model = mujoco.MjModel.from_xml_path("scene.xml")
data = mujoco.MjData(model)
mujoco.set_mjcb_control(contact_bias_c.subtract_bias)
for _ in range(20):
    mujoco.mj_step(model, data)
mujoco.set_mjcb_control(None)
assert 0.09 < data.qpos[2] < 0.11, data.qpos
"""
SMOKE_TESTS = {
    "number-audit": [["number-audit", "README.md", "--check"]],
    "newton-lint": [["newton-lint", "scene.xml", "--format", "json"]],
    "contact-bias": [["python", "-c", BOX]],
    "measured-report": [
        ["measured-report", "new", "report"],
        ["python", "-c", "open('report/docs/section.md'); import measured_report"],
    ],
}
"""Commands that must succeed in a folder with README.md, r.json and scene.xml."""

weekly = pytest.mark.skipif("WEEKLY" not in os.environ, reason="this test runs weekly")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not UV.exists(), reason="there is no uv to build packages with"),
]


def run(*command: str | Path, cwd: Path) -> str:
    """Run a command without the packages of this checkout, and return its output."""
    settings = {
        name: value
        for name, value in os.environ.items()
        if name not in ("PYTHONPATH", "VIRTUAL_ENV", "MAKEFLAGS")
    }
    done = subprocess.run(
        command, cwd=cwd, env=settings, capture_output=True, text=True, check=False
    )
    if re.search(r"(?i)dns error|failed to fetch|error sending request", done.stderr):
        pytest.skip("there is no index to install from")
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def built(tmp_path_factory) -> dict[str, tuple[Path, Path]]:
    """Build the wheel of each package from its sdist, and return both."""
    files = {}
    for package in PACKAGES:
        folder = tmp_path_factory.mktemp(package)
        run(UV, "build", "--quiet", ROOT / "packages" / package, "-o", folder, cwd=ROOT)
        [wheel] = folder.glob("*.whl")
        [sdist] = folder.glob("*.tar.gz")
        files[package] = (wheel, sdist)
    return files


def smoke_test(package: str, file: Path, python: str, folder: Path) -> None:
    """Install a wheel or an sdist in a fresh environment, and run its smoke test."""
    run(UV, "venv", "--quiet", "--python", python, folder / "venv", cwd=folder)
    scripts = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    install = ("pip", "install", "--quiet", "--python", scripts / "python")
    run(UV, *install, file, cwd=folder)
    (folder / "scene.xml").write_text(SCENE)
    (folder / "r.json").write_text(json.dumps({"time_ms": 12.3}))
    (folder / "README.md").write_text("It takes 12.3 ms<!-- = r.json#/time_ms -->.")
    began = time.monotonic()
    for program, *arguments in SMOKE_TESTS[package]:
        run(scripts / program, *arguments, cwd=folder)
    assert time.monotonic() - began < SECONDS


@pytest.mark.parametrize("package", PACKAGES)
def test_the_metadata_is_complete_and_the_files_are_those_of_the_package(
    built, package
):
    wheel, sdist = built[package]
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        [path] = [name for name in names if name.endswith(".dist-info/METADATA")]
        metadata = Parser().parsestr(archive.read(path).decode())
    project = read_toml(ROOT / "packages" / package / "pyproject.toml")["project"]
    assert (metadata["Name"], metadata["Version"]) == (package, project["version"])
    assert re.fullmatch(r"\d+\.\d+\.\d+", metadata["Version"])
    assert metadata["License-Expression"] == "Apache-2.0"
    assert metadata["Description-Content-Type"] == "text/markdown"
    for field in ("Summary", "Author", "Keywords", "Requires-Python"):
        assert metadata[field], field
    assert f"# {package}" in metadata.get_payload()
    classifiers = metadata.get_all("Classifier")
    for python in PYTHONS:
        assert f"Programming Language :: Python :: {python}" in classifiers
    assert any(name.endswith("licenses/LICENSE") for name in names)
    assert not [name for name in names if name.startswith(("tests/", "hatch_build"))]
    is_typed = any(name.endswith("/py.typed") for name in names)
    # The type marker of PEP 561 needs a folder; contact-bias has single modules.
    assert is_typed == ("Typing :: Typed" in classifiers) == (package != "contact-bias")
    with tarfile.open(sdist) as archive:
        assert all(member.isfile() for member in archive.getmembers())


def test_a_new_report_has_its_documents_from_the_wheel(built):
    wheel, _ = built["measured-report"]
    with zipfile.ZipFile(wheel) as archive:
        shipped = {
            Path(name).name: archive.read(name)
            for name in archive.namelist()
            if "/skeleton/docs/" in name
        }
    assert len(shipped) == 5
    for name, content in shipped.items():
        assert content == (ROOT / "docs" / name).read_bytes()


@pytest.mark.parametrize("package", ["number-audit", "newton-lint"])
def test_a_light_package_works_in_a_fresh_environment(built, package, tmp_path):
    smoke_test(package, built[package][0], sys.executable, tmp_path)


SCRIPT = re.compile(r"^( +)(?:- )?run: \|\n((?:\1  .*\n)+)", re.MULTILINE)


def run_script(file: Path, folder: Path, **settings: str | Path) -> int:
    """Run the script of a workflow or an action as a runner does; return its status."""
    [(_, script)] = SCRIPT.findall(file.read_text(encoding="utf-8"))
    path = f"{folder}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        ["bash", "-euo", "pipefail", "-c", textwrap.dedent(script)],
        cwd=folder,
        env=os.environ | settings | {"PATH": path},
        check=False,
    ).returncode


@pytest.fixture
def project(tmp_path) -> Path:
    """Return a folder in which README.md agrees with its result."""
    (tmp_path / ".git").mkdir()
    (tmp_path / "r.json").write_text('{"time_ms": 12.3}')
    (tmp_path / "README.md").write_text("It takes 12.3 ms<!-- = r.json#/time_ms -->.")
    return tmp_path


def test_the_action_fails_if_a_number_is_stale(project, capfd):
    pipx = project / "pipx"
    pipx.write_text(f'#!/bin/bash\nexec "{UV}" tool run --from "$3" "${{@:4}}"\n')
    pipx.chmod(0o755)
    action = ROOT / "packages/number-audit/action.yml"
    # Without an index, this call skips the test.
    run(UV, "tool", "run", "--from", action.parent, "number-audit", "-h", cwd=project)
    settings = {"FILES": "README.md", "GITHUB_ACTION_PATH": action.parent}
    assert run_script(action, project, **settings) == 0
    (project / "r.json").write_text('{"time_ms": 14.1}')
    assert run_script(action, project, **settings) == 1
    assert "::error file=README.md,line=1::stale: " in capfd.readouterr().out


def test_the_hook_fails_if_only_the_result_changed(project):
    hooks = (ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8")
    hook = hooks.partition("- id: number-audit\n")[2]
    assert "pass_filenames: false" in hook and "always_run: true" in hook
    program, *options = re.search("entry: (.*)", hook)[1].split()
    [text] = re.search(r"args: \[(.*)\]", hook)[1].split(", ")
    command = [Path(sys.executable).with_name(program), *options, text]
    assert subprocess.run(command, cwd=project, check=False).returncode == 0
    (project / "r.json").write_text('{"time_ms": 14.1}')
    assert subprocess.run(command, cwd=project, check=False).returncode == 1


def test_a_release_needs_a_tag_with_the_version_of_the_package(tmp_path, capfd):
    """Test the tag of a release in the workflow.

    A program that lists its arguments replaces python and uv.
    """
    for name in ("python", "uv"):
        program = tmp_path / ".venv/bin" / name
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text('#!/bin/bash\necho "$@"\n')
        program.chmod(0o755)
    for package in PACKAGES:
        source = ROOT / "packages" / package / "pyproject.toml"
        target = tmp_path / "packages" / package / "pyproject.toml"
        target.parent.mkdir(parents=True)
        target.write_bytes(source.read_bytes())
    workflow = ROOT / ".github/workflows/release.yml"
    for package in PACKAGES:
        assert f'"{package}-v*"' in workflow.read_text(encoding="utf-8")
        file = ROOT / "packages" / package / "pyproject.toml"
        version = read_toml(file)["project"]["version"]
        assert run_script(workflow, tmp_path, TAG=f"{package}-v{version}") == 0
        assert f"build packages/{package} --out-dir dist" in capfd.readouterr().out
        assert run_script(workflow, tmp_path, TAG=f"{package}-v{version}1") == 1
        assert "is not the version" in capfd.readouterr().err


@weekly
@pytest.mark.parametrize("python", PYTHONS)
@pytest.mark.parametrize("package", PACKAGES)
@pytest.mark.parametrize("kind", ["wheel", "sdist"])
def test_each_package_works_on_each_python(built, package, python, kind, tmp_path):
    find = [UV, "python", "find", "--quiet", "--no-project", python]
    if subprocess.run(find, capture_output=True, check=False).returncode:
        pytest.skip(f"there is no Python {python}")
    smoke_test(package, built[package][kind == "sdist"], python, tmp_path)
