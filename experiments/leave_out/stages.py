"""Which stages of the engine a substep runs: kernels launched by each, and for what of the model."""

import sys
from collections import Counter
from collections.abc import Callable
from unittest import mock

import numpy as np
import warp as wp

from experiments.simulation.simulation import Simulation

ELEMENTS = {"sensor": "nsensor", "ten": "ntendon", "flex": "nflex", "eq": "neq", "limit": "njnt"}
"""What of the model a stage or a constraint kernel is for, by what its function's name contains."""
CONSTRAINTS = "make_constraint"
"""The function that makes the rows of all kinds of constraints: here each kernel is a stage."""


def stage_rows(simulation: Simulation, kind: str) -> list[dict[str, object]]:
    """A row for each stage: kernels per substep, their share of all of a substep, and what they are for.

    A stage is a function of the engine or of Newton's solver. A launch over no elements is no kernel, and not counted.
    One substep is run, kernel by kernel. Its solver's iterations depend on the state; one world's kernels take about as
    long each, so that the share of the kernels is about that of the time.
    """
    launches = count_launches(simulation)
    total = sum(launches.values())
    model = simulation.solver.mj_model
    rows = []
    for stage, count in sorted(launches.items()):
        field = element_of(stage)
        row = {"case": f"stage-{kind}-{stage}", "stage": stage, "stage_device": kind, "kernel_count": count}
        row |= {"kernel_share": count / total, "of": field, "element_count": field and int(getattr(model, field))}
        rows.append(row if field else row | {"element_count_reason": "the stage is for no one kind of element"})
    return rows


def element_of(stage: str) -> str | None:
    """What of the model a stage is for; None where that is no one kind of element. Its module says nothing of it."""
    function = stage.rpartition(".")[2]
    return next((field for name, field in ELEMENTS.items() if name in function), None)


def count_launches(simulation: Simulation) -> Counter:
    """Kernels that one substep launches, by stage."""
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
