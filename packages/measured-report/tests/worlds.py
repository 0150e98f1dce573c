"""Make small worlds, which are the results of three releases of a toy report, and alter
them. There are three sections: repeated runs of one case, which show how numbers
scatter; the toy, which reads them; and one that compares releases. A story of the front
page reads all of them. Some of the releases were measured again.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from toys import Toy, put

from measured_report.findings.editions import Edition
from measured_report.pages.prose import Templates
from measured_report.pages.wording import give_words
from measured_report.records.record import Record, record_text
from measured_report.records.replicas import FOLDER, archive_of
from measured_report.values.quantities import Quantity

RELEASES = ("1.4.0", "1.5.0", "1.8.0")
SECTIONS = ("runs", "toy", "pair")
REPLICAS = {"1.4.0": ("a", "b"), "1.5.0": (), "1.8.0": ("a",)}
NON_FINITE = "the state was not finite in frame 300"

WORLD_SETTINGS = """
edition = "newton"
packages = ["warp-lang", "mujoco-warp", "mujoco"]
requirement = "newton[sim]"
edition_name = "Newton"
noise_section = "runs"
text_modules = "report.story"
pages = [{ name = "index", texts = ["front.md.j2", "story.md.j2"] }, { name = "cause" }]
columns = [{ kind = "failure", pattern = "failure" }]
[changes]
keys = ["case"]
"""
RUNS = """
from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section

order = 1

def derive(results):
    slips = [row.slip_mm for row in results.rows]
    widest = results.value(
        "widest", "largest less smallest", lambda *slips: max(slips) - min(slips), *slips,
        unit="mm",
    )
    small = at_most(widest, 0.5, why="hardly seen")
    return Section(claims=[Claim("is_small", small, {"widest": widest})])
"""
TOY = """
from measured_report.parts.claim import Claim, at_least, at_most
from measured_report.parts.section import Section, Table
import pandas as pd

order = 2
reads = ("runs",)

def derive(results):
    soft, stiff = results.row["soft"], results.row["stiff"]
    gain = results.value("gain", "soft over stiff", soft.slip_mm / stiff.slip_mm)
    bound = results.chosen("bound", "much", 10.0)
    slips = [row.slip_mm for row in results.rows]
    claims = [
        Claim("helps", at_least(gain, bound), {"gain": gain}),
        Claim("slips", at_least(soft.slip_mm, 1.0, why="seen"), {"slip": soft.slip_mm}),
        Claim("holds", at_most(stiff.slip_mm, 1.0, why="seen"), {"slip": stiff.slip_mm}),
    ]
    table = pd.DataFrame({"slip": slips}, index=[row.case for row in results.rows])
    return Section(tables={"cases": Table(table)}, claims=claims)
"""
PAIR = """
from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section

order = 3

def derive(results, releases):
    slips = [
        chapters["toy"].results.row["soft"].slip_mm
        for chapters in releases.values() if "toy" in chapters
    ]
    ends = slips[:1] + slips[-1:]
    change = results.value(
        "change", "newest less oldest", lambda *slips: abs(slips[-1] - slips[0]), *ends,
        unit="mm", across=True,
    )
    same = at_most(change, 0.5, why="hardly seen")
    return Section(claims=[Claim("same", same, {"change": change})])
"""
STORY = """
from measured_report.parts.claim import Claim, all_of, at_least
from measured_report.parts.section import Section

def derive(releases, shown):
    if "toy" not in releases[shown]:
        return Section()
    soft = releases[shown]["toy"].results.row["soft"]
    every = [
        at_least(chapters["toy"].results.row["soft"].slip_mm, 1.0, why="seen")
        for chapters in releases.values() if "toy" in chapters
    ]
    claims = [
        Claim("advice", at_least(soft.slip_mm, 1.0, why="seen"), {"slip": soft.slip_mm}),
        Claim("everywhere", all_of(*every)),
    ]
    return Section(claims=claims)
"""
WORDS = {
    "sections/runs": """# Runs of one case
{% claim is_small %}{% holds %} They differ by {{ widest }}. {% fails %} They differ much. {% asks %} whether they differ {% endclaim %}
""",
    "sections/toy": """# A toy
{% claim helps %}{% holds %} It helps {{ gain }} times. {% fails %} It helps little. {% asks %} whether it helps {% endclaim %}
{% claim slips %}{% holds %} It slips {{ slip }}. {% fails %} It slips little. {% asks %} whether it slips {% endclaim %}
{% claim holds %}{% holds %} It holds, by {{ slip }}. {% fails %} It does not hold. {% asks %} whether it holds {% endclaim %}
{% passage needs="runs.is_small" %} Measured again it is the same. {% endpassage %}

