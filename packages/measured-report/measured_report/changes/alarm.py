"""Alarm: what a comparison and a check found, for people, for a pull request and for a program; worst first.

docs/alarm.md says what the JSON holds.
"""

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from measured_report.changes.compare import Comparison
from measured_report.changes.faults import Fault, faults_of
from measured_report.changes.largest import largest, settings_text
from measured_report.changes.moves import Move
from measured_report.files.config import config
from measured_report.pages.editions import Edition
from measured_report.parts.claim import Claim
from measured_report.values.quantities import Quantity

SCHEMA = 1

MARKDOWN_LIMIT = 60_000
"""Characters; a comment on GitHub holds 65,536."""


def check_text(edition: Edition, form: str) -> str:
    """Return what an edition says, each claim once, as text, markdown or json."""
    release, faults = edition.project.release, faults_of(edition)
    claims = [(name, claim) for name, chapter in edition.chapters.items() for claim in chapter.section.claims]
    absent = [(state.section, state.words or "it was not measured") for state in edition.left_out]
    if form == "json":
        parts = {
            "faults": list(map(vars, faults)),
            "claims": [{"section": section, "claim": claim.name, **_claim_data(claim)} for section, claim in claims],
            "absent": [{"section": section, "reason": reason} for section, reason in absent],
        }
        return _json("check", bool(faults), **{config().package: release}, **parts)
    said = [(f"{section}.{claim.name}", claim.outcome.said, claim.text) for section, claim in claims]
    if form == "markdown":
        counts = Counter(outcome for _, outcome, _ in said)
        counted = ", ".join(f"{count} {outcome}" for outcome, count in counts.items())
        told = _table(("claim", "outcome", "says"), [line for line in said if line[1] != "holds"])
        return _markdown(f"### {config().edition_name} {release}: {counted}", *_fault_table(faults), *told)
    lines = [fault.text for fault in faults]
    lines += [f"{outcome:12} {name}: {text}" for name, outcome, text in said]
    lines += [f"{'absent':12} {section}: {reason}" for section, reason in absent]
    return "\n".join(lines)


def diff_text(found: Comparison, form: str, *, all_values: bool) -> str:
    """Return the comparison as text, markdown or json, every value that moved in it or only how many did."""
    if form == "json":
        return _json("diff", found.is_alarm, **_diff_data(found))
    if form == "markdown":
        return _markdown(*_diff_in_markdown(found))
    lines = [" → ".join(f"{config().package} {release}" for release in found.releases), _summary(found)]
    lines += [fault.text for fault in found.faults] + _leading(found) + [flip.text for flip in found.flips]
    lines += ["", *(_sum_line(section, sums) for section, sums in _sums(found.moves).items())]
    if all_values:
        for section in _sums(found.moves):
            lines += ["", section, *(f"  {move.text}" for move in found.moves if move.section == section)]
    elif found.moves:
        lines += ["VALUES=all lists them"]
    lines += ["", *(f"not compared: {note}" for note in found.notes)]
    lines += [f"missing in one of them, so that no alarm says: {', '.join(found.missing)}"] if found.missing else []
    return "\n".join(lines).rstrip()


def upgrade_text(found: Comparison, verdict: Sequence[str], form: str) -> str:
    """Return the verdict on an upgrade as text, markdown or json; the last two with all of the comparison."""
    if form == "json":
        return _json("upgrade", found.is_alarm, verdict=list(verdict), **_diff_data(found))
    if form == "markdown":
        return _markdown(*(f"- {_escaped(line)}" for line in verdict), "", *_diff_in_markdown(found))
    return "\n".join(verdict)


def _leading(found: Comparison) -> list[str]:
    """Say which settings changed, and the largest moves."""
    return [f"settings: {settings_text(found.settings)}", *(group.text for group in largest(found))]


def _summary(found: Comparison) -> str:
    """Count what differs, in one line."""
    near = sum(move.is_inconclusive for move in found.moves)
    return (
        f"can't be trusted: {len(found.faults)}; alarms: {len(found.alarms)}; claims that flipped: {len(found.flips)}; "
        f"values that moved beyond the noise: {len(found.moves)}, of these near it: {near}"
    )


