"""Define a case: the parameters in which runs of the shake test can differ."""

import math
from dataclasses import dataclass, fields, replace

CUBE_GAP_DEFAULT = 0.1
"""Contact gap [m] of a new ``newton.ModelBuilder`` in 1.4.0, which is the gap of the
cube in the scene as shipped.

Section upgrade lists the gap of other releases among the defaults of shapes, and section
defaults measures its effect.
"""


class CaseError(ValueError):
    """Signal a parameter that is out of range; the message is one line for the user."""


@dataclass(frozen=True)
class Case:
    """Describe one run of the shake test.

    The defaults are the scene as shipped, without steps that have no effect (see
    ``UNTRIMMED``).
    """

    name: str

    # Parameters that can differ between the worlds of a batch.
    # Contact stiffness of the finger pads as authored (``ShapeConfig`` default).
    pad_ke: float = 2.5e3
    # Contact damping of the finger pads as authored (``ShapeConfig`` default).
    pad_kd: float = 100.0
    # Friction coefficient of the finger pads (``ShapeConfig`` default).
    pad_mu: float = 1.0
    # Second entry of the pads' solimp: the impedance at full penetration.
    pad_dmax: float = 0.95
    pad_kf: float = 1e3
    """Friction gain of the finger pads as authored (``ShapeConfig`` default).

    It is used from newton 1.5.0 on. A negative gain leaves the friction rows to the
    solref of the normal row.
    """
    cube_ke: float = 8e4
    cube_kd: float = 8e2
    cube_mu: float = 1.2
    cube_density_kg_m3: float = 500.0  # density of the cube [kg/m³]
    cube_gap_m: float = CUBE_GAP_DEFAULT
    """Distance [m] from the cube at which contacts are generated; the gaps of a pair
    add up.
    """
    robot_gap_m: float = 0.005
    # Amplitude A of the shake along its main axis [m]; 0 holds the arm still.
    shake_amplitude_m: float = 0.03
    shake_frequency_hz: float = 1.0  # frequency f of the shake along its main axis [Hz]
    pad_direct: bool = False
    """Whether the pads' solref is (-pad_ke, -pad_kd), which the engine uses without a
    clamp.
    """
    cube_edge_m: float = 0.04
    # Shift of the cube's start along the shake's main axis [m].
    cube_offset_m: float = 0.0
    cube_in_hand: bool = False
    """Whether the run starts at the place of the shake, with the fingers closed on the
    cube.

    The cube is then held still for the duration of the lift.
    """
    # Depth [m] by which the cube overlaps the ground, or both pads, at the start.
    start_overlap_m: float = 0.0
    finger_closed_m: float = -0.01
    """Target position [m] of each finger that holds the cube.

    The finger presses with 400 N/m times its distance from the target.
    """
    gravity_m_s2: float = 9.81  # downward acceleration [m/s²]; negative is upward

    contact_bias: bool = False
    """Whether friction rows include the acceleration J̇ q̇, which the engine ignores.
    """
    # Whether these rows also use the mean velocity of the last step instead of the
    # velocity at its end.
    bias_centred: bool = False
    bias_normal: bool = False  # whether normal rows include it as well
    compensated: bool = False
    """Whether joint positions are summed with compensation for rounding; MuJoCo Warp
    only.
    """

    # Parameters that all worlds of a batch share, because mujoco_warp keeps one
    # geom_priority, one set of geoms and one solver.
    ground_gap_m: float = 0.005
    pad_priority: int = 1
    # ``box``, or ``convex-mesh`` for the same boxes as convex meshes.
    pad_shape: str = "box"
    hand_collides: bool = True
    visuals: bool = True  # whether the robot keeps its visual shapes
    # ``warp`` (MuJoCo Warp) or ``mujoco`` (MuJoCo's C engine, always on the CPU).
    backend: str = "warp"
    # Warp device; without one, the case runs on the device of the measurement.
    device: str | None = None
    # Source of contacts: ``newton`` or ``mujoco``. The C engine always generates its
    # own.
    contacts: str = "newton"
    broad_phase: str = "nxn"
    """Newton's broad phase: ``nxn`` tests all pairs of shapes, ``explicit`` those that
    may collide.
    """
    collide_count: int = 1  # collision passes per frame; must divide ``substeps``
    substeps: int = 16
    solver: str = "newton"
    integrator: str = "implicitfast"
    iterations: int = 15
    ls_iterations: int = 100
    tolerance: float | None = None
    ls_tolerance: float | None = None
    cone: str = "elliptic"
    impratio: float = 50.0
    # Iterations of the pass that solves friction again without its regularization.
    noslip_iterations: int = 0
    friction_timeconst_override_s: float | None = None
    """Replaces the solreffriction of Newton's contacts by a timeconst [s].

    0 leaves the friction rows to the solref of the normal row. None keeps the value of
    the release.
    """
    refsafe: bool = True  # whether the engine limits timeconst to at least two substeps
    # Whether the engine's sensor stage runs; the scene has no sensor.
    sensors: bool = True
    limits: bool = True  # whether the engine checks joints for their limits
    # Contacts per world that the buffers can hold; None sizes them for the scene.
    contact_max: int | None = None
    # Constraint rows per world that the buffers can hold; None sizes them for the
    # scene.
    constraint_max: int | None = None
    ik_iterations: int = 8
    """IK iterations per frame.

    The scene as shipped has 24. On the CPU, iterations after the eighth did not change
    any bit in the positions of the TCP and the cube.
    """
    state_sync: bool = False
    """Whether Newton's state and targets are written into the engine before every
    substep.

    This is so in the scene as shipped. Otherwise the targets are written once per frame
    and the state is never written. This changes the slip by less than the noise, but
    some bodies are at times displaced by 0.1 mm.
    """
    ik_beside: bool = True
    """Whether the IK of the next frame runs in parallel with the physics of this frame.

    Otherwise each frame waits for its own IK, as in the scene as shipped.
    """
    fixed_joints: bool = True
    """Whether links with fixed joints are separate bodies, as in the robot's
    description.
    """
    # Whether a frame is captured once and replayed, or launched kernel by kernel.
    graph: bool = True
    frame_count: int = 900

    def __post_init__(self):
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, (float, int)) and not math.isfinite(value):
                raise CaseError(f"{field.name} must be a finite number, got {value}")
        for name in (
            "pad_ke",
            "pad_kd",
            "cube_ke",
            "cube_kd",
            "cube_density_kg_m3",
            "cube_edge_m",
            "shake_frequency_hz",
        ):
            if getattr(self, name) <= 0.0:
                raise CaseError(
                    f"{name} must be greater than 0, got {getattr(self, name):g}"
                )
        for name in (
            "pad_mu",
            "cube_mu",
            "cube_gap_m",
            "robot_gap_m",
            "ground_gap_m",
            "shake_amplitude_m",
        ):
            if getattr(self, name) < 0.0:
                raise CaseError(
                    f"{name} must not be negative, got {getattr(self, name):g}"
                )
        for name in (
            "substeps",
            "collide_count",
            "iterations",
            "ls_iterations",
            "ik_iterations",
            "frame_count",
        ):
            if getattr(self, name) < 1:
                raise CaseError(f"{name} must be at least 1, got {getattr(self, name)}")
        for name in ("bias_centred", "bias_normal"):
            if getattr(self, name) and not self.contact_bias:
                raise CaseError(f"{name} needs contact_bias, which is off")
        if self.substeps % self.collide_count:
            raise CaseError(
                f"collide_count must divide substeps ({self.substeps}), got {self.collide_count}"
            )


