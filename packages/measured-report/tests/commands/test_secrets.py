"""Test that neither written nor printed text reveals who measured, or how to open an
address.
"""

import gzip
import shutil
from pathlib import Path

import pytest
from toys import git, program

USER, TOKEN = "somebody-here", "ghp_0123456789"
MEASURED = """
import time

from measured_report.measuring.measurement import Measurement

def measure(conditions):
    slips = {"soft": 6.0 + time.time() % 1 / 100, "stiff": 0.3}
    rows = [{"case": case, "slip_mm": slip_mm, "dropped": False} for case, slip_mm in slips.items()]
    return Measurement(rows, {"stiff": {"time_s": [0.0, 1.0], "x_mm": [0.0, 0.3]}})
"""


def written(folder: Path) -> dict[str, bytes]:
    """Yield the files below a folder, unpacked, except those of the clone's own git."""
    files = {
        str(path): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and ".git" not in path.parts
    }
    return {
        name: gzip.decompress(text) if text[:2] == b"\x1f\x8b" else text
        for name, text in files.items()
    }


@pytest.mark.slow
def test_no_user_home_or_token_is_written_or_printed(toy, checkout, tmp_path):
    root, secret = toy.project.root, f"https://{USER}:{TOKEN}@127.0.0.1:9/x.git"
    shutil.copytree(
        root,
        home := tmp_path / USER / "report",
        ignore=shutil.ignore_patterns("results"),
    )
    checkout = shutil.move(checkout, tmp_path / USER / "newton")
    (home / "experiments/toy.py").write_text(MEASURED)
    (home / ".gitignore").write_text("/site/\n")
    git(tmp_path, "init", "--quiet", "--bare", "bare.git")
    for words in (
        "init --quiet",
        "add .",
        "commit --quiet -m a",
        f"remote add origin {tmp_path}/bare.git",
    ):
        git(home, *words.split())
    before = written(home)
    asked = [
        ("upgrade --newton 1.4.0 --since 1.4.0+warp-1.15.0 --device cpu", 0),
        ("replicate --device cpu", 0),
    ]
    asked += [
        ("page", 0),
        ("publish", 0),
        (f"publish --target dir:{home.parent}/www", 0),
        ("status", 0),
        ("history", 0),
    ]
    asked += [
        (f"publish --target git:{secret}", 2),
        (f"upgrade --newton git+{secret}@main --device cpu", 2),
    ]
    asked += [
        (f"page --newton {checkout}{end}", 2) for end in ("", "@main", "@nothing", "-2")
    ]
    asked += [
        ("diff --a 1.4.0 --b /nowhere", 2),
        (f"replicate --file {home}/nothing.tgz", 1),
    ]
    settings = {
        "HOME": str(home.parent),
        "USER": USER,
        "LOGNAME": USER,
        "UV_INDEX_URL": "http://127.0.0.1:9",
    }
    settings["PYTHONDONTWRITEBYTECODE"] = "1"  # bytecode contains the path of its file
    texts = {}
    for command, status in asked:
        done = program("build.py", *command.split(), cwd=home, **settings)
        assert done.returncode == status, done.stdout + done.stderr
        texts[command] = done.stdout + done.stderr
    git(tmp_path, "clone", "--quiet", "--branch", "gh-pages", "bare.git", "published")
    for folder in (home, home.parent / "www", tmp_path / "published"):
        texts |= {
            name: text.decode(errors="replace")
            for name, text in written(folder).items()
            if name not in before
        }
    said = {
        name: word
        for name, text in texts.items()
        for word in (USER, TOKEN, str(tmp_path))
        if word in text
    }
    assert said == {} and len(texts) > 60
