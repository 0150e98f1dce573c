"""Handle the differences between Newton's releases that concern this package.

The rest of the code runs on 1.4.0 to 1.8.0 without changes.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields
from unittest import mock

import mujoco_warp
import newton
import warp as wp
from newton.solvers import SolverMuJoCo


def warp_has_noslip() -> bool:
    """Return whether the installed MuJoCo Warp has the noslip pass. All C engines have
    it.
    """
    return any(
        field.name == "noslip_iterations" for field in fields(mujoco_warp.Option)
    )


def make_solver(
    model: newton.Model, *, friction_timeconst_s: float | None = None, **options
) -> SolverMuJoCo:
    """Return a ``SolverMuJoCo`` that does not print.

    A friction timeconst [s] applies to all friction rows. With 0, they keep the
    timeconst of their solref.
    """
    with _buffers_on_the_device():
        if friction_timeconst_s is None:
            solver = SolverMuJoCo(model, **options)
        else:
            solver = _FrictionRowSolver(model, friction_timeconst_s, **options)
    if not solver.use_mujoco_cpu:
        # Kernels print a line at each overflow and, from 1.6.0 on, at each solve that
        # uses all its iterations. The recorder stores this information. In a large
        # batch, printing costs more than the physics.
        solver.mjw_model.opt.warn_overflow = False
    return solver


@contextmanager
def _buffers_on_the_device() -> Iterator[None]:
    """Make ``mujoco_warp.put_data`` allocate contacts and rows on the device.

    By default it creates arrays of zeros on the host and copies them. With the default
    buffers these are 2 MB per world, which takes a minute for 16,384 worlds. Each step
    overwrites the arrays, except for the type of contacts, which Newton does not write.
    """
    put_data = mujoco_warp.put_data

    def put_and_enlarge(
        model, data, *, nworld: int, nconmax: int, njmax: int, **options
    ):
        filled = put_data(
            model,
            data,
            nworld=nworld,
            nconmax=max(1, data.ncon),
            njmax=max(1, data.nefc),
            **options,
        )
        roomy = mujoco_warp.make_data(
            model, nworld=nworld, nconmax=nconmax, njmax=njmax, **options
        )
        for name, array in vars(filled).items():
            if (
                isinstance(array, wp.array)
                and array.shape == getattr(roomy, name).shape
            ):
                setattr(roomy, name, array)
        roomy.contact.type.fill_(1)  # marks a constraint, as put_data does for all
        return roomy

    with mock.patch.object(mujoco_warp, "put_data", put_and_enlarge):
        yield


class _FrictionRowSolver(SolverMuJoCo):
    """Write one solreffriction into all of Newton's contacts."""

    def __init__(self, model: newton.Model, friction_timeconst_s: float, **options):
        self.solreffriction = wp.vec2(
            friction_timeconst_s, 1.0 if friction_timeconst_s else 0.0
        )
        super().__init__(model, **options)

    def _convert_contacts_to_mjwarp(self, *arguments) -> None:
        super()._convert_contacts_to_mjwarp(*arguments)
        self.mjw_data.contact.solreffriction.fill_(self.solreffriction)
