"""Predict the parts of a held cube's slip only from the motion of the arm.

Let u = J q̇ be the velocity of the cube's centre relative to the hand, and g = J̇ q̇
the part of its acceleration that remains for q̈ = 0. A friction row sets J q̈ = -b u
- R f, where R f is its compliance under load (MuJoCo documentation, "Computation"). The
joints do not move with the q̈ of the solver, because implicitfast adds the damping of a
step to the inertia. With e = J (actual q̈ - q̈ of the solver) and steps of length h,
the displacement of the cube over a run is

    x = ∫ g/b dt  -  h/2 ∫ g dt  +  ∫ e/b dt  -  ∫ R f/b dt
        the term      the step      damping       creep under load

along the pads. Across the pads, the normal rows hold the cube. RK4 has neither the
second nor the third part, and Euler does not have the third. R is proportional to 1 /
impratio. Rounding of positions is a fifth part. The values of g, e and R f are measured
in one run in MuJoCo's C engine, with the term restored so that the cube does not slide.
The values of b, h and the factor of R are taken from the predicted case.
"""

from dataclasses import dataclass, replace

import mujoco
import numpy as np
import warp as wp

from contact_bias_c import watch_steps
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation.limits import reference_stiffness, solref, step_s
from experiments.simulation.scene import PAD_SOLIMP, body_index
from experiments.simulation.simulation import Simulation
from newton_lint.law import impedance_at
from newton_lint.newton_models.compat import kf_is_read

BISECTION_COUNT = 50


@dataclass(frozen=True)
class Motion:
    """Sums over the shake of a run in C. All have the shape [3] and are in the TCP
    frame.
    """

    bias_m_s: np.ndarray  # ∫ g dt
    damping_m_s: np.ndarray  # ∫ e dt with implicitfast
    # ∫ R f dt with the default impratio and cone, as a mean over the loaded contacts.
    load_m_s: np.ndarray
    depth_m: float  # final mean depth of these contacts
    # Displacement of the cube minus the integral of its velocity, in single precision.
    rounding_m: np.ndarray
    # Sum of the engine's inverse weights of a finger and the cube [1/kg].
    inverse_mass_1_kg: float
    failure: str | None = None  # reason why the sums are not valid, if there is one


def measure_motion(case: Case) -> Motion:
    """Sum the causes of the cube's motion in a run of a case in MuJoCo's C engine."""
    run = Watched(case)
    if run.failure:
        return Motion(
            *np.full((3, 3), np.nan), np.nan, np.full(3, np.nan), np.nan, run.failure
        )  # type: ignore[call-arg]  # three of an array
    bias, damping, load, velocity = run.frames[run.shaking[1:]].sum(axis=0)
    moved = metrics.displacement(run.trace).vector_m[-1]
    rounding = moved - (velocity - 0.5 * step_s(case) * bias)
    return Motion(bias, damping, load, run.depth_m, rounding, run.inverse_mass_1_kg)


