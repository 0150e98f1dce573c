"""Test that the freshness of this report does not depend on the version of Python."""

import subprocess
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.records.code import GENERATOR, Code
from measured_report.records.identity import identity_of, sections


def test_the_generator_never_counts():
    code = Code(ROOT)
    found = {
        name
        for section in sections()
        for name in identity_of(section, "full", ROOT, {}, code).files
    }
    assert "experiments/simulation/simulation.py" in found
    assert not [name for name in found if name.startswith("measured_report/")]


def test_every_python_agrees_on_the_identity():
    versions = Path.home() / ".pyenv/versions"
    pythons = [
        path for minor in (10, 13) for path in versions.glob(f"3.{minor}.*/bin/python")
    ]
    if not pythons:
        pytest.skip("there is no other Python here")
    code = (
        "import sys; sys.path.append('packages/measured-report');"
        "from measured_report.records.code import GENERATOR, Code; from pathlib import Path;"
        "code = Code(Path.cwd());"
        "starts = [code.module(f'experiments.{name}') for name in sys.argv[1:]];"
        "print([[code.source(file).digest for file in code.closure(start, GENERATOR)] for start in starts])"
    )
    code_here = Code(ROOT)
    starts = [code_here.module(f"experiments.{name}") for name in sections()]
    files = [code_here.closure(start, GENERATOR) for start in starts]
    expected = str(
        [[code_here.source(file).digest for file in of_one] for of_one in files]
    )
    for python in pythons:
        done = subprocess.run(
            [python, "-c", code, *sections()],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=True,
        )
        assert done.stdout.strip() == expected
