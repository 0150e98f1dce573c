"""Alarm: what a comparison and a check found, for people and, as docs/alarm.md says, for programs; worst first."""

import json
import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import Any

from measured_report.changes.compare import Comparison, compare, faults_of
from measured_report.changes.moves import NAMED, Move, few
from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.files.config import config
from measured_report.files.processes import forked
from measured_report.pages.editions import Chapter, Edition
from measured_report.pages.replicas import compared, derive_bare, kept, replicas_of
from measured_report.pages.sections import outline_of
from measured_report.parts.claim import NEAR_NOISE, Claim
from measured_report.records.columns import column_of
from measured_report.records.replicas import FOLDER, Records
from measured_report.values.noise import ROUNDING_SHARE
from measured_report.values.quantities import VALUES_FILE, Quantity, Value

SCHEMA = 1
LINES = 5
"""Chosen: so many of the largest moves are told."""
MARKDOWN_LIMIT = 60_000
"""Characters; a comment on GitHub holds 65,536."""


def _formed(kind: str, is_alarm: bool, lines: Iterable[str], parts: dict[str, Any], form: str) -> str:
    """Write lines as text, as a block of Markdown, in which none of it means anything, or their parts as JSON."""
    if form == "json":
        said = {"schema": SCHEMA, "kind": kind, "status": int(is_alarm), **parts}
        return json.dumps(said, indent=1, ensure_ascii=False)
    text = "\n".join(lines).rstrip()
    return text if form == "text" else "\n".join(["```text", text.replace("```", "'''")[:MARKDOWN_LIMIT], "```"])


def check_text(edition: Edition, form: str) -> str:
    """Return what an edition says, each claim once, as text, markdown or json."""
    faults = faults_of(edition)
    claims = [(name, claim) for name, chapter in edition.chapters.items() for claim in chapter.section.claims]
    absent = [(state.section, state.words or "it was not measured") for state in edition.left_out]
    parts = {
        config().edition: edition.project.release,
        "faults": list(map(vars, faults)),
        "claims": [{"section": section, "claim": claim.name, **_claim_data(claim)} for section, claim in claims],
        "absent": [{"section": section, "reason": reason} for section, reason in absent],
    }
    lines = [fault.text for fault in faults]
    for section, claim in claims:
        confirmed = f" ({claim.confirmed})" if claim.confirmed else ""
        lines.append(f"{claim.outcome.said:12} {section}.{claim.name}: {claim.text}{confirmed}")
    lines += [f"{'absent':12} {section}: {reason}" for section, reason in absent]
    return _formed("check", bool(faults), lines, parts, form)


def diff_text(found: Comparison, rate: str, form: str) -> str:
    """Return the comparison as text, markdown or json; beside what it counts stands the ``rate`` of false alarms."""
    first, counts, *lines = _diff_lines(found)
    told = [first, f"{counts}; false alarms: {rate}", *lines]
    return _formed("diff", found.is_alarm, told, {"false_alarms": rate, **_diff_data(found)}, form)


def upgrade_text(found: Comparison, verdict: Sequence[str], form: str) -> str:
    """Return the verdict on an upgrade as text, markdown or json; the last two with all of the comparison."""
    lines = verdict if form == "text" else [*verdict, "", *_diff_lines(found)]
    return _formed("upgrade", found.is_alarm, lines, {"verdict": list(verdict), **_diff_data(found)}, form)


def _diff_lines(found: Comparison) -> list[str]:
    counts: dict[str, Sequence] = {
        "can't be trusted": found.faults,
        "alarms": found.alarms,
        "claims that flipped": found.flips,
        "values that moved beyond the noise": found.moves,
        "of these near it": [move for move in found.moves if move.is_inconclusive],
    }
    lines = [" → ".join(f"{config().edition} {release}" for release in found.releases)]
    lines += ["; ".join(f"{words}: {len(those)}" for words, those in counts.items())]
    lines += [*(fault.text for fault in found.faults), f"settings: {settings_text(found.settings)}", *largest(found)]
    lines.append(f"would have shown: {power(found)}")
    for flip in found.flips:
        lines += [f"{flip.claim}: {flip.outcomes}", f"  {flip.before.text}", f"  {flip.after.text}"]
    for section, sums in _sums(found).items():
        lines.append(f"{section}: {', '.join(f'{count} {word}' for word, count in sums.items() if count)}")
    lines += ["FORMAT=json lists them"] if found.moves else []
    lines += ["", *(f"not compared: {note}" for note in found.notes)]
    lines += [f"missing in one of them, so that no alarm says: {', '.join(found.missing)}"] if found.missing else []
    return lines