WORLD_FIELDS = (  # parameters that may differ between the worlds of one batch
    "pad_ke pad_kd pad_mu pad_dmax pad_kf cube_ke cube_kd cube_mu cube_density_kg_m3 cube_gap_m robot_gap_m"
    " shake_amplitude_m shake_frequency_hz pad_direct cube_edge_m cube_offset_m cube_in_hand start_overlap_m"
    " finger_closed_m gravity_m_s2 contact_bias bias_centred bias_normal compensated"
).split()
RUN_TIME_FIELDS = "ik_iterations ik_beside state_sync sensors limits".split()
"""Parameters that a simulation can change without being rebuilt."""


def batch_key(case: Case) -> Case:
    """Return the parameters that must be equal for two cases in the same simulation."""
    baseline = Case(name="")
    return replace(
        case, name="", **{name: getattr(baseline, name) for name in WORLD_FIELDS}
    )


def build_key(case: Case) -> Case:
    """Return the parameters that must be equal to run cases in one simulation."""
    baseline = Case(name="")
    return replace(
        case, name="", **{name: getattr(baseline, name) for name in RUN_TIME_FIELDS}
    )


def differences(case: Case) -> dict[str, object]:
    """Return the parameters that differ from the scene as shipped, by name."""
    baseline = Case(name="")
    names = (field.name for field in fields(case) if field.name != "name")
    return {
        name: getattr(case, name)
        for name in names
        if getattr(case, name) != getattr(baseline, name)
    }


