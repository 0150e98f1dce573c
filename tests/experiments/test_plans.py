"""Test the plans of sections before any batch is measured."""

import inspect
from importlib import import_module

import pytest

from experiments.simulation.measurement import Conditions
from measured_report.records.identity import sections

MODULES = {section: import_module(f"experiments.{section}") for section in sections()}
PLANNED = [
    section
    for section, module in MODULES.items()
    if inspect.isgeneratorfunction(module.measure)
]


@pytest.mark.parametrize("device", ["cpu", "cuda:0"])
@pytest.mark.parametrize("section", PLANNED)
def test_a_section_has_something_to_measure_on_every_device(section, device):
    plan = MODULES[section].measure(Conditions(device=device, quick=True))
    try:
        assert next(plan), "a stage without batches never ends"
    except StopIteration as end:
        # It cannot measure anything on this device, and states the reason.
        assert all("slip_mm_reason" in row for row in end.value.rows)
