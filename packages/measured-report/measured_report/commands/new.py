"""New reports: ``measured-report new DIR`` writes one that works, the folder ``skeleton`` of this package."""

import argparse
import json
import os
import re
import shlex
import shutil
import sys
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from measured_report.commands import audit
from measured_report.commands.reference import FILE, reference
from measured_report.editions.release import VERSION, releases_of
from measured_report.files.atomic import write_file
from measured_report.files.config import report_in
from measured_report.files.errors import UNPRINTABLE, ReportError, UsageError
from measured_report.files.git import git
from measured_report.files.settings import Config

SKELETON = Path(__file__).resolve().parents[1] / "skeleton"
# The folders below that a report has one of, and what it is then called.
KINDS = {
    "pendulum": "Does a pendulum keep its energy?",
    "importing": "How long does {} take to import?",
}
PACKAGE = "numpy==2.4.6"
GENERATOR = "measured-report"


def main() -> int:
    parser = argparse.ArgumentParser(
        prog=GENERATOR, description=__doc__, allow_abbrev=False
    )
    if sys.argv[1:2] == ["audit"]:
        return audit.main()
    parser.add_argument(
        "command", choices=("new", "audit"), help="audit --help tells more"
    )
    parser.add_argument(
        "folder", metavar="DIR", type=Path, help="a folder that is empty or not there"
    )
    parser.add_argument(
        "--package", default="", help="what it is on, as numpy or numpy==2.3.0"
    )
    parser.add_argument("--title", default="", help="what it is called")
    parser.add_argument(
        "--version", action="version", version=metadata.version(GENERATOR)
    )
    arguments = parser.parse_args()
    try:
        new(arguments.folder.resolve(), arguments.package, arguments.title)
    except (ReportError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def new(folder: Path, package: str = "", title: str = "") -> None:
    """Write a report into a folder that is empty or not there: on a pendulum, or importing a package."""
    if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
        raise UsageError(f"{folder} is not empty; name a folder that is not there")
    if any(mark in title for mark in "\\\n{}") or UNPRINTABLE.search(title):
        title = UNPRINTABLE.sub("?", title)
        raise UsageError(
            f"--title={title} has a brace, a break or what can't be printed, which no title takes"
        )
    name, _, version = (package or PACKAGE).partition("==")
    if is_name := re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", name):
        version = version or next(
            (str(release) for release in releases_of(name)[-1:]), ""
        )
    if not (is_name and VERSION.fullmatch(version)):
        raise UsageError(
            f"--package={package} is no package of the index; numpy==2.3.0 names one with its release"
        )
    kind = "importing" if package else "pendulum"
    marks = {
        "@PACKAGE@": name,
        "@VERSION@": version,
        "@OPTION@": Config(edition=name).option,
    }
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder, kind, {**marks, "@TITLE@": title or KINDS[kind].format(name)})
    write_file(folder / FILE, reference(report_in(folder)))
    way = shlex.quote(os.path.relpath(folder))
    print(
        f"wrote {folder}; cd {way} && make report measures, and builds site/index.html"
    )


def _write(folder: Path, kind: str, marks: Mapping[str, str]) -> None:
    source = _source(folder)
    replacements = {
        **marks,
        "@NAME@": re.sub(r"[^a-z0-9]+", "-", folder.name.lower()).strip("-")
        or "report",
        "@AUTHOR@": git(folder, "config", "user.name") or "Its authors",
        f'"{GENERATOR}"': f'"{GENERATOR}"'
        if source
        else f'"{GENERATOR}=={metadata.version(GENERATOR)}"',
        "# @SOURCE@\n": f"\n[tool.uv.sources]\n{source}\n" if source else "",
    }
    for template in sorted(
        path for path in SKELETON.rglob("*") if path.is_file() and path.suffix != ".pyc"
    ):
        first, *below = template.relative_to(SKELETON).parts
        if first not in KINDS or first == kind:
            name = "/".join(below if first == kind else [first, *below]).replace(
                "dot.", "."
            )
            text = template.read_text(encoding="utf-8")
            for mark, replacement in replacements.items():
                is_quoted = mark == "@TITLE@" and template.suffix in (".toml", ".cff")
                quoted = json.dumps(replacement, ensure_ascii=False)[1:-1]
                text = text.replace(mark, quoted if is_quoted else replacement)
            write_file(folder / name, text)


def _source(folder: Path) -> str:
    """Return the line of pyproject.toml that says where this generator is from; a wheel is copied into the report."""
    origin = json.loads(
        metadata.distribution(GENERATOR).read_text("direct_url.json") or "{}"
    )
    url, path = (
        origin.get("url", ""),
        Path(unquote(urlparse(origin.get("url", "")).path)),
    )
    if "vcs_info" in origin:
        fields = {
            "git": url,
            "rev": origin["vcs_info"]["commit_id"],
            "subdirectory": origin.get("subdirectory"),
        }
    elif not url.startswith("file:"):
        fields = {"url": url}
    else:
        fields = {"path": str(path)}
        if path.suffix == ".whl":
            fields = {"path": f"wheels/{path.name}"}
            (folder / "wheels").mkdir(exist_ok=True)
            shutil.copy(path, folder / "wheels")
    parts = ", ".join(
        f"{name} = {json.dumps(value)}" for name, value in fields.items() if value
    )
    return f"{GENERATOR} = {{ {parts} }}" if parts else ""