class Watched:
    """Run a case in C with the term restored, and sum the causes of its motion.

    The term is restored so that the sums do not contain any slide of the cube.
    ``frames``, shape [frames, 4, 3], contains the sums of bias, damping, load and
    velocity over the substeps of each frame. ``shaking`` contains the indices of the
    frames of the shake; the displacement is measured from the end of the first of these
    frames. ``failure`` is the reason if the run is not valid.
    """

    def __init__(self, case: Case):
        case = replace(case, backend="mujoco", contact_bias=True, bias_centred=True)
        simulation = Simulation([case], wp.get_device("cpu"))
        self._look_at(simulation)
        watch_steps(simulation.solver, self._step)
        self.frames = np.zeros((case.frame_count, 4, 3))
        for sums in self.frames:
            self.sums = sums
            simulation.step()
        [self.trace] = simulation.recorder.traces()
        self.shaking = np.flatnonzero(self.trace.phase == metrics.SHAKE)
        reason = self.trace.failure or (
            None if len(self.shaking) else "the shake was never reached"
        )
        self.failure = f"in MuJoCo C {reason}" if reason else None

    def _look_at(self, simulation: Simulation) -> None:
        engine = simulation.solver.mj_model
        of_newton = simulation.solver.mjc_body_to_newton.numpy()[0].tolist()
        link = simulation.scene.links["fr3_hand_tcp"]
        self.hand = of_newton.index(link.body)
        self.cube = of_newton.index(body_index(simulation.model, "cube"))
        self.cube_geom = simulation.recorder.cube_geom
        self.axes = np.zeros(9)
        mujoco.mju_quat2Mat(self.axes, np.roll(np.array(link.pose.q, dtype=float), 1))
        self.axes = self.axes.reshape(3, 3)
        finger = of_newton.index(simulation.scene.links["fr3_leftfinger"].body)
        self.inverse_mass_1_kg = float(
            engine.body_invweight0[[finger, self.cube], 0].sum()
        )
        self.depth_m = 0.0
        self.rate = np.zeros((3, engine.nv))
        self.jacobian = np.zeros((2, 3, engine.nv))

    def _step(self, step, engine: mujoco.MjModel, data: mujoco.MjData) -> None:
        before = data.qvel.copy()
        step(engine, data)
        # The kinematics still belong to the beginning of the step.
        centre, h = data.xpos[self.cube].copy(), engine.opt.timestep
        mujoco.mj_jac(engine, data, self.jacobian[0], None, centre, self.hand)
        mujoco.mj_jac(engine, data, self.jacobian[1], None, centre, self.cube)
        mujoco.mj_jacDot(engine, data, self.rate, None, centre, self.hand)
        relative = self.jacobian[1] - self.jacobian[0]
        bias = -self.rate @ before  # it is zero for the centre of a free body
        used = (data.qvel - before) / h
        into_tcp = (data.xmat[self.hand].reshape(3, 3) @ self.axes).T
        terms = (
            bias,
            relative @ (used - data.qacc),
            self._load(data),
            relative @ data.qvel + h * bias,
        )
        for total, value in zip(self.sums, terms, strict=True):
            total += h * (into_tcp @ value)

    def _load(self, data: mujoco.MjData) -> np.ndarray:
        """Return R f of the cube's friction rows [m/s²] and store the depth.

        This is the mean over the contacts that carry force.
        """
        found, depths_m = [], []
        for contact in data.contact:
            row = contact.efc_address
            if (
                row >= 0
                and self.cube_geom in contact.geom
                and data.efc_force[row] > 0.0
            ):
                yielded = (
                    data.efc_R[row + 1 : row + 3] * data.efc_force[row + 1 : row + 3]
                )
                sign = 1.0 if contact.geom[1] == self.cube_geom else -1.0
                found.append(sign * contact.frame.reshape(3, 3)[1:].T @ yielded)
                depths_m.append(contact.includemargin - contact.dist)
        self.depth_m = float(np.mean(depths_m)) if found else 0.0
        return np.mean(found, axis=0) if found else np.zeros(3)


def predicted_mm(case: Case, motion: Motion) -> dict[str, np.ndarray]:
    """Return the predicted parts of a case's slip by name [mm], in the TCP frame.

    They are predicted from the motion of its shake.
    """
    h = step_s(case)
    b = 2.0 / (case.pad_dmax * friction_timeconst_s(case, motion.inverse_mass_1_kg))
    left_out = 1.0 - case.contact_bias * (1.0 - 0.5 * h * b * case.bias_centred)
    runge_kutta = case.integrator == "rk4"
    along = np.array([1.0, 0.0, 1.0])
    as_watched = replace(case, cone=AS_SHIPPED.cone, impratio=AS_SHIPPED.impratio)
    parts = {  # a name with "term" would suggest that the term is restored
        "left_out": left_out * motion.bias_m_s / b,
        "step": -(not runge_kutta) * 0.5 * h * motion.bias_m_s,
        "damping": (case.integrator == "implicitfast") * motion.damping_m_s / b,
        "creep": -softness(case, as_watched, motion.depth_m) * motion.load_m_s / b,
        "rounding": (not case.compensated) * motion.rounding_m,
    }
    return {name: 1e3 * along * vector for name, vector in parts.items()}


