"""What the figures of other scenes call their cases."""

from collections.abc import Iterable

from markupsafe import Markup

WORDS = {
    "recipe": "elliptic cone, impratio 10",
    "elliptic-cone": "elliptic cone",
    "elliptic": "elliptic cone",
    "pyramidal": "pyramidal cone",
    "stiff": "stiff pads",
    "within-pads": "shorter than the pads",
    "published": "as published",
    "short": "timeconst 4 ms",
}


def name_of(case: str) -> str:
    """Return the label of a case: of the whole name, or of its parts."""
    if case in WORDS or case.startswith(("impratio", "condim")):
        return WORDS.get(case, case.replace("-", " "))
    return ", ".join(WORDS.get(part, part.replace("ms", " ms")) for part in case.split("-"))


def cases_html(cases: Iterable[str]) -> Markup:
    """Name cases in a sentence; ``none`` where there are none."""
    span = Markup('<span class="case" title="{}">{}</span>')
    return Markup("; ").join(span.format(case, name_of(case)) for case in cases) or Markup("none")
