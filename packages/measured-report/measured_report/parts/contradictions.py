"""Pairs of claims that may not both be said, and claims whose words point back at another.

``templates/pairs.toml`` has ``contradict`` and ``needs``, lists of pairs such as ``["gap.not_the_cause holds",
"stiffness.cause fails"]``. Of ``contradict`` not both may be said; of ``needs`` the first not without the second.
"""

from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

from measured_report.files.config import read_toml
from measured_report.files.errors import ReportError
from measured_report.parts.section import Section

NAME = "pairs.toml"
KINDS = ("contradict", "needs")


Pairs = Mapping[str, Sequence[tuple[str, str]]]
"""Pairs of claims by kind."""


def pairs_of(templates: Path) -> Pairs:
    """Read the pairs of a folder of templates, which need not be there; ReportError, one line, for what is none."""
    path = templates / NAME
    if not path.is_file():
        return {}
    try:
        pairs = read_toml(path)
    except ValueError as error:
        raise ReportError(f"templates/{NAME}: {error}") from None
    if unknown := sorted(set(pairs) - set(KINDS)):
        raise ReportError(f"templates/{NAME} has {unknown[0]}; it may have {' and '.join(KINDS)}")
    return pairs


def contradictory(pairs: Pairs, said: Collection[str]) -> tuple[str, str] | None:
    """Find two of what is ``said``, each as ``section.claim outcome``, that contradict each other."""
    return next(
        ((first, second) for first, second in pairs.get("contradict", ()) if {first, second} <= set(said)), None
    )


def refuse_contradictions(templates: Path, sections: Mapping[str, Section]) -> None:
    """Raise ReportError, one line, when what the sections of a release say does not go together."""
    pairs = pairs_of(templates)
    for first, second in pairs.get("contradict", []):
        if _is_said(first, sections) and _is_said(second, sections):
            raise ReportError(f"templates/{NAME}: {first} contradicts {second}, and both are said")
    for first, second in pairs.get("needs", []):
        if _is_said(first, sections) and not _is_said(second, sections):
            raise ReportError(f"templates/{NAME}: {first} needs {second}, which is not said")


def _is_said(words: str, sections: Mapping[str, Section]) -> bool:
    """Tell whether a claim has an outcome, as in ``gap.not_the_cause holds``; what was not measured has none."""
    place, _, outcome = words.partition(" ")
    section, _, name = place.partition(".")
    if section not in sections:
        return False
    found = {claim.name: claim.outcome.name for claim in sections[section].claims}
    if name not in found and name not in sections[section].unmeasured:
        raise ReportError(f"templates/{NAME}: there is no claim {place}")
    return found.get(name) == outcome