AS_SHIPPED = Case(name="as-shipped")
"""The baseline of every comparison: the scene as shipped, without steps that have no
effect.
"""
UNTRIMMED = replace(  # the scene exactly as shipped, including steps without effect
    AS_SHIPPED,
    name="untrimmed",
    ik_iterations=24,
    ik_beside=False,
    state_sync=True,
    contact_max=4096,
    constraint_max=8192,
)
LEAN = replace(
    AS_SHIPPED,
    name="lean",
    cube_gap_m=AS_SHIPPED.robot_gap_m,
    hand_collides=False,
    visuals=False,
    fixed_joints=False,
    broad_phase="explicit",
    contact_max=32,
    constraint_max=64,
)
"""The scene as shipped without parts that it does not need.

With the small gap, the peaks are 21 contacts and 50 rows.
"""
# The one change that holds the cube.
STIFF_PADS = replace(
    AS_SHIPPED,
    name="stiff-pads",
    pad_ke=2.5e5,
    pad_kd=1e3,
)
# The same grasp with the arm held still.
HOLD = replace(
    AS_SHIPPED,
    name="hold",
    shake_amplitude_m=0.0,
)
FIXED = replace(LEAN, name="fixed", pad_ke=STIFF_PADS.pad_ke, pad_kd=STIFF_PADS.pad_kd)
"""The recommended scene: stiff pads, without parts that it does not need."""

# Parts of the cure, one at a time and together, as fields of a case.
TERMS = {
    "plain": {},
    "term": {"contact_bias": True},
    "centred": {"contact_bias": True, "bias_centred": True},
    "full": {"contact_bias": True, "bias_centred": True, "bias_normal": True},
}  # type: dict[str, dict]
"""Settings for the ignored term; ``full`` also adds it to the normal rows."""
POSITIONS = {"rounded": {}, "kept": {"compensated": True}}  # type: dict[str, dict]
IMPRATIO = 400.0
BEST = {
    "integrator": "euler",
    "impratio": IMPRATIO,
    **TERMS["full"],
    **POSITIONS["kept"],
}  # type: dict
"""All parts together.

The Euler integrator has no damping in its step. The centred term also corrects the
error of the step.
"""
FIRM = {"pad_ke": STIFF_PADS.pad_ke, "pad_kd": STIFF_PADS.pad_kd, "impratio": IMPRATIO}  # type: dict
FIRM |= TERMS["centred"] | POSITIONS["kept"]
"""The cure with stiff pads, for which the normal rows do not need the term."""
