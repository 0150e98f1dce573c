"""Write the results of a comparison or of a check for people and for programs.

The worst results come first. docs/alarm.md describes the formats.
"""

import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from statistics import median
from typing import Any

from measured_report.changes.compare import Comparison, faults_of
from measured_report.changes.moves import NAMED, Move, few
from measured_report.files.settings import Changes
from measured_report.findings.editions import Edition
from measured_report.parts.claim import Claim
from measured_report.records.replicas import FOLDER
from measured_report.values.format import format_share
from measured_report.values.noise import FALSE_SHARE, SURE
from measured_report.values.quantities import VALUES_FILE, Value

SCHEMA = 1
LINES = 5  # chosen: the largest number of changes that a text lists
MARKDOWN_LIMIT = 60_000  # characters; a comment on GitHub holds 65,536


def _json(kind: str, is_alarm: bool, parts: dict[str, Any]) -> str:
    return json.dumps(
        {"schema": SCHEMA, "kind": kind, "status": int(is_alarm), **parts},
        indent=1,
        ensure_ascii=False,
        allow_nan=False,
    )


def _lines(lines: Iterable[str], form: str) -> str:
    """Return lines as text, or as a block of Markdown that shows them unchanged.

    If a block is too long for a comment, it is cut and ends with a note.
    """
    text = "\n".join(lines).rstrip()
    if form == "text":
        return text
    text = text.replace("```", "'''")
    if len(text) > MARKDOWN_LIMIT:
        whole_lines = text[:MARKDOWN_LIMIT].rpartition("\n")[0]
        text = f"{whole_lines}\n… shortened: FORMAT=json has everything"
    return "\n".join(["```text", text, "```"])


Say = Callable[[str, Claim], str]  # returns the sentence of a section's claim


def check_text(edition: Edition, form: str, say: Say) -> str:
    """Return the faults and all claims of an edition as text, markdown or json."""
    faults = faults_of(edition)
    settings = edition.project.report.settings
    claims = [
        (name, claim)
        for name, chapter in edition.chapters.items()
        for claim in chapter.section.claims
    ]
    absent = [
        (state.section, state.words or "it was not measured")
        for state in edition.left_out
    ]
    if form == "json":
        outcomes = [
            {"section": name, "claim": claim.name, **_claim_data(name, claim, say)}
            for name, claim in claims
        ]
        reasons = [{"section": section, "reason": reason} for section, reason in absent]
        parts = {
            "faults": list(map(vars, faults)),
            "claims": outcomes,
            "absent": reasons,
        }
        return _json(
            "check", bool(faults), {settings.edition: edition.project.release, **parts}
        )
    lines = [fault.text(settings) for fault in faults]
    for section, claim in claims:
        confirmed = f" ({claim.confirmed})" if claim.confirmed else ""
        lines.append(
            f"{claim.outcome.answer:12} {section}.{claim.name}: {say(section, claim)}{confirmed}"
        )
    lines += [f"{'absent':12} {section}: {reason}" for section, reason in absent]
    return _lines(lines, form)


def diff_text(comparison: Comparison, rate: str, form: str, say: Say) -> str:
    """Return the comparison and the ``rate`` of false alarms as text, markdown or json."""
    if form == "json":
        return _json(
            "diff",
            comparison.is_alarm,
            {"false_alarms": rate, **_diff_data(comparison, say)},
        )
    editions = " → ".join(
        f"{comparison.report.settings.edition} {release}"
        for release in comparison.releases
    )
    counts = f"faults: {len(comparison.faults)}; alarms: {len(comparison.alarms)}"
    counts += f"; better: {len(comparison.improvements)}"
    counts += f"; claims that flipped: {len(comparison.flips)}; values that changed: {len(comparison.moves)}"
    lines = [f"{editions}: {summary(comparison)}", f"{counts}; false alarms: {rate}"]
    lines += [
        fault.text(comparison.report.settings) for fault in comparison.faults[:NAMED]
    ]
    lines += [f"settings: {settings_text(comparison.settings)}", *largest(comparison)]
    lines += [
        f"changes that would have been detected: {sensitivity_text(comparison)}",
        *_details(comparison, say),
    ]
    return _lines(lines, form)


def upgrade_text(
    comparison: Comparison, verdict: Sequence[str], form: str, say: Say
) -> str:
    """Return the verdict on an upgrade as text, markdown or json.

    Only the text leaves out the details of the comparison.
    """
    if form == "json":
        return _json(
            "upgrade",
            comparison.is_alarm,
            {"verdict": list(verdict), **_diff_data(comparison, say)},
        )
    return _lines(
        verdict if form == "text" else [*verdict, "", *_details(comparison, say)], form
    )


