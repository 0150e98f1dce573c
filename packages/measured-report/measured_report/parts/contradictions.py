"""Pairs of claims in ``templates/pairs.toml``, such as ``["gap.not_the_cause holds", "stiffness.cause fails"]``.

Of those that ``contradict`` not both may be said; of ``needs`` the first not without the second.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path

from measured_report.files.errors import ReportError
from measured_report.parts.section import Section
from measured_report.parts.words import table_beside

NAME = "pairs.toml"
KINDS = ("contradict", "needs")
Pairs = Mapping[str, Sequence[tuple[str, str]]]


def pairs_of(templates: Path) -> Pairs:
    """Read the pairs of a folder of templates, which need not be there; ReportError, one line, for what is none."""
    pairs = table_beside(templates, NAME)
    if unknown := sorted(pairs.keys() - KINDS):
        raise ReportError(f"templates/{NAME} has {unknown[0]}; it may have {' and '.join(KINDS)}")
    return pairs


def refuse_contradictions(pairs: Pairs, sections: Mapping[str, Section]) -> None:
    """Raise ReportError, one line, when what the sections of a release say does not go together."""
    claims = [(f"{name}.{claim.name}", claim) for name, section in sections.items() for claim in section.claims]
    said = {f"{place} {claim.outcome.name}" for place, claim in claims}
    known = {f"{name}.{each}" for name, section in sections.items() for each in section.unmeasured}
    known |= {place for place, _ in claims}
    for place in (words.partition(" ")[0] for found in pairs.values() for pair in found for words in pair):
        if place.partition(".")[0] in sections and place not in known:
            raise ReportError(f"templates/{NAME}: there is no claim {place}")
    for first, second in pairs.get("contradict", ()):
        if {first, second} <= said:
            raise ReportError(f"templates/{NAME}: {first} contradicts {second}, and both are said")
    for first, second in pairs.get("needs", ()):
        if first in said and second not in said:
            raise ReportError(f"templates/{NAME}: {first} needs {second}, which is not said")