def softness(case: Case, reference: Case, depth_m: float) -> float:
    """Return the ratio of R in a case to R in a reference with an elliptic cone.

    Both cases have the same grip. R is proportional to (1 - d) / (d impratio), and the
    impedance d depends on the depth r of the pads. At this depth the normal rows
    balance the grip, k d(r) r = R f, so that stiffer pads have a smaller depth. The
    rows of a pyramidal cone are both normal and friction rows. There are four for each
    contact, with R = 2 μ² (1 + μ²) / impratio times that of the normal row of an
    elliptic cone (MuJoCo, ``mj_makeImpedance``). Each row carries a quarter of the
    normal force, so that these pads have a smaller depth as well.

    Args:
        depth_m: Depth of the contacts in the reference case.
    """
    solimp, of_other = solimp_of(case), impedance_at(solimp_of(reference), depth_m)
    pull_m = (
        pad_stiffness(reference)
        / pad_stiffness(case)
        * of_other
        * depth_m
        / yielding(of_other)
    )
    if case.cone == "pyramidal":
        pull_m *= case.pad_mu**2 * (1.0 + case.pad_mu**2) / (2.0 * case.impratio)
    rows = 1.0 + case.pad_mu**2 if case.cone == "pyramidal" else 1.0
    yielded = yielding(impedance_at(solimp, balanced_depth_m(solimp, pull_m)))
    return rows * reference.impratio / case.impratio * yielded / yielding(of_other)


def balanced_depth_m(solimp: tuple[float, ...], pull_m: float) -> float:
    """Return the depth r [m] with d(r) r = pull_m (1 - d) / d."""
    # The impedance d is never below the first value of solimp.
    shallow_m, deep_m = (
        0.0,
        pull_m * yielding(solimp[0]) / solimp[0],
    )
    for _ in range(BISECTION_COUNT):
        middle_m = 0.5 * (shallow_m + deep_m)
        d = impedance_at(solimp, middle_m)
        is_deep = d * middle_m > pull_m * yielding(d)
        shallow_m, deep_m = (shallow_m, middle_m) if is_deep else (middle_m, deep_m)
    return deep_m


def solimp_of(case: Case) -> tuple[float, ...]:
    return (PAD_SOLIMP[0], case.pad_dmax, *PAD_SOLIMP[2:])


def pad_stiffness(case: Case) -> float:
    """Return k of the pads' normal rows [1/s²]."""
    timeconst_s, dampratio = solref(case.pad_ke, case.pad_kd)
    return reference_stiffness(
        timeconst_s, dampratio, 2.0 * step_s(case), case.pad_dmax
    )


def yielding(impedance: float) -> float:
    """Return the part of R that depends on the impedance."""
    return (1.0 - impedance) / impedance


def contact_timeconst_s(case: Case) -> float:
    """Return the timeconst of the pads' contacts [s], which ``pad_kd`` determines.

    The engine does not use a timeconst shorter than two substeps.
    """
    return max(solref(case.pad_ke, case.pad_kd)[0], 2.0 * step_s(case))


def friction_timeconst_s(case: Case, inverse_mass_1_kg: float) -> float:
    """Return the timeconst of the pads' friction rows [s].

    Some releases have a separate one for friction rows (``kf_is_read``).
    """
    of_contacts_s = contact_timeconst_s(case)
    if (
        kf_is_read()
        and case.contacts == "newton"
        and case.cone == "elliptic"
        and case.pad_kf > 0.0
    ):
        share = (1.0 - case.pad_dmax) / case.impratio + case.pad_dmax
        return max(2.0 / (case.pad_kf * inverse_mass_1_kg * share), 2.0 * step_s(case))
    return of_contacts_s