def _details(comparison: Comparison, say: Say) -> list[str]:
    """Return the lines about a comparison that its verdict does not include."""
    lines = [
        fault.text(comparison.report.settings) for fault in comparison.faults[NAMED:]
    ]
    for flip in comparison.flips:
        lines += [
            f"{flip.claim}: {flip.outcomes}",
            *(f"  {say(flip.section, claim)}" for claim in flip.ends),
        ]
    for section, counts in _counts(comparison).items():
        texts = [f"{count} {verdict}" for verdict, count in counts.items() if count]
        lines.append(f"{section}: {', '.join(texts)}")
    if comparison.moves:
        lines.append("FORMAT=json lists every value that moved")
    lines += ["", *(f"not compared: {note}" for note in comparison.notes)]
    if comparison.missing:
        lines.append(
            "missing in one edition, so they cannot raise an alarm: "
            f"{', '.join(comparison.missing)}"
        )
    return lines


def _counts(comparison: Comparison) -> dict[str, Counter[str]]:
    """Return how many values of each section moved, got better and got worse."""
    counts: dict[str, Counter[str]] = {}
    for move in comparison.moves:
        of_section = counts.setdefault(
            move.section, Counter(moved=0, better=0, worse=0)
        )
        of_section.update(filter(None, ("moved", move.direction)))
    return counts


def _diff_data(comparison: Comparison, say: Say) -> dict[str, Any]:
    flips = []
    for flip in comparison.flips:
        before, after = (_claim_data(flip.section, claim, say) for claim in flip.ends)
        flips.append(
            {
                "section": flip.section,
                "claim": flip.name,
                "before": before,
                "after": after,
            }
        )
    return {
        "a": comparison.releases[0],
        "b": comparison.releases[1],
        "faults": list(map(vars, comparison.faults)),
        "flips": flips,
        "settings": [_move_data(move) for move in comparison.settings],
        "alarms": [move.name for move in comparison.alarms],
        "improvements": [move.name for move in comparison.improvements],
        "sensitivity": sensitivity(comparison),
        "largest": largest(comparison),
        "moved": _counts(comparison),
        "moves": [_move_data(move) for move in comparison.moves],
        "notes": comparison.notes,
    }


def _claim_data(section: str, claim: Claim, say: Say) -> dict[str, str]:
    outcome = claim.outcome
    text = say(section, claim)
    return {
        "outcome": outcome.name,
        "said": outcome.answer,
        "text": text,
        "confirmed": claim.confirmed,
    }


def _move_data(move: Move) -> dict[str, Any]:
    # Looking up the cells of all numbers would take as long as the comparison.
    side = move.column if move.chance is not None else move.sides[0]
    return {
        "section": move.section,
        **move.place,
        "column": move.column.name,
        "before": move.before,
        "after": move.after,
        "unit": getattr(side, "unit", None),
        "noise": move.noise,
        "noise_is_chosen": move.is_chosen,
        "rows": move.row_count,
        "relevance": move.relevance if math.isfinite(move.relevance) else None,
        "verdict": move.direction,
    }


def summary(comparison: Comparison) -> str:
    """Return how many numbers changed, and how many moves exceed their threshold."""
    count = comparison.number_count
    if not (changed := sum(move.chance is not None for move in comparison.moves)):
        return f"0 of {count} numbers changed by more than their noise"
    text = f"{changed} of {count} numbers changed; changes above their threshold: {len(comparison.alarms)}"
    better_count = len(comparison.improvements)
    return f"{text}; improvements: {better_count}" if better_count else text


def largest(comparison: Comparison) -> list[str]:
    """Return lines for the columns with the largest changes, alarms first.

    Improvements and other changes of a column have a line each. It contains the largest
    change, and the number of other rows that changed in the same way.
    """
    columns: dict[tuple[str, bool], list[Move]] = {}
    rank = partial(_rank, rules=comparison.report.settings.changes)
    for move in sorted(comparison.moves, key=rank, reverse=True):
        # Settings have a line of their own.
        is_setting = move.is_setting or move.column.is_setting
        if not is_setting and (
            move.share
            or (move.is_gone and move.after is None)
            or move.exceeds_threshold
        ):
            is_better = move.direction == "better"
            columns.setdefault((move.column.name, is_better), []).append(move)
    listed = [*columns][:LINES]
    # Alarms come first, so one line is reserved for improvements.
    listed += [key for key in columns if key[1] and key not in listed][:1]
    lines = []
    for lead, *lesser_moves in map(columns.__getitem__, listed):
        # A percentage of a number close to zero has no meaning.
        is_near_zero = lead.share is None or abs(lead.before) < lead.scale
        share = ""
        if lead.share is not None and not (is_near_zero or math.isinf(lead.share)):
            share = f", {format_share(lead.share, '+')}"
        case = lead.place.get("case", "")
        if lead.row_count > 1:
            case = f"median of {lead.row_count} rows"
        location = f"{lead.section} {case}".strip()
        location += f"; and {len(lesser_moves)} more" if lesser_moves else ""
        text = f"{'alarm: ' if lead.is_alarm else ''}{lead.column.words} {lead.ends}{share}"
        lines.append(f"{text} {lead.direction}".rstrip() + f" ({location})")
    return lines