def _sums(found: Comparison) -> dict[str, Counter]:
    sums: dict[str, Counter] = {}
    for move in found.moves:
        counts = sums.setdefault(move.section, Counter(moved=0, better=0, worse=0, near=0))
        counts.update(filter(None, ("moved", "near" if move.is_inconclusive else move.direction)))
    return sums


def _diff_data(found: Comparison) -> dict[str, Any]:
    flips = [
        {"section": flip.section, "claim": flip.name}
        | {"before": _claim_data(flip.before), "after": _claim_data(flip.after)}
        for flip in found.flips
    ]
    return {
        "a": found.releases[0],
        "b": found.releases[1],
        "faults": list(map(vars, found.faults)),
        "flips": flips,
        "settings": [_move_data(move) for move in found.settings],
        "alarms": [move.name for move in found.alarms],
        "largest": largest(found),
        "moved": _sums(found),
        "moves": [_move_data(move) for move in found.moves],
        "notes": found.notes,
    }


def _claim_data(claim: Claim) -> dict[str, str]:
    said = {"outcome": claim.outcome.name, "said": claim.outcome.said, "text": claim.text}
    return said | {"confirmed": claim.confirmed}


def _move_data(move: Move) -> dict[str, Any]:
    before = move.sides[0]
    return {
        "section": move.section,
        **move.place,
        "column": move.column,
        "before": move.before,
        "after": move.after,
        "unit": before.unit if isinstance(before, Quantity) else None,
        "noise": move.noise,
        "noise_is_chosen": move.is_chosen,
        "is_near": move.is_inconclusive,
        "verdict": move.direction,
    }


def largest(found: Comparison) -> list[str]:
    """Tell the largest moves in a line each, one of each column and in how many rows that moved; alarms first."""
    columns: dict[str, list[Move]] = {}
    for move in sorted(filter(_is_told, found.moves), key=_rank, reverse=True):
        columns.setdefault(move.column, []).append(move)
    lines = []
    for lead, *others in list(columns.values())[:LINES]:
        share = "" if lead.share is None or math.isinf(lead.share) else f", {100 * lead.share:+.2g} %"
        place = f"{lead.section} {lead.place.get('case', '')}".strip()
        place += f"; and {len(others)} more" if others else ""
        said = f"{'alarm: ' if lead.exceeds_threshold else ''}{column_of(lead.column).words} {lead.ends}{share}"
        lines.append(f"{said} {lead.direction}".rstrip() + f" ({place})")
    return lines


def _is_told(move: Move) -> bool:
    """Tell whether it may lead: a number that changed or is gone, or an alarm; settings are told by themselves."""
    is_setting = move.is_setting or column_of(move.column).is_setting
    is_lost = move.is_gone and move.after is None
    return not (is_setting or move.is_inconclusive) and bool(move.share or is_lost or move.exceeds_threshold)


def _rank(move: Move) -> tuple[bool, bool, bool, float]:
    """Put alarms first, of these what was given, then what decides, and then what is farthest beyond its noise."""
    sure = 1.0
    if move.share:
        sure = (abs(move.after - move.before) - move.least) / max(abs(move.before), abs(move.after))
    is_cause = move.exceeds_threshold and "given" in column_of(move.column).kinds
    return move.exceeds_threshold, is_cause, move.section in config().changes.deciding, sure


def settings_text(settings: Sequence[Move]) -> str:
    """Name the settings that changed, alarms first, and those that only one edition has."""
    changed = [move for move in settings if None not in (move.before, move.after)]
    changed.sort(key=lambda move: not move.exceeds_threshold)
    told = [few([f"{move.place['case']} {move.ends}" for move in changed], 2 * NAMED)] if changed else []
    for word, side in (("new", "before"), ("gone", "after")):
        if lone := [move.place["case"] for move in settings if getattr(move, side) is None]:
            told.append(f"{word}: {', '.join(lone)}")
    return "; ".join(told) or "all as they were"


