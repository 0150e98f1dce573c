"""Stages of the engine in a substep: kernels launched by each, and the part of the model that each is for."""

import sys
from collections import Counter
from collections.abc import Callable
from unittest import mock

import numpy as np
import warp as wp

from experiments.simulation.simulation import Simulation

ELEMENTS = {"sensor": "nsensor", "ten": "ntendon", "flex": "nflex", "eq": "neq", "limit": "njnt"}
"""Elements of the model that a stage or a constraint kernel is for, by a part of its function's name."""
CONSTRAINTS = "make_constraint"
"""Function that makes the rows of all kinds of constraints: here each kernel is a stage."""


def stage_rows(simulation: Simulation, kind: str) -> list[dict[str, object]]:
    """Return a row for each stage: kernels per substep, their share of all of a substep, and the elements they are for.

    A stage is a function of the engine or of Newton's solver. A launch over no elements is no kernel, and not counted.
    One substep is run, kernel by kernel. Its solver's iterations depend on the state; one world's kernels take about as
    long each, so that the share of the kernels is about that of the time.
    """
    launches, model = count_launches(simulation), simulation.solver.mj_model
    rows = []
    for stage, count in sorted(launches.items()):
        field = element_of(stage)
        row = {"case": f"stage-{kind}-{stage}", "stage": stage, "stage_device": kind, "kernel_count": count}
        row |= {"kernel_share": count / launches.total(), "of": field}
        row |= {"element_count": field and int(getattr(model, field))}
        rows.append(row if field else row | {"element_count_reason": "the stage is for no one kind of element"})
    return rows


def element_of(stage: str) -> str | None:
    """Return the elements a stage is for; None where that is no one kind. Its module says nothing of it."""
    function = stage.rpartition(".")[2]
    return next((field for name, field in ELEMENTS.items() if name in function), None)


def count_launches(simulation: Simulation) -> Counter:
    """Count the kernels that one substep launches, by stage."""
    found: Counter = Counter()

    def counted(launch: Callable) -> Callable:
        def launch_and_count(kernel, dim, *arguments, **options):
            caller = sys._getframe(1)
            if np.prod(dim) > 0:
                name = caller.f_code.co_name
                name = kernel.key.split("__")[0] if name == CONSTRAINTS else name
                found[f"{caller.f_globals['__name__'].rsplit('.', 1)[-1]}.{name}".replace("._", ".")] += 1
            return launch(kernel, dim, *arguments, **options) if arguments else launch(kernel, dim=dim, **options)

        return launch_and_count

    with (
        wp.ScopedDevice(simulation.device),
        wp.ScopedStream(simulation.stream),
        mock.patch.object(wp, "launch", counted(wp.launch)),
        mock.patch.object(wp, "launch_tiled", counted(wp.launch_tiled)),
    ):
        simulation.solver.step(simulation.state, simulation.state, None, simulation.contacts, simulation.substep_dt)
    wp.synchronize_device(simulation.device)
    return found
