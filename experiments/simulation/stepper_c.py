"""Step cases in MuJoCo's C engine instead of MuJoCo Warp if they request it.

This is the only file that uses both engines. The C engine has one world, runs on the
CPU, and detects its contacts itself.
"""

from collections.abc import Sequence

import mujoco
import numpy as np
from newton import CollisionPipeline, Contacts
from newton.solvers import SolverMuJoCo

import contact_bias
import contact_bias_c
from experiments.facts.case import Case, CaseError, batch_key
from experiments.facts.trace import ContactRows
from experiments.simulation import compensated_positions
from experiments.simulation.c_warnings import failure_of
from experiments.simulation.compat import make_solver, warp_has_noslip
from experiments.simulation.stepper import CONTACT_MAX
from experiments.simulation.stepper_warp import WarpRecorder, WarpStepper, is_elliptic

# Default number of rows per world; see ``stepper.CONTACT_MAX``.
CONSTRAINT_MAX = 96

FIELDS = "dist friction frame solref solreffriction solimp dim geom".split()
"""Arrays of contacts that are copied from an engine to the host."""


def batches(cases: Sequence[Case]) -> list[list[int]]:
    """Return the indices of the cases that are worlds of one simulation.

    Cases of MuJoCo's C engine have one simulation each.
    """
    groups: dict[object, list[int]] = {}
    for index, case in enumerate(cases):
        groups.setdefault(
            index if case.backend == "mujoco" else batch_key(case), []
        ).append(index)
    return list(groups.values())


def device_of(case: Case, device: str | None) -> str | None:
    return "cpu" if case.backend == "mujoco" else case.device or device


def is_in_c(case: Case) -> bool:
    """Return whether the case runs in MuJoCo's own loop."""
    return case.backend == "mujoco"


def has_noslip(case: Case) -> bool:
    """Return whether the engine of the case has the noslip pass."""
    return case.backend == "mujoco" or warp_has_noslip()


def update_data_interval(case: Case) -> int:
    """Return the number of steps between writes of the state.

    It is written at every step if MuJoCo's C engine must start in Newton's state.
    """
    return 1 if case.state_sync or case.backend == "mujoco" else 0


class MuJoCoStepper(WarpStepper):
    """Step a batch in MuJoCo Warp or in MuJoCo's C engine."""

    @property
    def is_queued(self) -> bool:
        return not self.solver.use_mujoco_cpu

    def _build_collision(self) -> tuple[CollisionPipeline | None, Contacts | None]:
        if self.case.contacts == "mujoco" or self.case.backend == "mujoco":
            return None, None
        return super()._build_collision()

    def _build_solver(self) -> SolverMuJoCo:
        case = self.case
        if case.noslip_iterations and case.backend == "warp" and not warp_has_noslip():
            raise CaseError(
                "noslip_iterations must be 0 here: MuJoCo Warp of this release has no noslip"
            )
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
            use_mujoco_cpu=case.backend == "mujoco",
            update_data_interval=update_data_interval(case),
        )
        if case.noslip_iterations:
            for option in _options(solver):
                option.noslip_iterations = case.noslip_iterations
        self._install_remedies(solver)
        if not solver.update_data_interval:
            solver.reset(self.state)  # otherwise all worlds would start like the first
        return solver

    def _install_remedies(self, solver: SolverMuJoCo) -> None:
        """Install the remedies of each case in its world.

        Remedies that no case uses are not installed.
        """
        if any(case.compensated for case in self.cases):
            if solver.use_mujoco_cpu:
                raise CaseError(
                    "compensated must be off with backend mujoco, which sums positions in double precision"
                )
            compensated_positions.install(
                solver, worlds=[case.compensated for case in self.cases]
            )
        kinds = [
            case.contact_bias and (case.bias_centred, case.bias_normal)
            for case in self.cases
        ]  # type: list
        for kind in sorted(set(kinds) - {False}):
            options = dict(zip(("centred", "normal"), kind, strict=True))
            if solver.use_mujoco_cpu:
                contact_bias_c.install(solver, **options)
            else:
                contact_bias.install(
                    solver, worlds=[each == kind for each in kinds], **options
                )

    def set_flags(self, solver: SolverMuJoCo) -> None:
        bits = mujoco.mjtDisableBit
        stages = {
            "refsafe": bits.mjDSBL_REFSAFE,
            "sensors": bits.mjDSBL_SENSOR,
            "limits": bits.mjDSBL_LIMIT,
        }
        for option in _options(solver):
            for name, bit in stages.items():
                kept = option.disableflags & ~int(bit)
                option.disableflags = kept | (
                    0 if getattr(self.case, name) else int(bit)
                )

    def _build_recorder(self, frame_count: int) -> "MuJoCoRecorder":
        return MuJoCoRecorder(self, frame_count)


def _options(solver: SolverMuJoCo) -> tuple:
    return (solver.mj_model.opt, getattr(solver, "mjw_model", solver.mj_model).opt)


