"""Which kernels a frame launches, whose they are, how long each takes, and what a frame takes without some of them."""

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from unittest import mock

import warp as wp

from experiments.facts.case import FIXED
from experiments.simulation.comparing import Frames, Pilot
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.resolving import in_turn
from experiments.simulation.simulation import Simulation
from experiments.simulation.switches import SWITCHES
from measured_report.measuring.batch import Batch, Plan

WORLD_COUNTS = {"cuda": (1, 16384), "cpu": (1,)}
WITHOUT = {"sensors": {"sensors": False}, "limits": {"limits": False}}
"""Stages of the engine that can be left out, by the parameters that do it."""
CAP_S = 2.0
"""Seconds that a comparison takes at most, about."""
MANGLED = re.compile(r"_[0-9a-f]{8}$")
"""What Warp appends to a kernel's name."""
OWNERS = {"mujoco_warp": "engine", "newton": "newton", "experiments": "scene"}
"""Whose a kernel is, by the package that its module is in."""


def measure(conditions: Conditions) -> Plan:
    counts = WORLD_COUNTS["cuda" if conditions.is_cuda else "cpu"]
    found = yield [Batch(f"worlds-{count}", measure_worlds, (conditions, count), exclusive=True) for count in counts]
    return Measurement([row for rows in found for row in rows])


def measure_worlds(conditions: Conditions, world_count: int) -> list[dict[str, object]]:
    """A row for each kernel, and one for each thing left out."""
    pilot = Pilot([FIXED], wp.get_device(conditions.device))
    simulation = Simulation([replace(FIXED, frame_count=1)] * world_count, pilot.device)
    whole = Frames(simulation, FIXED, pilot)
    frames = {"whole": whole} | {name: Frames(simulation, FIXED, pilot, switch) for name, switch in SWITCHES.items()}
    frames |= {name: Frames(simulation, replace(FIXED, name=name, **change), pilot) for name, change in WITHOUT.items()}
    results = in_turn(list(frames.values()), cap_s=CAP_S * len(frames))
    simulation.vary(FIXED)
    pilot.put(simulation, FIXED)
    kernels = kernel_rows(simulation, world_count)
    rows: list[dict[str, object]] = []
    for (name, each), found in zip(frames.items(), results, strict=True):
        row = {
            "case": f"without-{name}-{world_count}" if each is not whole else f"whole-{world_count}",
            "without": name,
        }
        rows.append(row | {"worlds": world_count} | each.columns(found))
    return rows + kernels


def kernel_rows(simulation: Simulation, world_count: int) -> list[dict[str, object]]:
    """A row for each kernel of one frame that is launched kernel by kernel: whose, how often, and how long in all.

    Loops run as often as the solver iterates, as in the graph. Copies and fills are no kernels of anybody here: Warp
    calls them memory operations, and they have a row together.
    """
    launched: Counter[str] = Counter()
    modules: dict[str, str] = {}

    def counted(launch: Callable) -> Callable:
        def launch_and_count(kernel, *arguments, **options):
            key = getattr(kernel, "key", str(kernel))
            launched[key] += 1
            modules[key] = kernel.func.__module__
            return launch(kernel, *arguments, **options)

        return launch_and_count

    is_cuda = simulation.device.is_cuda
    with (
        wp.ScopedDevice(simulation.device),
        wp.ScopedStream(simulation.stream),
        mock.patch.object(wp, "launch", counted(wp.launch)),
        mock.patch.object(wp, "launch_tiled", counted(wp.launch_tiled)),
    ):
        wp.synchronize_device(simulation.device)
        if is_cuda:
            wp.timing_begin(wp.TIMING_ALL)
        simulation.frame()  # not captured since vary
        activities = wp.timing_end() if is_cuda else []
    milliseconds: Counter[str] = Counter()
    counts: Counter[str] = Counter()
    for activity in activities:
        name = MANGLED.sub("", activity.name.removeprefix("forward kernel "))
        name = name if name in launched else "memory operations"
        milliseconds[name] += activity.elapsed
        counts[name] += 1
    total = sum(milliseconds.values())
    rows = []
    for number, name in enumerate(sorted(launched | counts, key=lambda name: -milliseconds[name]), start=1):
        owner = OWNERS.get(modules.get(name, "").split(".")[0], "warp")
        row = {"case": f"kernel-{world_count}-{number}", "kernel": name, "owner": owner, "worlds": world_count}
        row |= {"launch_count": counts[name] if is_cuda else launched[name]}
        reason = "kernels are timed on CUDA devices only"
        times = {"kernels_ms": milliseconds[name], "time_share": milliseconds[name] / total} if total else {}
        rows.append(row | (times or absent(("kernels_ms", "time_share"), reason)))
    return rows
