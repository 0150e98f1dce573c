"""Tests the lint on the corpus: no fault is lost, and each cure holds in MuJoCo."""

import json

import pytest
from toys import IS_WEEKLY

from newton_lint.fix import edited
from newton_lint.source import Source
from newton_lint.target import compiled
from tests.newton_lint import truth

SCENES = truth.scenes()
MEASURED = json.loads((truth.CORPUS / "truth.json").read_text(encoding="utf-8"))
CHANGING_NOTHING = ("timeconst",)
"""Rules whose remedy writes down the value that is used."""


@pytest.fixture(scope="module")
def found():
    return truth.findings()


@pytest.mark.parametrize("name", SCENES)
def test_each_fault_is_found_and_healthy_scenes_are_clean(name, found):
    rules = {finding.rule for finding in found[name]}
    rule = SCENES[name]["rule"]
    assert rule in rules if rule else not rules


@pytest.mark.parametrize("name", list(SCENES)[:: 1 if IS_WEEKLY else 4])
def test_the_measurements_are_current_and_each_remedy_works(name):
    """Test only MuJoCo and the corpus, which change rarely; the suite tests a sample."""
    facts = SCENES[name]
    before = truth.measured(name, facts, mended=False)
    assert before == pytest.approx(MEASURED[name]["measured"], rel=0.1, abs=1e-3)
    if "remedy" in facts and facts["rule"] not in CHANGING_NOTHING:
        assert truth.measured(name, facts, mended=True) < 0.5 * before


@pytest.mark.parametrize("name", [name for name in SCENES if SCENES[name]["rule"]])
def test_the_first_cure_mends_the_scene_as_it_is_written(name, found):
    """The file with the changes is measured in plain MuJoCo, without the lint."""
    facts = SCENES[name]
    path = truth.CORPUS / f"{name}.xml"
    finding = next(item for item in found[name] if item.rule == facts["rule"])
    if not finding.cures:
        assert finding.hint
        return
    source = Source.of(path, compiled(path))
    texts = edited(finding.cures[0].changes, source, {})
    kind, *arguments = facts["quantity"].split()
    motion = truth.Motion(texts[path].decode())
    after = truth.QUANTITIES[kind](motion, *arguments)
    share = 1.001 if facts["rule"] in CHANGING_NOTHING else 0.6
    assert after < share * MEASURED[name]["measured"]


def test_the_table_is_current(found):
    text = truth.DOCUMENT.read_text(encoding="utf-8")
    assert truth.BEGIN + truth.table(found) + truth.END in text