class MuJoCoRecorder(WarpRecorder):
    """Record the contacts of both engines."""

    def watch_substep(self) -> None:
        if self.solver.use_mujoco_cpu:
            self._watch_c_substep()
            return
        super().watch_substep()

    def record_contacts(self) -> None:
        if self.solver.use_mujoco_cpu:
            self._record_c_contacts()
        else:
            super().record_contacts()

    def keep_contact_rows(self, frame: int) -> None:
        """Copy every live contact of every world to the host. This is possible only
        between frames.
        """
        self.contact_rows.append(
            contact_rows(self.solver, len(self.cursor), frame, self.names)
        )

    def _watch_c_substep(self) -> None:
        data = self.solver.mj_data
        for peak, value in (
            (self.peak_constraint, data.nefc),
            (self.peak_iteration, data.solver_niter.max()),
        ):
            peak.numpy()[0] = max(peak.numpy()[0], value)
        self.failure_in_c = self.failure_in_c or failure_of(
            data, int(self.cursor.numpy()[0])
        )

    def _record_c_contacts(self) -> None:
        frame = int(self.cursor.numpy()[0])
        [rows] = contact_rows(self.solver, 1, frame, self.names)
        self.contacts.numpy()[frame, 0] = summarize_contacts(rows)


def summarize_contacts(rows: ContactRows) -> np.ndarray:
    """Return the contact statistics of a frame, shape [len(FRAME_COLUMNS)].

    They are the same as those that ``record_contacts`` computes on the device.
    """
    normal = rows.force_n[:, 0]
    loaded = normal > 0.0
    tangential = np.linalg.norm(rows.force_n[loaded, 1:], axis=1)
    return np.array(
        [
            len(normal),
            loaded.sum(),
            normal[loaded].sum(),
            tangential.sum(),
            (tangential / (rows.friction[loaded] * normal[loaded])).max(initial=0.0),
            (-rows.distance_m[loaded]).max(initial=0.0),
            rows.slide_m_s[loaded].sum(),  # end_frame divides the sum by the count
        ]
    )


def contact_rows(
    solver: SolverMuJoCo, world_count: int, frame: int, names: list[str]
) -> list[ContactRows]:
    """Copy the live contacts of either engine to the host, by world."""
    if solver.use_mujoco_cpu:
        data, count = solver.mj_data, solver.mj_data.ncon
        host = {name: np.array(getattr(data.contact, name)) for name in FIELDS}
        address, world_id = (
            np.asarray(data.contact.efc_address).reshape(count),
            np.zeros(count, dtype=int),
        )
        efc = [
            np.array(rows)[None]
            for rows in (data.efc_force, data.efc_pos, data.efc_vel, data.efc_aref)
        ]
    else:
        data = solver.mjw_data
        count = min(int(data.nacon.numpy()[0]), data.naconmax)
        host = {
            name: np.array(getattr(data.contact, name).numpy()[:count])
            for name in FIELDS
        }
        address, world_id = (
            data.contact.efc_address.numpy()[:count, 0],
            data.contact.worldid.numpy()[:count],
        )
        efc = [
            rows.numpy()
            for rows in (data.efc.force, data.efc.pos, data.efc.vel, data.efc.aref)
        ]
    rows_by_world = []
    for world in range(world_count):
        mine = world_id == world
        fields, rows = (
            {name: values[mine] for name, values in host.items()},
            [array[world] for array in efc],
        )
        rows_by_world.append(
            _rows_of_world(
                fields, address[mine], rows, frame, names, is_elliptic(solver)
            )
        )
    return rows_by_world


def _rows_of_world(
    field, address, efc, frame: int, names: list[str], elliptic: bool
) -> ContactRows:
    """Return the constraint rows of one world's contacts."""
    all_force, all_residual, all_velocity, all_reference = efc
    axes, friction = field["frame"].reshape(-1, 3, 3), field["friction"][:, 0]
    force, residual, velocity, reference = (
        np.zeros((len(address), 3)),
        *np.full((3, len(address), 3), np.nan),
    )  # type: np.ndarray, np.ndarray, np.ndarray, np.ndarray  # type: ignore[misc]  # NumPy is not read
    for i, row in enumerate(address):
        if row < 0:
            continue
        residual[i], velocity[i] = (
            all_residual[row : row + 3],
            all_velocity[row : row + 3],
        )
        if elliptic:
            force[i], reference[i] = (
                all_force[row : row + 3],
                all_reference[row : row + 3],
            )
        else:
            a, b, c, d = all_force[row : row + 4]
            force[i] = a + b + c + d, friction[i] * (a - b), friction[i] * (c - d)
            a, b, c, d = all_velocity[row : row + 4]
            velocity[i, 1:] = (
                (a - b) / (2.0 * friction[i]),
                (c - d) / (2.0 * friction[i]),
            )
    sign = np.where([names[second] == "cube" for _, second in field["geom"]], 1.0, -1.0)
    return ContactRows(
        frame=frame,
        geom=np.array([[names[g] for g in pair] for pair in field["geom"]]).reshape(
            -1, 2
        ),
        distance_m=field["dist"],
        friction=friction,
        **{name: field[name] for name in ("solref", "solreffriction", "solimp", "dim")},
        force_n=force,
        residual_m=residual,
        velocity_m_s=velocity,
        reference_m_s2=reference,
        slide_m_s=sign * (axes[:, 1:, 0] * velocity[:, 1:]).sum(axis=1),
    )
