"""Test that the reference lists every setting, and every name of the generator that the
document and a new report use.
"""

import re
from dataclasses import fields

import pytest
from current_columns import units

from measured_report.commands.new import SKELETON
from measured_report.commands.reference import reference
from measured_report.files.config import Report
from measured_report.files.root import ROOT
from measured_report.files.settings import Changes, Columns, Config

TEXT = reference(Report(SKELETON / "pendulum"))


@pytest.mark.parametrize("kind", [Config, Changes, Columns])
def test_every_setting_is_told(kind):
    assert not [each.name for each in fields(kind) if f"\n{each.name}: " not in TEXT]


def test_what_a_section_imports_and_every_unit_are_told():
    documents = [
        path for path in [ROOT / "docs/your-own.md"] if path.is_file()
    ]  # next to a checkout of the repository
    sources = [
        path.read_text() for path in [*documents, *SKELETON.rglob("*/sections/*.py")]
    ]
    imported = {
        name.strip()
        for text in sources
        for names in re.findall(r"from measured_report\S+ import (.+)", text)
        for name in names.split(",")
    }
    assert {"Claim", "greater", "new_figure", "Results"} <= imported
    assert not [
        name
        for name in imported
        if f"### {name}\n" not in TEXT and f"- `{name}(" not in TEXT
    ]
    assert not [end for end in units() if f"`_{end}`" not in TEXT]


def test_what_the_docs_and_a_new_report_use_is_told():
    documents = [
        path.read_text()
        for name in ("your-own", "section")
        if (path := ROOT / f"docs/{name}.md").is_file()
    ]
    sources = documents + [
        path.read_text()
        for path in SKELETON.rglob("*")
        if path.suffix in (".py", ".j2")
    ]
    used = {
        name
        for text in sources
        for names in re.findall(r"\bresults\.(\w+)|sections\.\w+\.(\w+)\(", text)
        for name in names
    }
    used |= {
        name
        for text in documents
        for names in re.findall(r"`(\w+)\(\w+[^`]*\)`|^(order|[A-Z_]+) = ", text)
        for name in names
    }
    used |= {"trace", "order", "NEEDS_GPU", "negligible", "value", "claim"}
    assert [
        name
        for name in sorted(used - {"", "measure", "derive"})
        if not re.search(rf"\b{name}[ (.:]", TEXT)
    ] == []
    assert (
        "- `trace(self, case: str)`" in TEXT
        and "\norder: float  # position" in TEXT
        and "NEEDS_GPU = False" in TEXT
    )
