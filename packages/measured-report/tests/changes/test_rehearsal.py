"""Test an upgrade without network: three releases of a small package, real uv and real
make. The tests write wheels and serve them on an index.
"""

import json
import os
import subprocess
import sys
import sysconfig
import threading
import zipfile
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from toys import put

from measured_report.commands.new import SKELETON

UV = Path(sys.executable).with_name("uv")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not UV.exists(), reason="there is no uv"),
]
BALL = {
    "1.0.0": ("2026-01-01T10:00:00Z", 1.0),
    "1.1.0": ("2026-02-01T10:00:00Z", 1.0),
    "1.2.0": ("2026-03-01T10:00:00Z", 2.0),
}
"""Upload time of each release of the package, and the distance that a ball falls in it.
"""
AIR = {
    "1.0.0": ("2026-01-01T10:00:00Z", 1.0),
    "1.1.0": ("2026-02-01T23:30:00Z", 1.0),
    "1.2.0": ("2026-02-02T00:30:00Z", 1.001),
}
"""Upload times of a required package. Its last release appears a day later."""
SETTINGS = """
edition = "ball"
packages = ["air"]
edition_name = "Ball"
pages = [{ name = "index", texts = ["front.md.j2"] }, { name = "cause" }]
[changes]
package_groups = [["air"]]
thresholds = { "drop.whole.fall_mm" = 0.05 }
"""
EXPERIMENT = """
import air
import ball
from measured_report.measuring.measurement import Measurement

def measure(conditions):
    return Measurement([{"case": "whole", "fall_mm": 10.0 * ball.SIZE * air.SIZE}])
"""
SECTION = """
from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section

order = 1

def derive(results):
    fall = results.row["whole"].fall_mm
    return Section(claims=[Claim("short", at_most(fall, 15.0, why="as it was"), {"fall": fall})])
"""
WORDS = """# A ball

{% claim short %}
{% holds %} It falls {{ fall }}. {% fails %} It falls far. {% asks %} how far it falls
{% endclaim %}
"""