def _rank(move: Move, rules: Changes) -> tuple[bool | float, ...]:
    """Return the rank of a change; alarms have the highest.

    Among alarms, computed parameters of the engine come first because they may be the
    cause. Numbers that ``report.toml`` names follow, then deciding sections, columns with
    a threshold, and finally the changes that exceed their threshold most.
    """
    is_cause = move.exceeds_threshold and "computed" in move.column.kinds
    is_column = any(name.endswith(f".{move.column.name}") for name in rules.thresholds)
    is_deciding = move.section in rules.upgrade_sections
    return (
        move.is_alarm,
        is_cause,
        move.is_named,
        is_deciding,
        is_column,
        move.relevance,
    )


def settings_text(settings: Sequence[Move]) -> str:
    """Return the settings that changed, alarms first, and the settings that one edition
    lacks.
    """
    changed = [move for move in settings if None not in (move.before, move.after)]
    changed.sort(key=lambda move: not move.exceeds_threshold)
    texts = (
        [few([f"{move.place['case']} {move.ends}" for move in changed], 2 * NAMED)]
        if changed
        else []
    )
    for label, side in (("new", "before"), ("gone", "after")):
        if names := [
            move.place["case"] for move in settings if getattr(move, side) is None
        ]:
            texts.append(f"{label}: {', '.join(names)}")
    return "; ".join(texts) or "unchanged"


def sensitivity(comparison: Comparison) -> dict[str, float]:
    """Return the smallest relative change that would be listed for most numbers, by
    section. This is the median noise of its numbers relative to their size.
    """
    shares: dict[str, list[float]] = {}
    for cell in comparison.cells:
        size = (
            max(abs(cell.before or 0.0), cell.scale) if cell.chance is not None else 0
        )
        if size and not (cell.is_setting or cell.column.is_exact):
            noise = replace(cell, limit=FALSE_SHARE).noise or 0.0
            shares.setdefault(cell.section, []).append(noise / size)
    return {section: median(numbers) for section, numbers in shares.items()}


def blind_sections(comparison: Comparison) -> list[str]:
    """Return the sections in which a change above the threshold might not be listed.

    A section that measures only costs uses the cost threshold.
    """
    rules = comparison.report.settings.changes
    has_physics = {
        cell.section
        for cell in comparison.cells
        if cell.chance is not None
        and not (cell.is_setting or cell.column.is_exact or cell.column.is_cost)
    }
    return [
        section
        for section, share in sensitivity(comparison).items()
        if share > (rules.threshold if section in has_physics else rules.cost_threshold)
    ]


def sensitivity_text(comparison: Comparison) -> str:
    """Return the change that would be listed in each section, the largest first."""
    shares = sensitivity(comparison)
    sections = sorted(shares, key=shares.__getitem__, reverse=True)
    texts = [f"{section} {format_share(shares[section])}" for section in sections]
    missing = comparison.missing
    text = few(texts, 2 * NAMED) or "no section has numbers to compare"
    if missing:
        text += f"; not measured in both editions: {', '.join(missing)}"
    return text


def false_alarm_counts(edition: Edition) -> Counter[str]:
    """Count false alarms in comparisons between the measurements of an edition.

    The result contains the number of comparisons, of comparisons that list a change
    (``told``), of compared numbers, and of listed numbers (``moves``). All measurements
    used the same release, so each listed change is a false alarm. The result is empty
    if no section was measured three times.
    """
    counts: Counter[str] = Counter()
    for evidence in edition.measurements.evidence.values():
        for numbers, moves in evidence.changed:
            if numbers:
                counts.update(
                    comparisons=1, told=int(moves > 0), numbers=numbers, moves=moves
                )
    return counts


def rate_values(edition: Edition) -> dict[str, Value]:
    """Return the counts of false alarms as values for a page, by name."""
    formula = "each measurement left out in turn and compared with the others: "
    counts = false_alarm_counts(edition).items()
    return {name: _count(edition, name, count, formula) for name, count in counts}


def calibration_values(edition: Edition) -> dict[str, Value]:
    """Return the share of measurements that lie within the noise predicted by the
    others. For each kind of number, the values are the share [%] and the number of
    measurements in all editions.
    """
    values = {}
    for kind, (inside, total) in edition.measurements.calibration.items():
        if not total:
            continue
        formula = (
            f"{kind}: each measurement left out in turn and predicted by the others"
        )
        values[f"{kind}_total"] = _count(edition, f"{kind}_total", total, formula)
        share = _count(edition, f"{kind}_share", 100 * inside / total, formula)
        # Shares are printed to a tenth; their own sampling error is about as large.
        values[f"{kind}_share"] = replace(share, unit="%", noise=0.2)
    if values:
        formula = "chosen: the usual level of a confidence interval"
        aim = _count(edition, "aim", 100 * SURE, formula)
        values["aim"] = replace(aim, unit="%")
    return values


def _count(edition: Edition, name: str, number: float, formula: str) -> Value:
    pointer = f"{edition.project.results.name}/{VALUES_FILE}#/{FOLDER}/{name}"
    return Value(number, "1", pointer, noise=0.0, formula=formula)


def rate_text(rate: Mapping[str, int]) -> str:
    """Return a sentence about how often a change was listed although the release was
    the same.
    """
    if not rate:
        return "not known, because no section has been measured three times"
    text = "in {told} of {comparisons} comparisons of one release with itself, for {moves} of {numbers} numbers"
    return text.format_map(rate)