def _diff_in_markdown(found: Comparison) -> list[str]:
    lines = [f"### {config().edition_name} {' → '.join(found.releases)}", "", _summary(found).capitalize() + "."]
    flipped = [(flip.claim, flip.outcomes, flip.after.text) for flip in found.flips]
    sums = [(section, *sums.values()) for section, sums in _sums(found.moves).items()]
    lines += [*_fault_table(found.faults), "", *(f"- {_escaped(line)}" for line in _leading(found))]
    lines += _table(("claim that flipped", "outcome", "now"), flipped)
    lines += _table(("section", "moved", "better", "worse", "near the noise"), sums)
    if found.notes:
        notes = (f"- {_escaped(note)}" for note in found.notes)
        lines += ["", "<details><summary>Not compared</summary>", "", *notes, "", "</details>"]
    return lines


def _fault_table(faults: Iterable[Fault]) -> list[str]:
    rows = [(fault.kind, fault.release, fault.place, fault.reason) for fault in faults]
    return _table(("can't be trusted", config().package, "where", "why"), rows)


def _table(heads: Sequence[str], rows: Sequence[Sequence[Any]]) -> list[str]:
    """Return the lines of a table, after an empty one; none without rows."""
    if not rows:
        return []
    lines = [f"| {' | '.join(_escaped(cell) for cell in row)} |" for row in rows]
    return ["", f"| {' | '.join(heads)} |", f"|{'---|' * len(heads)}", *lines]


def _escaped(cell: Any) -> str:
    """Return text that no Markdown is made of: records may hold any."""
    text = " ".join(str(cell).split())
    for mark in "\\`*_[]<>|@#":
        text = text.replace(mark, f"\\{mark}" if mark != "@" else "@\u200b")
    return text


def _markdown(*lines: str) -> str:
    """Return the lines, no more of them than a comment holds."""
    text = "\n".join(lines)
    return text if len(text) <= MARKDOWN_LIMIT else f"{text[:MARKDOWN_LIMIT].rpartition(chr(10))[0]}\n\n… and more\n"


def _sums(moves: Iterable[Move]) -> dict[str, dict[str, int]]:
    """Count by section how many values moved, how many of them for better and worse, and how many near the noise."""
    sums: dict[str, dict[str, int]] = {}
    for move in moves:
        found = sums.setdefault(move.section, dict.fromkeys(("moved", "better", "worse", "near"), 0))
        for name in ("moved", "near" if move.is_inconclusive else move.direction):
            if name:
                found[name] += 1
    return sums


def _sum_line(section: str, sums: Mapping[str, int]) -> str:
    words = {"better": "better", "worse": "worse", "near": "near the noise"}
    parts = [f"{sums[name]} {said}" for name, said in words.items() if sums[name]]
    return f"{section}: {sums['moved']} values moved" + (f" ({', '.join(parts)})" if parts else "")


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
        "largest": [group.text for group in largest(found)],
        "moved": _sums(found.moves),
        "moves": [_move_data(move) for move in found.moves],
        "notes": found.notes,
    }


def _claim_data(claim: Claim) -> dict[str, str]:
    return {"outcome": claim.outcome.name, "said": claim.outcome.said, "text": claim.text}


def _move_data(move: Move) -> dict[str, Any]:
    before, after = move.values
    return {
        "section": move.section,
        **move.place,
        "column": move.column,
        "before": before,
        "after": after,
        "unit": move.before.unit if isinstance(move.before, Quantity) else None,
        "noise": move.noise,
        "noise_is_chosen": move.is_chosen,
        "is_near": move.is_inconclusive,
        "verdict": move.direction,
    }


def _json(kind: str, is_alarm: bool, **parts: Any) -> str:
    said = {"schema": SCHEMA, "kind": kind, "status": int(is_alarm), **parts}
    return json.dumps(said, indent=1, ensure_ascii=False)
