"""Write a new report into a folder: ``measured-report new DIR [--from FILE]``.

The report is about a pendulum, or about the results of a benchmark in a file of
pytest-benchmark, hyperfine or asv, or in a CSV. It works as it is.
"""

import argparse
import json
import os
import re
import shlex
import shutil
import sys
from collections.abc import Iterator, Mapping
from functools import partial
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from measured_report.commands import audit
from measured_report.commands.command_line import status_of
from measured_report.commands.reference import FILE, reference
from measured_report.files.atomic import write_file
from measured_report.files.columns import Schema
from measured_report.files.config import Config, report_in
from measured_report.files.errors import UsageError
from measured_report.files.git import git
from measured_report.measuring.benchmarks import rows_of
from measured_report.records.record import NAME

SKELETON = Path(__file__).resolve().parents[1] / "skeleton"
FROM_FILE = SKELETON / "from_file"
"""The files that replace those about the pendulum in a report from a file."""
GENERATOR = "measured-report"
OLDER: Mapping[str, str] = {}
"""Placeholders for a Python on which the skeleton's release of NumPy does not run."""
if sys.version_info < (3, 11):
    OLDER = {"numpy==2.4.6": f"numpy=={metadata.version('numpy')}", ">=3.11": ">=3.10"}


def main() -> int:
    parser = argparse.ArgumentParser(prog=GENERATOR, description=__doc__)
    if sys.argv[1:2] == ["audit"]:
        return status_of(audit.main)
    parser.add_argument(
        "command",
        choices=("new", "audit"),
        help="see also: measured-report audit --help",
    )
    parser.add_argument(
        "folder",
        metavar="DIR",
        type=Path,
        help="a folder that is empty or does not exist",
    )
    parser.add_argument(
        "--from", metavar="FILE", type=Path, dest="file", help="results of a benchmark"
    )
    parser.add_argument(
        "--version", action="version", version=metadata.version(GENERATOR)
    )
    arguments = parser.parse_args()
    return status_of(partial(new, arguments.folder.resolve(), arguments.file))


def new(folder: Path, file: Path | None = None) -> int:
    """Write a report into a folder that is empty or does not exist.

    It is about the results of a benchmark in ``file``, or else about a pendulum.
    """
    marks = marks_of(file) if file else {}
    if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
        raise UsageError(f"{folder} is not empty: use a folder that does not exist")
    folder.mkdir(parents=True, exist_ok=True)
    name = re.sub(r"[^a-z0-9]+", "-", folder.name.lower()).strip("-")
    requirement = f'"{GENERATOR}"'
    source = "".join(_source(folder))
    if not source:
        requirement = f'"{GENERATOR}=={metadata.version(GENERATOR)}"'
    marks |= {
        "@NAME@": name or "report",
        "@AUTHOR@": git(folder, "config", "user.name") or "Its authors",
        f'"{GENERATOR}"': requirement,
        "# @SOURCE@\n": source,
        **OLDER,
    }
    templates = {
        path.relative_to(SKELETON): path
        for path in SKELETON.rglob("*")
        if FROM_FILE not in path.parents and not (file and "pendulum" in path.name)
    }
    if file:
        templates |= {
            path.relative_to(FROM_FILE): path for path in FROM_FILE.rglob("*")
        }
    for path, template in templates.items():
        if template.is_file() and template.suffix != ".pyc":
            text = template.read_text(encoding="utf-8")
            for mark, replacement in marks.items():
                text = text.replace(mark, replacement)
            # Tools would take files such as .gitignore as settings of this package.
            write_file(folder / path.as_posix().replace("dot.", "."), text)
    if file:
        write_file(folder / "assets" / file.name, file.read_bytes())
    write_file(folder / FILE, reference(report_in(folder)))
    short_path = shlex.quote(os.path.relpath(folder))
    print(
        f"wrote {folder}: run cd {short_path} && make report to measure and to build "
        "site/index.html"
    )
    return 0


def marks_of(file: Path) -> dict[str, str]:
    """Return the placeholders for a report from a file.

    Raise ReportError if the file cannot be read."""
    try:
        rows = rows_of(str(file))
    except OSError as error:
        raise UsageError(f"{file} cannot be read: {error.strerror}") from None
    if sum("of" not in row for row in rows) < 2:
        raise UsageError(
            f"{file} has less than two cases: add one, because a claim compares cases"
        )
    column = next((name for name in rows[0] if name not in ("case", "of")), "")
    if not re.fullmatch(NAME, column):
        raise UsageError(
            f"{file}: {column!r} is not the name of a column: use a name that ends in "
            "its unit, such as run_ms"
        )
    is_time = Schema(Config(), {})[column].unit in ("s", "ms")
    return {
        "Does a pendulum keep its energy?": f"The results in {file.name}",
        "bench.json": file.name,
        "run_ms": column,
        '"cost"': '"cost"' if is_time else '""',
    }


def _source(folder: Path) -> Iterator[str]:
    """Yield the lines of pyproject.toml that name the source of this generator.

    There are none if it was installed from the package index. If it was installed from
    a wheel, the wheel is copied into the report.
    """
    text = metadata.distribution(GENERATOR).read_text("direct_url.json")
    if not text:
        return
    origin = json.loads(text)
    path = Path(unquote(urlparse(origin["url"]).path))
    fields = {"url": origin["url"]}
    if "vcs_info" in origin:
        fields = {"git": origin["url"], "rev": origin["vcs_info"]["commit_id"]}
        if "subdirectory" in origin:
            fields["subdirectory"] = origin["subdirectory"]
    elif path.suffix == ".whl" and path.is_file():
        (folder / "wheels").mkdir()
        shutil.copy(path, folder / "wheels")
        fields = {"path": f"wheels/{path.name}"}
    elif origin["url"].startswith("file:"):
        fields = {"path": str(path)}
    parts = ", ".join(f"{name} = {json.dumps(value)}" for name, value in fields.items())
    yield f"\n[tool.uv.sources]\n{GENERATOR} = {{ {parts} }}\n"
