"""New reports: ``measured-report new DIR`` writes one that works, and ``measured-report update`` renews what it wrote.

What is written is the folder ``skeleton`` of this package. A file that was changed since, or removed, stays so.
"""

import argparse
import hashlib
import json
import re
import shutil
import sys
from collections.abc import Mapping
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from measured_report.editions.release import VERSION, releases_of
from measured_report.files.config import Config
from measured_report.files.errors import ReportError, UsageError
from measured_report.records.provenance import git

SKELETON = Path(__file__).resolve().parents[1] / "skeleton"
OTHER = SKELETON / "other"
"""What a report on any package has in the place of the pendulum."""
TOLD = SKELETON / "told.json"
"""What the pendulum has in the place of marks."""
OTHERS = "    # @OTHERS@\n"
GENERATOR = "measured-report"
WRITTEN = ".measured-report.json"
"""Digests of a report's files as they were written."""
SAID = ""
"""The name under which it has the words that stand in the place of marks."""
SOURCE = re.compile(rf"(?m)^{GENERATOR} = \{{.*\}}$")


def main() -> int:
    """Write or update a report; the exit status, with one line for whatever can be mended."""
    parser = argparse.ArgumentParser(prog=GENERATOR, description=__doc__.partition("\n")[0], allow_abbrev=False)
    parser.add_argument("command", choices=("new", "update"))
    parser.add_argument("folder", metavar="DIR", type=Path, nargs="?", default=".", help="default: the current one")
    parser.add_argument("--package", default="", help="what it is on, as numpy or numpy==2.3.0")
    parser.add_argument("--title", default="", help="what it is called")
    parser.add_argument("--version", action="version", version=metadata.version(GENERATOR))
    arguments = parser.parse_args()
    try:
        if arguments.command == "new":
            new(arguments.folder.resolve(), arguments.package, arguments.title)
        else:
            update(arguments.folder.resolve())
    except (ReportError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def new(folder: Path, package: str = "", title: str = "") -> None:
    """Write a report into a folder that is empty or not there: on a pendulum, or importing a package."""
    if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
        raise UsageError(f"{folder} is not empty; name a folder that is not there")
    if any(mark in title for mark in '"\\\n{}'):
        raise UsageError(f"--title={title} has a quote, a brace or a break in it, which no title takes here")
    told = json.loads(TOLD.read_text(encoding="utf-8"))
    if package:
        name, _, version = package.partition("==")
        if is_name := re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", name):
            version = version or next((str(release) for release in releases_of(name)[-1:]), "")
        if not (is_name and VERSION.fullmatch(version)):
            raise UsageError(f"--package={package} is no package of the index; numpy==2.3.0 names one with its release")
        told = {"@PACKAGE@": name, "@VERSION@": version, "@OPTION@": Config(edition=name).option, OTHERS: ""}
        told["@TITLE@"] = f"How long does {name} take to import?"
    if title:
        told["@TITLE@"] = title
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder, {}, told)
    print(f"wrote {folder}; cd {folder.name} && make report measures, and builds site/index.html")


def update(folder: Path) -> None:
    """Renew what was written and is still as it was, and name what was changed; the generator is then this one."""
    path = folder / WRITTEN
    if not path.is_file():
        raise UsageError(f"{folder} has no {WRITTEN}: {GENERATOR} new did not write it")
    written = json.loads(path.read_text(encoding="utf-8"))
    told = written.pop(SAID, None) or json.loads(TOLD.read_text(encoding="utf-8"))
    kept = _write(folder, written, told)
    project = folder / "pyproject.toml"
    if "pyproject.toml" in kept and (source := _source(folder)):
        project.write_text(SOURCE.sub(lambda _: source, project.read_text(encoding="utf-8")), encoding="utf-8")
    print(f"updated {folder}" + "".join(f"\nkept as you have it: {name}" for name in kept))


def _write(folder: Path, written: Mapping[str, str], told: Mapping[str, str]) -> list[str]:
    """Write all files but those that are no longer as they were ``written``, which are returned.

    They have what was ``told`` in the place of marks.
    """
    source, digests, kept = _source(folder), {**written, SAID: told}, []
    said = {
        **told,
        "@NAME@": re.sub(r"[^a-z0-9]+", "-", folder.name.lower()).strip("-") or "report",
        "@AUTHOR@": git(folder, "config", "user.name") or "Its authors",
        f'"{GENERATOR}"': f'"{GENERATOR}"' if source else f'"{GENERATOR}=={metadata.version(GENERATOR)}"',
        "# @SOURCE@\n": f"\n[tool.uv.sources]\n{source}\n" if source else "",
    }
    files = {path.relative_to(SKELETON): path for path in SKELETON.rglob("*") if path != TOLD}
    files = {name: path for name, path in files.items() if not path.is_relative_to(OTHER)}
    if told.get(OTHERS) == "":
        files = {name: path for name, path in files.items() if name.stem.partition(".")[0] != "pendulum"}
        files |= {path.relative_to(OTHER): path for path in OTHER.rglob("*")}
    for relative, template in sorted(files.items()):
        if not template.is_file() or template.suffix == ".pyc":
            continue
        text = template.read_text(encoding="utf-8")
        for mark, word in said.items():
            text = text.replace(mark, word)
        name = relative.as_posix().replace("dot.", ".")
        path, digest = folder / name, hashlib.sha256(text.encode()).hexdigest()
        now = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None
        if now == written.get(name):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            digests[name] = digest
        elif now not in (None, digest):
            kept.append(name)
    (folder / WRITTEN).write_text(json.dumps(digests, indent=1) + "\n", encoding="utf-8")
    return kept


def _source(folder: Path) -> str:
    """Return the line of pyproject.toml that says where this generator is from; empty where that is an index.

    A wheel is copied into the report, so that it is there wherever the report is.
    """
    told = json.loads(metadata.distribution(GENERATOR).read_text("direct_url.json") or "{}")
    url, place = told.get("url", ""), Path(unquote(urlparse(told.get("url", "")).path))
    if "vcs_info" in told:
        said = {"git": url, "rev": told["vcs_info"]["commit_id"], "subdirectory": told.get("subdirectory")}
    elif not url.startswith("file:"):
        said = {"url": url}
    else:
        said = {"path": str(place)}
        if place.suffix == ".whl":
            said = {"path": f"wheels/{place.name}"}
            (folder / "wheels").mkdir(exist_ok=True)
            if place.is_file() and place.parent != folder / "wheels":
                shutil.copy(place, folder / "wheels")
    parts = ", ".join(f"{name} = {json.dumps(word)}" for name, word in said.items() if word)
    return f"{GENERATOR} = {{ {parts} }}" if parts else ""
