"""Stepping through Newton's ``SolverMuJoCo``, as MuJoCo Warp and MuJoCo's C engine have it in common."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

import mujoco
import newton
import numpy as np
from newton.solvers import SolverMuJoCo

from experiments.facts.case import Case
from experiments.facts.trace import ContactRows
from experiments.simulation.recorder import Recorder
from experiments.simulation.stepper import CONTACT_MAX, Stepper
from newton_lint.newton_models.compat import make_solver

CONSTRAINT_MAX = 96  # rows per world when a case asks for none: see ``stepper.CONTACT_MAX``
DISABLED_BY = {
    "refsafe": mujoco.mjtDisableBit.mjDSBL_REFSAFE,
    "sensors": mujoco.mjtDisableBit.mjDSBL_SENSOR,
    "limits": mujoco.mjtDisableBit.mjDSBL_LIMIT,
}
"""Flag that switches a stage of the engine off, by the field of a case that says whether it runs."""
CONTACT_FIELDS = ("dist", "friction", "frame", "solref", "solreffriction", "solimp", "dim", "geom")
"""Arrays of an engine's contacts that are copied to the host."""
Fields = Mapping[str, np.ndarray]


class MuJoCoStepper(Stepper):
    """Steps a batch through Newton's ``SolverMuJoCo``."""

    def vary(self, case: Case) -> None:
        super().vary(case)
        self.solver.update_data_interval = self.sync_interval
        for option in _options(self.solver):
            for name, flag in DISABLED_BY.items():
                others = option.disableflags & ~int(flag)
                option.disableflags = others if getattr(case, name) else others | int(flag)

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        # Without a control the engine keeps the targets that it has.
        control = control if substep == 0 or self.case.state_sync else None
        self.solver.step(self.state, self.state, control, self.contacts, step_s)

    @property
    def sync_interval(self) -> int:
        """Return after how many substeps Newton's state is written into the engine; 0 is never."""
        return int(self.case.state_sync)

    def _make_solver(self, **options) -> SolverMuJoCo:
        """Return a solver with the options of the case and these."""
        case = self.case
        solver = make_solver(
            self.model,
            friction_timeconst_s=case.friction_timeconst_override_s,
            solver=case.solver,
            integrator=case.integrator,
            iterations=case.iterations,
            ls_iterations=case.ls_iterations,
            tolerance=case.tolerance,
            ls_tolerance=case.ls_tolerance,
            cone=case.cone,
            impratio=case.impratio,
            nconmax=case.contact_max or CONTACT_MAX,
            njmax=case.constraint_max or CONSTRAINT_MAX,
            use_mujoco_contacts=self.pipeline is None,
            update_data_interval=self.sync_interval,
            **options,
        )
        if case.noslip_iterations:
            for option in _options(solver):
                option.noslip_iterations = case.noslip_iterations
        return solver


def _options(solver: SolverMuJoCo) -> tuple:
    return (solver.mj_model.opt, getattr(solver, "mjw_model", solver.mj_model).opt)


class MuJoCoRecorder(Recorder):
    """Records which bodies the engine's contacts are between, and their constraint rows."""

    def __init__(self, stepper: Stepper, frame_count: int):
        super().__init__(stepper.scene, stepper.solver, stepper.contacts, stepper.world_count, frame_count)
        self.model = stepper.model
        engine = stepper.solver.mj_model
        self.is_elliptic = int(engine.opt.cone) == int(mujoco.mjtCone.mjCONE_ELLIPTIC)
        bodies = [engine.body(body).name for body in engine.geom_bodyid]
        [self.cube_geom] = [geom for geom, body in enumerate(bodies) if body.endswith("cube")]

    @cached_property
    def geom_names(self) -> list[str]:
        """Return the name of each geom's body; those of the fingers, which have several, are numbered."""
        names: list[str] = []
        shape_body = self.model.shape_body.numpy()
        for shape in self.solver.mjc_geom_to_newton_shape.numpy()[0]:
            body = shape_body[shape] if shape >= 0 else -1
            name = self.model.body_label[body].rsplit("/", 1)[-1] if body >= 0 else "ground"
            if "finger" in name:
                name += f" {1 + sum(other.startswith(name) for other in names)}"
            names.append(name)
        return names

    def keep_contact_rows(self, frame: int) -> None:
        self.contact_rows.append(self.rows_by_world(frame))

    def rows_by_world(self, frame: int) -> list[ContactRows]:
        """Copy every live contact of every world to the host."""
        return [self.rows_of(frame, *contacts) for contacts in self.contacts_by_world()]

    def contacts_by_world(self) -> Iterator[tuple[Fields, np.ndarray, Sequence[np.ndarray]]]:
        """Yield what ``rows_of`` takes of each world."""
        raise NotImplementedError

    def rows_of(self, frame: int, fields: Fields, address: np.ndarray, efc: Sequence[np.ndarray]) -> ContactRows:
        """Take the constraint rows of one world's contacts apart.

        Args:
            fields: CONTACT_FIELDS of the contacts by name, a row for each contact.
            address: First constraint row of each contact; negative for one that is not in the solver.
            efc: Force, position, velocity and reference acceleration of all of the world's constraint rows.
        """
        all_force, all_residual, all_velocity, all_reference = efc
        friction = fields["friction"][:, 0]
        force = np.zeros((len(address), 3))
        residual = np.full((len(address), 3), np.nan)
        velocity = residual.copy()
        reference = residual.copy()
        for i, row in enumerate(address):
            if row < 0:
                continue
            residual[i] = all_residual[row : row + 3]
            velocity[i] = all_velocity[row : row + 3]
            if self.is_elliptic:
                force[i] = all_force[row : row + 3]
                reference[i] = all_reference[row : row + 3]
            else:  # the edges of the pyramid, as in ``stepper_warp.row_force``
                a, b, c, d = all_force[row : row + 4]
                force[i] = a + b + c + d, friction[i] * (a - b), friction[i] * (c - d)
                a, b, c, d = all_velocity[row : row + 4]
                velocity[i, 1:] = (a - b) / (2.0 * friction[i]), (c - d) / (2.0 * friction[i])
        axes = fields["frame"].reshape(-1, 3, 3)
        sign = np.where([self.geom_names[second] == "cube" for _, second in fields["geom"]], 1.0, -1.0)
        return ContactRows(
            frame=frame,
            geom=np.array([[self.geom_names[geom] for geom in pair] for pair in fields["geom"]]).reshape(-1, 2),
            distance_m=fields["dist"],
            friction=friction,
            **{name: fields[name] for name in ("solref", "solreffriction", "solimp", "dim")},
            force_n=force,
            residual_m=residual,
            velocity_m_s=velocity,
            reference_m_s2=reference,
            slide_m_s=sign * (axes[:, 1:, 0] * velocity[:, 1:]).sum(axis=1),
        )
