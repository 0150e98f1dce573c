"""Test that the templates cite existing things, and word failed claims correctly."""

import re
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.parts.citations import references

pytestmark = pytest.mark.words


def test_what_is_stated_is_still_in_the_package():
    for name, reference in references(ROOT / "templates").items():
        package = reference["package"]
        if package and version(package) == reference["version"]:
            file = Path(find_spec(package).origin).parent / reference["file"]
            lines = file.read_text(encoding="utf-8").splitlines()
            assert reference["excerpt"] in lines[reference["line"] - 1], name


FAILING = re.compile(
    r"\{% claim (\w+) %\}(?:(?!\{% endclaim).)*?\{% fails %\}(.*?)\{% (?!el|if|endif|for|endfor|set)",
    re.DOTALL,
)
SENTENCE, STOP = re.compile(r"[.;?!](?:\s|$)|\{% el.*?%\}"), re.compile(r":\s")
UNSHOWN = re.compile(
    r"\b(?:cannot|(?:not?|none|nothing|never|nor)\b[^,:;]*) (?:be )?(?:shown|seen|told|known|found)\b|\bopen\b",
    re.IGNORECASE,
)


def overstated(templates: Path) -> list[tuple[str, str]]:
    """List claims whose ``{% fails %}`` has a sentence without a number and without the
    words "not shown". A claim fails if it is not shown, and also if its opposite is
    shown, for which there is ``{% opposite %}``.
    """
    found = []
    for path in sorted(templates.rglob("*.md.j2")):
        for name, fails in FAILING.findall(path.read_text(encoding="utf-8")):
            for sentence in SENTENCE.split(
                re.sub(r"\{\{.*?\}\}", "#", " ".join(fails.split()))
            ):
                parts = (
                    re.sub(r"\{%.*?%\}|<[^>]*>", "", part).strip()
                    for part in STOP.split(sentence)
                )
                if not UNSHOWN.search(sentence):
                    found += [
                        (f"{path.name}: {name}", part)
                        for part in parts
                        if part and "#" not in part
                    ]
    return found


@pytest.mark.parametrize(
    "folder", ["templates", "examples/benchmark-upgrade/templates"]
)
def test_what_only_is_not_shown_is_not_said_to_be_otherwise(tmp_path, folder):
    assert overstated(ROOT / folder) == []
    fails = "It slips {{ slip }}. The solver matters: {{ slip }}. It is not shown that it sticks."
    (tmp_path / "toy.md.j2").write_text(
        f"{{% claim slips %}} {{% fails %}} {fails}\n{{% asks %}} x\n{{% endclaim %}}"
    )
    assert overstated(tmp_path) == [("toy.md.j2: slips", "The solver matters")]
