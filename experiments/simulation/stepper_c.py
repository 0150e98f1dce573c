"""Stepping MuJoCo's C engine: one world, on the CPU, in double precision. It finds its contacts itself."""

from collections.abc import Iterator, Sequence

import numpy as np
from newton.solvers import SolverMuJoCo

from experiments.facts.case import CaseError
from experiments.facts.trace import ContactRows
from experiments.simulation import contact_bias_c
from experiments.simulation.c_warnings import failure_of
from experiments.simulation.stepper_mujoco import CONTACT_FIELDS, Fields, MuJoCoRecorder, MuJoCoStepper


class CStepper(MuJoCoStepper):
    """Steps one case in MuJoCo's C engine."""

    @property
    def is_queued(self) -> bool:
        return False

    @property
    def sync_interval(self) -> int:
        """Return 1: the engine starts every substep from Newton's state."""
        return 1

    def _build_collision(self) -> tuple[None, None]:
        return None, None

    def _build_solver(self) -> SolverMuJoCo:
        case = self.case
        if case.compensated:
            raise CaseError("compensated must be off with backend mujoco, which sums positions in double precision")
        solver = self._make_solver(use_mujoco_cpu=True)
        if case.contact_bias:
            contact_bias_c.install(solver, centred=case.bias_centred, normal=case.bias_normal)
        return solver

    def _build_recorder(self, frame_count: int) -> "CRecorder":
        return CRecorder(self, frame_count)


class CRecorder(MuJoCoRecorder):
    """Records the contacts of MuJoCo's C engine, and what it warns of."""

    def watch_substep(self) -> None:
        data = self.solver.mj_data
        for peak, value in ((self.peak_constraint, data.nefc), (self.peak_iteration, data.solver_niter.max())):
            peak.numpy()[0] = max(peak.numpy()[0], value)
        self.failure = self.failure or failure_of(data, int(self.cursor.numpy()[0]))

    def record_contacts(self) -> None:
        frame = int(self.cursor.numpy()[0])
        [rows] = self.rows_by_world(frame)
        self.contacts.numpy()[frame, 0] = summarize_contacts(rows)

    def contacts_by_world(self) -> Iterator[tuple[Fields, np.ndarray, Sequence[np.ndarray]]]:
        data = self.solver.mj_data
        fields = {name: np.array(getattr(data.contact, name)) for name in CONTACT_FIELDS}
        address = np.asarray(data.contact.efc_address).reshape(data.ncon)
        yield fields, address, [data.efc_force, data.efc_pos, data.efc_vel, data.efc_aref]


def summarize_contacts(rows: ContactRows) -> np.ndarray:
    """Return what ``stepper_warp.record_contacts`` adds up on the device, shape [len(FRAME_COLUMNS)]."""
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
            rows.slide_m_s[loaded].sum(),  # end_frame turns the sum into the mean
        ]
    )
