"""Where Newton's releases differ, for what is measured here. All else runs on 1.4.0 to 1.8.0 as it is."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields
from unittest import mock

import mujoco_warp
import newton
import warp as wp
from newton.solvers import SolverMuJoCo


def warp_has_noslip() -> bool:
    """Tell whether MuJoCo Warp of the installed release has the noslip pass; C has it in all."""
    return any(
        field.name == "noslip_iterations" for field in fields(mujoco_warp.Option)
    )


def make_solver(
    model: newton.Model, *, friction_timeconst_s: float | None = None, **options
) -> SolverMuJoCo:
    """Return a silent ``SolverMuJoCo``; a timeconst [s] is of all friction rows, 0 leaves them that of their solref."""
    with _buffers_on_the_device():
        if friction_timeconst_s is None:
            solver = SolverMuJoCo(model, **options)
        else:
            solver = _FrictionRowSolver(model, friction_timeconst_s, **options)
    if not solver.use_mujoco_cpu:
        # Kernels print a line at each overflow and, from 1.6.0 on, at each solve that uses up its iterations. The
        # recorder keeps all that, and in a large batch the printing costs more than the physics.
        solver.mjw_model.opt.warn_overflow = False
    return solver


@contextmanager
def _buffers_on_the_device() -> Iterator[None]:
    """Return within it ``mujoco_warp.put_data`` allocates room for contacts and constraint rows on the device.

    By itself it makes arrays of zeros on the host and copies them: with the buffers as shipped that is 2 MB a world,
    and a minute for 16,384 of them. Each step fills them anew, all but the contacts' type, which Newton leaves alone.
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
        roomy.contact.type.fill_(1)  # a constraint, as put_data says of all
        return roomy

    with mock.patch.object(mujoco_warp, "put_data", put_and_enlarge):
        yield


class _FrictionRowSolver(SolverMuJoCo):
    """A solver that writes one solreffriction into all of Newton's contacts."""

    def __init__(self, model: newton.Model, friction_timeconst_s: float, **options):
        self.solreffriction = wp.vec2(
            friction_timeconst_s, 1.0 if friction_timeconst_s else 0.0
        )
        super().__init__(model, **options)

    def _convert_contacts_to_mjwarp(self, *arguments) -> None:
        super()._convert_contacts_to_mjwarp(*arguments)
        self.mjw_data.contact.solreffriction.fill_(self.solreffriction)
