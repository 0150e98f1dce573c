"""A check of templates: ``{% fails %}`` says no more than that something is not shown.

A claim fails for want of what would show it as well as where its contrary is shown. So what stands between two stops in
``{% fails %}`` names a number, or its sentence says that this is not shown (not seen, cannot be told); and nothing is
compared there but with a number. The contrary has ``{% opposite %}``, which is said only where it is shown.
"""

import re
from collections.abc import Iterator
from pathlib import Path

CLAIM = re.compile(r"\{%-?\s*claim (\w+)\s*-?%\}(.*?)\{%-?\s*endclaim", re.DOTALL)
FAILS = re.compile(r"\{%-?\s*fails\s*-?%\}(.*?)(?=\{%-?\s*(?:holds|opposite|asks|because)\b|$)", re.DOTALL)
PRINTED, BRANCH = re.compile(r"\{\{.*?\}\}", re.DOTALL), re.compile(r"\{% el.*?%\}")
TAG = re.compile(r"\{%.*?%\}|<[^>]*>")
NUMBER = "#"
"""Stands for whatever is printed."""

SENTENCE, STOP = re.compile(r"[.;?!](?:\s|$)"), re.compile(r":\s")
UNSHOWN = re.compile(
    r"\b(?:cannot|(?:not?|none|nothing|never|nor)\b[^,:;]*) (?:be )?(?:shown|seen|told|known|found)\b|\bopen\b",
    re.IGNORECASE,
)
DEGREE = "(?:more|less|fewer|worse|better|(?:farth|fast|slow|long|short|larg|small|high|low|clos|deep)er)"
WITH_NUMBER = re.compile(
    rf"\b(?:no |not )?{DEGREE} (?:in|than) (?:(?:the|an?|factor|of) )*{NUMBER}|{NUMBER}(?: times)?(?: as)? {DEGREE}\b",
    re.IGNORECASE,
)
"""A comparison that its numbers make."""
COMPARED = re.compile(
    rf"\b(?:no|not|none|never|neither|nor|only)\b|\b{DEGREE}(?= than\b|\s*(?:[,(]|$| (?:in|with|by)\b))", re.IGNORECASE
)


def overstated(templates: Path) -> list[str]:
    """Say which claims of a folder of templates say more than that they are not shown, a line each."""
    return [
        f"{path.relative_to(templates.parent)}: claim {name}: {{% fails %}} asserts “{words}”, and all that is known "
        "there is that the claim is not shown: say so, name a number instead, or move it to {% opposite %}"
        for path in sorted(templates.rglob("*.md.j2"))
        for name, parts in CLAIM.findall(path.read_text(encoding="utf-8"))
        for fails in FAILS.findall(parts)
        for words in _assertions(fails)
    ]


def _assertions(fails: str) -> Iterator[str]:
    """Yield what stands between two stops and neither is a number nor says that something is not shown."""
    text = TAG.sub("", BRANCH.sub(". ", PRINTED.sub(NUMBER, fails)))
    for sentence in SENTENCE.split(" ".join(text.split())):
        if not UNSHOWN.search(sentence):
            for part in filter(None, map(str.strip, STOP.split(sentence))):
                if NUMBER not in part or COMPARED.search(WITH_NUMBER.sub(NUMBER, part)):
                    yield part
