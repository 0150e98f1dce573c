"""What makes measuring faster changes nothing that is measured."""

import ctypes
import re
import sys
from contextlib import nullcontext
from dataclasses import replace
from importlib import import_module

import newton
import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED, LEAN, RUN_TIME_FIELDS, CaseError
from experiments.leave_out.stages import count_launches, element_of, stage_rows
from experiments.simulation.kernels import Module, modules_of
from experiments.simulation.simulation import Simulation, batches, run_batch, simulate
from experiments.simulation.timing import in_the_shake, put_in_state_of
from measured_report.files.root import ROOT
from measured_report.measuring.pool import gather, processes, start
from newton_lint.newton_models import compat

FRAME_COUNT = 10
VARIED = {"ik_iterations": 24, "ik_beside": False, "state_sync": True, "sensors": False, "limits": False}


@pytest.fixture(scope="module")
def pilot() -> Simulation:
    return in_the_shake([AS_SHIPPED], wp.get_device("cpu"))


def poses_from(simulation: Simulation, pilot: Simulation) -> np.ndarray:
    """Poses of FRAME_COUNT frames that start in the state of the pilot."""
    put_in_state_of(simulation, pilot)
    simulation.recorder.cursor.zero_()
    for _ in range(FRAME_COUNT):
        simulation.step()
    return simulation.recorder.poses.numpy().copy()


def test_a_varied_simulation_runs_as_one_that_was_built_so(pilot):
    assert VARIED.keys() == set(RUN_TIME_FIELDS)
    base = replace(AS_SHIPPED, frame_count=FRAME_COUNT)
    varied = Simulation([base] * 2, pilot.device)
    first = poses_from(varied, pilot)
    for name, value in VARIED.items():
        case = replace(base, name=name, **{name: value})
        varied.vary(case)
        found = poses_from(varied, pilot)
        assert np.array_equal(found, poses_from(Simulation([case] * 2, pilot.device), pilot)), name
    varied.vary(base)
    assert np.array_equal(poses_from(varied, pilot), first)
    with pytest.raises(CaseError, match="gap takes a simulation of its own"):
        pilot.vary(replace(AS_SHIPPED, name="gap", cube_gap_m=0.01))


def test_stages_that_are_not_used_change_no_bit():
    off = ({}, {"sensors": False}, {"limits": False})
    short = replace(LEAN, cube_in_hand=True, frame_count=100)  # 10 of them in the shake
    cases = [replace(short, name=str(change), **change) for change in off]
    kept, *others = simulate(cases, device="cpu")
    for case, trace in zip(cases[1:], others, strict=True):
        assert np.array_equal(trace.poses, kept.poses), case.name


def test_stages_their_kernels_and_what_they_are_for(pilot):
    kept = count_launches(pilot)
    assert sum(kept.values()) > 80
    pilot.vary(replace(AS_SHIPPED, sensors=False, limits=False))
    off = count_launches(pilot)
    pilot.vary(AS_SHIPPED)
    assert not any("limit" in stage or "sensor_acc" in stage for stage in off)
    assert sum(off.values()) < sum(kept.values())
    rows = stage_rows(pilot, "cpu")
    assert sum(row["kernel_share"] for row in rows) == pytest.approx(1.0)
    assert len({row["case"] for row in rows}) == len(rows)
    assert all(row["element_count"] is not None or row["element_count_reason"] for row in rows)
    found = {row["stage"]: row["of"] for row in rows if row["of"]}
    assert found and all(element_of(stage) == element for stage, element in found.items())
    assert element_of("sensor.sensor_acc") == "nsensor" and element_of("constraint.limit_slide_hinge") == "njnt"
    assert element_of("sensor.energy_pos") is None, "energy is measured in the module of the sensors"
    assert element_of("smooth.camlight") is None, "of cameras and of lights"


def test_buffers_from_the_device_are_those_from_the_host(monkeypatch):
    case = replace(AS_SHIPPED, contact_max=100, constraint_max=200, cube_in_hand=True, frame_count=20)
    [found] = simulate([case], device="cpu")
    monkeypatch.setattr(compat, "_buffers_on_the_device", nullcontext)
    [expected] = simulate([case], device="cpu")
    assert np.array_equal(found.poses, expected.poses)
    assert np.array_equal(found.contacts, expected.contacts, equal_nan=True)
    assert expected.peak_constraint_count > 20


def test_a_run_in_a_process_of_its_own_is_the_run_here():
    cases = [replace(AS_SHIPPED, backend=backend, frame_count=30) for backend in ("mujoco", "warp")]
    groups = [[cases[index] for index in members] for members in batches(cases)]
    with processes(1) as pool:
        away = gather(start(pool, run_batch, [(group, "cpu") for group in groups]), "")
    for [one], other in zip(away, simulate(cases, device="cpu"), strict=True):
        assert np.array_equal(one.poses, other.poses)


def test_all_kernels_of_a_run_are_known_before_it(monkeypatch):
    newton.use_coord_layout_targets = True
    device = wp.get_device("cpu")
    empty = wp.empty

    def full_of_rubbish(*arguments, **options):
        array = empty(*arguments, **options)
        if array.capacity:
            ctypes.memset(array.ptr, 0x7E, array.capacity)
        return array

    with monkeypatch.context() as memory:
        memory.setattr(wp, "empty", full_of_rubbish)
        known = set(modules_of(device, AS_SHIPPED))
    assert len(known) > 20
    needed = set()
    load = Module.load

    def note(module, device, block_dim=None):
        needed.add((module, block_dim))
        return load(module, device, block_dim)

    monkeypatch.setattr(Module, "load", note)
    simulation = Simulation([replace(AS_SHIPPED, frame_count=3)], device)
    for _ in range(3):
        simulation.step()
    assert needed
    scenes = {module.name for module, _ in needed} - {module.name for module, _ in known}
    assert len(scenes) < 5, "only the scene's own kernels are compiled as they are met"


def test_the_audit_is_a_program_where_the_page_says_and_finds_the_shake_scene(monkeypatch, capsys):
    words = (ROOT / "templates/sections/leave_out.md.j2").read_text(encoding="utf-8")
    program = import_module(re.search(r"python -m ([\w.]+)</code>", words)[1])
    monkeypatch.setattr(program, "shake_scene", lambda: "the scene")
    monkeypatch.setattr(program, "audit", lambda scene, frame_count: [program.Item(scene, frame_count, 0)])
    monkeypatch.setattr(sys, "argv", ["audit"])
    assert program.main() == 0
    assert capsys.readouterr().out.split() == ["there", "used", "the", "scene", "300", "0"]
