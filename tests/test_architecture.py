"""The rooms: who may read whom, and that the picture of them is the one that the imports make."""

import importlib.util
import re
from graphlib import TopologicalSorter

from measured_report import ROOT

SPEC = importlib.util.spec_from_file_location("rooms", ROOT / "docs" / "rooms.py")
rooms = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(rooms)

SIMULATOR = re.compile(r"^\s*(?:import|from) (warp|newton|mujoco|mujoco_warp)\b", re.MULTILINE)
WORDING = re.compile(r"\b(holds|fails|unknown|explanation|caption|alt)=f?[\"']|\bcannot be told\b")


def test_records_know_neither_the_page_nor_the_experiments():
    assert [pair for pair in rooms.arrows() if pair[0] == "report.records"] == []


def test_experiments_read_records_alone():
    found = {named for module, names in rooms.imports().items() if module.startswith("experiments") for named in names}
    outside = {name for name in found if not name.startswith(("experiments", "report.records")) and name != "report"}
    assert outside == {"experiments.facts.fix_files"}, "the files of the fix, which are offered and measured"


def test_the_page_s_side_reads_two_modules_of_the_experiments():
    page = {module: found for module, found in rooms.imports().items() if not module.startswith("experiments")}
    found = {named for names in page.values() for named in names if named.startswith("experiments.")}
    assert found == {"experiments.facts.case", "experiments.facts.classes"}, "what a case is, and how a run ends"


def test_no_import_leads_in_a_circle():
    names = rooms.imports()
    # A package is there before the modules in it, so that what they take from it is no circle.
    inner = {module: {name for name in found if not module.startswith(f"{name}.")} for module, found in names.items()}
    assert len(list(TopologicalSorter(inner).static_order())) == len(names)


def test_the_page_s_side_never_imports_the_simulator():
    imports, modules = rooms.imports(), rooms.modules()
    reached = {name for name in modules if not name.startswith("experiments")}
    while more := {named for name in reached for named in imports[name]} - reached:
        reached |= more
    files = [modules[name] for name in reached]
    assert [path for path in files if SIMULATOR.search(path.read_text(encoding="utf-8"))] == []


def test_words_are_in_templates():
    files = [path for folder in ("sections", "deriving") for path in sorted((ROOT / "report" / folder).rglob("*.py"))]
    texts = {path.name: path.read_text(encoding="utf-8") for path in files}
    assert [(name, match[0]) for name, text in texts.items() for match in WORDING.finditer(text)] == []


def test_the_picture_is_the_one_that_the_imports_make():
    text = rooms.ARCHITECTURE.read_text(encoding="utf-8")
    assert text.partition(rooms.START)[2].partition(rooms.END)[0] == rooms.picture(), "python docs/rooms.py renews it"