{% table cases %} All cases {% endtable %}
""",
    "sections/pair": """# Two releases
{% claim same %}{% holds %} The same, within {{ change.most }}. {% fails %} They differ by {{ change }}. {% asks %} whether they are the same {% endclaim %}
""",
    "front": """# A report
{% passage needs="story.advice, toy.helps" %} **Make it stiff:** it [helps](#toy). {% otherwise %} See [the story](#story). {% endpassage %}
""",
    "story": """# The story
{% claim advice %}{% holds %} It slips {{ slip }}: make it stiff. {% fails %} Nothing is to be done. {% asks %} what to do {% endclaim %}
{% claim everywhere %}{% holds %} It slips in every release. {% fails %} In some it does not. {% asks %} where it slips {% endclaim %}
""",
}

Place = tuple[
    str, str, str
]  # a release, a replica or "" for the tracked record, a section
Row = dict[str, Any]


def lay_out_world(folder: Path) -> None:
    """Write the report of the worlds, without results."""
    put(folder, "report.toml", WORLD_SETTINGS)
    for name, module in zip(SECTIONS, (RUNS, TOY, PAIR), strict=True):
        put(folder, f"report/sections/{name}.py", module)
        put(folder, f"experiments/{name}.py", "")
    put(folder, "report/story/__init__.py", "")
    put(folder, "report/story/story.py", STORY)
    for name, words in WORDS.items():
        put(folder, f"templates/{name}.md.j2", words)


@dataclass
class World:
    """Holds the rows of all records and replicas, and the names of damaged files."""

    rows: dict[Place, list[Row]]
    spoiled: dict[str, Callable[[Path], object]] = field(default_factory=dict)
    """Kinds of damage to a file or folder, by its name below ``results``."""
    log: list[str] = field(default_factory=list)  # the changes in words

    def _repr_pretty_(self, printer: Any, _: bool) -> None:
        """Print the changes, as Hypothesis shows a failing example."""
        printer.text("; ".join(self.log))

    def write(self, toy: Toy, records: Mapping[tuple[str, str], Record]) -> None:
        """Write all results into a report that has none yet."""
        replicas: dict[tuple[str, str], list[Record]] = {}
        for (release, replica, section), rows in self.rows.items():
            units = {"slip_mm": "mm"}
            record = replace(records[release, section], rows=rows, units=units)
            if replica:
                replicas.setdefault((release, replica), []).append(record)
                continue
            path = toy.of(release).project.record_path(section)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(record_text(record), encoding="utf-8")
        for (release, replica), members in replicas.items():
            path = toy.of(release).project.results / FOLDER / f"{replica}.tgz"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(archive_of(members))
        for name, spoil in self.spoiled.items():
            path = toy.project.results.parent / name
            path.parent.mkdir(parents=True, exist_ok=True)
            spoil(path)

    def changed(self, other: "World") -> tuple[set[str], bool]:
        """Return pointers to cells that differ in another world, and whether scatter does.

        A number that was measured again differs if any of its measurements does, and
        numbers of the toy differ with the runs of their release.
        """
        changed = set()
        is_again = False
        for place in self.rows.keys() | other.rows.keys():
            release, replica, section = place
            pair = self.rows.get(place, []), other.rows.get(place, [])
            is_again |= pair[0] != pair[1] and bool(replica or REPLICAS[release])
            for index in range(max(map(len, pair))):
                rows = [rows[index] if index < len(rows) else {} for rows in pair]
                if rows[0] == rows[1] and not (section == "toy" and replica):
                    continue
                if rows[0] != rows[1]:
                    sections = ("runs", "toy") if section == "runs" else (section,)
                    for each in sections:
                        changed |= pointers(release, each)
        return changed, is_again


def pointers(release: str, section: str) -> set[str]:
    """Return pointers to all numbers that a section may have."""
    file = f"newton-{release}/{section}.json"
    return {f"{file}#/rows/{index}/slip_mm" for index in range(9)}


def first_world() -> World:
    """Return the undamaged world that tests alter."""
    rows: dict[Place, list[Row]] = {}
    for index, release in enumerate(RELEASES):
        factor = 1.0 + 0.01 * index
        for shift, replica in enumerate(("", *REPLICAS[release])):
            near = factor + 0.001 * shift
            rows[release, replica, "runs"] = [
                {
                    "case": f"soft-{run}",
                    "of": "soft",
                    "slip_mm": 6.3 * near + 0.01 * run,
                }
                for run in range(5)
            ]
            rows[release, replica, "toy"] = [
                {"case": "soft", "slip_mm": 6.3617 * near},
                {"case": "stiff", "slip_mm": 0.3124 * near},
                {"case": "stiffer", "slip_mm": 0.1 * near},
            ]
            if not replica:
                rows[release, "", "pair"] = [{"case": "pair", "slip_mm": 1.0}]
    return World(rows)


@dataclass(frozen=True)
class Said:
    """Holds the text of a claim, its outcome, its numbers, and the cells that it reads."""

    text: str
    answer: str
    numbers: Mapping[str, float | None]
    reads: frozenset[str]


def said_of(editions: Mapping[str, Edition]) -> dict[tuple[str, str, str], Said]:
    """Return the texts of all claims by release, section or text, and name."""
    templates = Templates(next(iter(editions.values())).project.templates)
    give_words(editions, templates)
    releases = {release: edition.chapters for release, edition in editions.items()}
    said = {}
    for release, edition in editions.items():
        sections = {name: each.section for name, each in edition.chapters.items()}
        story = edition.story("story", releases)
        if story.claims:
            words = templates.words("story.md.j2")
            sections["story"] = story.worded("story", "story.md.j2", words)
        for name, section in sections.items():
            for claim in section.claims:
                numbers = {
                    key: each
                    for key, each in claim.numbers.items()
                    if isinstance(each, Quantity)
                }
                reads = claim.outcome.reads.union(
                    *(number.reads for number in numbers.values())
                )
                values = {key: each.value for key, each in numbers.items()}
                answer = claim.outcome.answer
                said[release, name, claim.name] = Said(
                    f"{answer}: {claim.text}", answer, values, reads
                )
    return said