def write_wheel(folder: Path, name: str, version: str, size: float) -> Path:
    """Write a wheel with one module, as a build writes it."""
    needs = "Requires-Dist: air\n" if name == "ball" else ""
    about = f"{name}-{version}.dist-info"
    files = {
        f"{name}.py": f"SIZE = {size}\n",
        f"{about}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n{needs}",
        f"{about}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    record = "".join(f"{file},,\n" for file in (*files, f"{about}/RECORD"))
    path = folder / f"{name}-{version}-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as wheel:
        for file, text in {**files, f"{about}/RECORD": record}.items():
            wheel.writestr(file, text)
    return path


class Index(SimpleHTTPRequestHandler):
    """Serve wheels, and the list of each package's files by PEP 691 and PEP 700."""

    def do_GET(self) -> None:
        if not self.path.endswith("/"):
            return super().do_GET()
        name = self.path.strip("/").rpartition("/")[2]
        releases = {"ball": BALL, "air": AIR}.get(name, {})
        files = []
        for version, (uploaded, _) in releases.items():
            file = f"{name}-{version}-py3-none-any.whl"
            entry = {"filename": file, "url": f"/{file}", "hashes": {}}
            files.append({**entry, "upload-time": uploaded})
        content = {"meta": {"api-version": "1.1"}, "name": name, "files": files}
        body = json.dumps({**content, "versions": [*releases]}).encode()
        self.send_response(200 if files else 404)
        self.send_header("Content-Type", "application/vnd.pypi.simple.v1+json")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        """Print nothing, so that the output of the tests stays readable."""


@pytest.fixture(scope="module")
def index(tmp_path_factory) -> Iterator[str]:
    """Return the address of an index with all wheels."""
    folder = tmp_path_factory.mktemp("index")
    for name, releases in {"ball": BALL, "air": AIR}.items():
        for version, (_, size) in releases.items():
            write_wheel(folder, name, version, size)
    handler = partial(Index, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/simple"
        server.shutdown()


@pytest.fixture(scope="module")
def root(tmp_path_factory, index) -> Path:
    """Return the folder of a report of the oldest release, with its environment."""
    root = tmp_path_factory.mktemp("rehearsal") / "report"
    put(root, "report.toml", SETTINGS)
    put(root, "pyproject.toml", '[project]\ndependencies = ["ball==1.0.0"]\n')
    put(root, "experiments/__init__.py", "")
    put(root, "experiments/drop.py", EXPERIMENT)
    put(root, "report/__init__.py", "")
    put(root, "report/sections/__init__.py", "")
    put(root, "report/sections/drop.py", SECTION)
    put(root, "templates/sections/drop.md.j2", WORDS)
    put(root, "templates/front.md.j2", "# A report\n")
    put(root, "templates/pages/cause.md.j2", "# Cause\n")
    put(root, "CITATION.cff", "title: A ball\nauthors:\n  - name: Its authors\n")
    put(root, "build.py", (SKELETON / "build.py").read_text(encoding="utf-8"))
    put(root, "Makefile", f"include {SKELETON}/report.mk\n")
    python = root / ".venv/bin/python"
    packages = ("ball==1.0.0", "air==1.0.0")
    uv("venv", "--python", sys.executable, str(root / ".venv"), index=index)
    uv("pip", "install", "--python", str(python), *packages, index=index)
    [site] = root.glob(".venv/lib/python*/site-packages")
    # The packages for deriving and drawing are those of the tests.
    (site / "lent.pth").write_text(f"{sysconfig.get_path('purelib')}\n")
    return root


def uv(*arguments: str, index: str) -> None:
    environment = {**os.environ, "UV_DEFAULT_INDEX": index}
    subprocess.run([UV, *arguments], env=environment, capture_output=True, check=True)


def make(root: Path, index: str, words: str) -> tuple[int, str]:
    """Return the status of make and everything that it prints."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if name not in ("MAKEFLAGS", "MAKELEVEL", "UV_EXCLUDE_NEWER")
    }
    environment |= {
        "UV_DEFAULT_INDEX": index,
        "PATH": f"{UV.parent}{os.pathsep}{os.environ['PATH']}",
        "TZ": "Asia/Kathmandu",  # the day of a release is a day in UTC
    }
    done = subprocess.run(
        ["make", *words.split(), "PYTHON=.venv/bin/python"],
        cwd=root,
        env=environment,
        capture_output=True,
        text=True,
    )
    return done.returncode, done.stdout + done.stderr


def packages(root: Path, folder: str) -> dict[str, str]:
    record = json.loads((root / "results" / folder / "drop.json").read_text())
    return record["identity"]["packages"]


def test_an_upgrade_is_measured_compared_and_traced_to_its_release(root, index):
    status, text = make(root, index, "upgrade BALL=1.2.0 PROFILE=quick")
    assert (status, "upgrade] Error 1" in text) == (2, True), text  # an alarm
    assert "Ball 1.2.0 against 1.0.0 (air 1.0.0 → 1.2.0)" in text
    assert "flipped: drop.short holds → fails" in text
    assert "alarm: fall 10 mm → 20 mm, +100 % (drop whole)" in text
    status, text = make(root, index, "bisect CLAIM=drop.short A=1.0.0 B=1.2.0")
    assert status == 0, text
    assert "drop.short changes between 1.1.0 and 1.2.0: holds → fails" in text
    assert "the cause is ball: 1.1.0+air-1.2.0 has the old answer" in text
    # The newest packages of the day of the release were installed beside it.
    assert packages(root, "bisect/quick/ball-1.1.0") == {
        "ball": "1.1.0",
        "air": "1.1.0",
    }
    status, text = make(root, index, "rerun SECTION=drop BALL=1.1.0")
    assert status == 0, text
    assert packages(root, "ball-1.1.0") == {"ball": "1.1.0", "air": "1.1.0"}
    pinned = "rerun SECTION=drop BALL=1.1.0 WITH=air==1.0.0 PROFILE=quick"
    status, text = make(root, index, pinned)
    assert status == 0, text
    assert packages(root, "quick/ball-1.1.0+air-1.0.0")["air"] == "1.0.0"