def power(found: Comparison) -> str:
    """Say the least change of each named number that would have shown, and which were not measured in both."""
    least: dict[str, float] = {}
    for cell in found.cells:
        if cell.name in config().changes.thresholds and cell.share is not None and cell.before:
            words = column_of(cell.column).words
            least[words] = max(least.get(words, ROUNDING_SHARE), NEAR_NOISE * cell.least / abs(cell.before))
    told = ", ".join(f"{words} from {100 * share:.2g} %" for words, share in least.items()) or "nothing that is named"
    return told + (f"; not measured in both: {', '.join(found.missing)}" if found.missing else "")


LEAST = 3
"""Measurements that it takes: the noise of those that stay comes from two of them."""


COUNTED = ("comparisons", "rang", "claims", "flips", "numbers", "moves")
"""Comparisons in which nothing had changed, a section each, those that rang, and what was told of what they compare."""
Rate = Counter[str]


def rate_values(rate: Rate, project: Project) -> dict[str, Value]:
    """Return the counts for a page, by name; none where there was nothing to compare."""
    place = f"{config().edition_folder(project.release)}/{VALUES_FILE}#/{FOLDER}"
    formula = "each measurement left out in turn and compared with the others: "
    return {
        name: Value(rate[name], "1", f"{place}/{name}", noise=0.0, formula=formula + name) for name in COUNTED if rate
    }


def rate_text(rate: Rate) -> str:
    """Say how often nothing had changed and something was told."""
    if not rate:
        return "not known: no section has been measured three times"
    words = "of {comparisons} comparisons in which nothing changed {rang} rang "
    words += "({flips} of {claims} claims flipped, {moves} of {numbers} numbers moved)"
    return words.format_map(rate)


def rate_of(edition: Edition) -> Rate:
    """Return the rate of an edition's replicas, kept from before or found now."""
    tracked = {name: chapter.results.record for name, chapter in edition.chapters.items()}
    several = [name for name, of in edition.measurements.apart.items() if of.count >= LEAST and name in tracked]

    def find() -> Rate:
        replicas = [*replicas_of(edition.project, tracked).values()]
        measured = [tracked, *replicas]
        return sum(forked(lambda out: _rate(edition.project, measured, out, several), len(measured)), Rate())

    return kept(edition.project, tracked, edition.cache, "rate", find) if several else Rate()


def _rate(project: Project, measured: Sequence[Records], out: int, several: Sequence[str]) -> Rate:
    asked = [name for name in several if name in measured[out]]
    single = {**measured[0], **measured[out]}
    rest = [each for place, each in enumerate(measured) if place != out]
    first = {**measured[0], **{name: record for each in reversed(rest) for name, record in each.items()}}
    left = [{name: each[name] for name in asked if name in each and each[name] is not first[name]} for each in rest]
    before, after = _edition(project, first, left, asked), _edition(project, single, [], asked)
    return sum(_counted(compare(before, after), asked, before), Rate())


def _edition(project: Project, records: Records, replicas: Sequence[Records], asked: Collection[str]) -> Edition:
    measurements = compared(project, records, replicas)
    chapters: dict[str, Chapter] = {}
    for name, (results, section) in derive_bare(project, records, measurements.apart, asked).items():
        said = measurements.confirmed(name, section)
        chapters[name] = Chapter(State(name, "fresh", results.record), results, said, {}, None, outline_of(name).page)
    return Edition(project, chapters, [], measurements=measurements)


def _counted(found: Comparison, sections: Sequence[str], before: Edition) -> Iterator[Rate]:
    for name in sections:
        flips = sum(flip.section == name for flip in found.flips)
        told = [move.section for move in found.alarms]
        told += [fault.section for fault in found.faults if fault.kind == "broken"]
        cells = [cell for cell in found.cells if cell.section == name]
        claims = len(before.chapters[name].section.claims) if name in before.chapters else 0
        counts = 1, bool(flips) or name in told, claims, flips, len(cells), sum(cell.is_real for cell in cells)
        yield Rate(dict(zip(COUNTED, counts, strict=True)))
