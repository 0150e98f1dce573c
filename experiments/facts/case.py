"""A case: everything in which one run of the shake test can differ from another, as plain data."""

import math
from dataclasses import dataclass, fields, replace

CUBE_GAP_DEFAULT = 0.1
"""Contact gap [m] of a fresh ``newton.ModelBuilder`` of 1.4.0, which is what the cube is shipped with. What a release
has is in section upgrade, as a shape default, and is tried in section defaults."""


class CaseError(ValueError):
    """A parameter of a case is out of range; the message is one line for the person who typed it."""


@dataclass(frozen=True)
class Case:
    """One run of the shake test. By default the scene as shipped, less what changes nothing: see ``UNTRIMMED``."""

    name: str

    # What each world of a batch has for itself.
    pad_ke: float = (
        2.5e3  # authored contact stiffness of the finger pads (``ShapeConfig`` default)
    )
    pad_kd: float = (
        100.0  # authored contact damping of the finger pads (``ShapeConfig`` default)
    )
    pad_mu: float = (
        1.0  # friction coefficient of the finger pads (``ShapeConfig`` default)
    )
    pad_dmax: float = (
        0.95  # second entry of the pads' solimp: the impedance at full penetration
    )
    pad_kf: float = 1e3
    """Authored friction gain of the finger pads (``ShapeConfig`` default); read from newton 1.5.0 on, and there a
    negative one leaves the friction rows to the normal row's solref."""
    cube_ke: float = 8e4
    cube_kd: float = 8e2
    cube_mu: float = 1.2
    cube_density_kg_m3: float = 500.0  # density of the cube [kg/m³]
    cube_gap_m: float = CUBE_GAP_DEFAULT
    """Distance [m] from the cube at which contacts are generated; the gaps of a pair add."""
    robot_gap_m: float = 0.005
    shake_amplitude_m: float = (
        0.03  # amplitude A of the shake along its main axis [m]; 0 holds the arm still
    )
    shake_frequency_hz: float = 1.0  # frequency f of the shake along its main axis [Hz]
    pad_direct: bool = False
    """Whether the pads' solref is (-pad_ke, -pad_kd), which the engine takes as it is, with no clamp."""
    cube_edge_m: float = 0.04
    cube_offset_m: float = (
        0.0  # shift of the cube's start along the shake's main axis [m]
    )
    cube_in_hand: bool = False
    """Whether the run starts where the shake will be, with the fingers closed on the cube. It is then held still for as
    long as the lift takes."""
    start_overlap_m: float = 0.0  # how deep [m] the cube starts in what it touches: the ground, or each of the pads
    finger_closed_m: float = -0.01
    """Position target [m] of each finger that holds the cube: what is missing to it presses, at 400 N/m."""
    gravity_m_s2: float = 9.81  # downward acceleration [m/s²]; negative is upward

    contact_bias: bool = False
    """Whether friction rows get back the acceleration J̇ q̇ that the engine leaves out of them."""
    bias_centred: bool = False  # whether they also see the velocity of the last step's motion, and not that at its end
    bias_normal: bool = False  # whether normal rows get it back as well
    compensated: bool = False
    """Whether joint positions are summed with what rounding took from them kept; MuJoCo Warp only."""

    # What all worlds of a batch share: mujoco_warp keeps one geom_priority, one set of geoms, one solver.
    ground_gap_m: float = 0.005
    pad_priority: int = 1
    pad_shape: str = (
        "box"  # ``box``, or ``convex-mesh``: the same boxes as convex meshes
    )
    hand_collides: bool = True
    visuals: bool = True  # whether the robot keeps its shapes for looking at
    backend: str = "warp"  # ``warp`` (MuJoCo Warp) or ``mujoco`` (MuJoCo's C engine, always on the CPU)
    device: str | None = None  # Warp device; None is the device of the measurement
    contacts: str = "newton"  # Who generates contacts: ``newton`` or ``mujoco``. The C engine always generates its own.
    broad_phase: str = "nxn"
    """Newton's broad phase: ``nxn`` tests all pairs of shapes, ``explicit`` those that may collide."""
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
    noslip_iterations: int = 0  # iterations of the pass that solves friction once more, without its regularization
    friction_timeconst_override_s: float | None = None
    """Written over the solreffriction of Newton's contacts: a timeconst [s], or 0 for none, which leaves the friction
    rows to the normal row's solref. None keeps what the release writes."""
    refsafe: bool = True  # whether the engine takes no timeconst below two substeps
    sensors: bool = (
        True  # whether the engine's sensor stage runs; the scene has no sensor
    )
    limits: bool = True  # whether the engine looks for joints at their limits
    contact_max: int | None = (
        None  # contacts per world that the buffers hold; None sizes them for the scene
    )
    constraint_max: int | None = (
        None  # constraint rows per world that the buffers hold; None sizes them for the scene
    )
    ik_iterations: int = 8
    """IK iterations per frame. The scene ships with 24; on the CPU those after the eighth were seen to change no bit of
    the positions of TCP and cube."""
    state_sync: bool = False
    """Whether Newton's state and targets are written into the engine before every substep, as shipped, or the targets
    once a frame and the state never. Without it the slip changes by less than the noise; some body is at times 0.1 mm
    from where it was."""
    ik_beside: bool = True
    """Whether the next frame's IK runs beside this frame's physics, or each frame waits for its own, as shipped."""
    fixed_joints: bool = True
    """Whether links that are fixed to one another are bodies of their own, as in the robot's description."""
    graph: bool = True  # whether a frame is captured once and replayed, or launched kernel by kernel
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
"""Parameters that a simulation can change without being built again."""


def batch_key(case: Case) -> Case:
    """Return what must be equal for two cases to be worlds of the same simulation."""
    baseline = Case(name="")
    return replace(
        case, name="", **{name: getattr(baseline, name) for name in WORLD_FIELDS}
    )


def build_key(case: Case) -> Case:
    """Return what must be equal for two cases to be run by one simulation, one after the other."""
    baseline = Case(name="")
    return replace(
        case, name="", **{name: getattr(baseline, name) for name in RUN_TIME_FIELDS}
    )


def differences(case: Case) -> dict[str, object]:
    """Return the parameters in which ``case`` differs from the scene as shipped, by name."""
    baseline = Case(name="")
    names = (field.name for field in fields(case) if field.name != "name")
    return {
        name: getattr(case, name)
        for name in names
        if getattr(case, name) != getattr(baseline, name)
    }


AS_SHIPPED = Case(name="as-shipped")
"""The baseline of every comparison: the scene as shipped, less what was measured to change nothing."""
UNTRIMMED = replace(  # the scene exactly as shipped, with all that it pays for
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
"""The scene as shipped without what it does not need. With the small gap 21 contacts and 50 rows are the peaks."""
STIFF_PADS = replace(
    AS_SHIPPED, name="stiff-pads", pad_ke=2.5e5, pad_kd=1e3
)  # the one change that holds the cube
HOLD = replace(
    AS_SHIPPED, name="hold", shake_amplitude_m=0.0
)  # the same grasp with the arm held still
FIXED = replace(LEAN, name="fixed", pad_ke=STIFF_PADS.pad_ke, pad_kd=STIFF_PADS.pad_kd)
"""The scene to use: stiff pads, and nothing that it does not need."""

# Parts of the cure, alone and together, as fields of a case.
TERMS = {
    "plain": {},
    "term": {"contact_bias": True},
    "centred": {"contact_bias": True, "bias_centred": True},
    "full": {"contact_bias": True, "bias_centred": True, "bias_normal": True},
}  # type: dict[str, dict]
"""Settings by what is done about the left-out term; ``full`` also gives it to the normal rows."""
POSITIONS = {"rounded": {}, "kept": {"compensated": True}}  # type: dict[str, dict]
IMPRATIO = 400.0
BEST = {
    "integrator": "euler",
    "impratio": IMPRATIO,
    **TERMS["full"],
    **POSITIONS["kept"],
}  # type: dict
"""All parts together: Euler has no damping in its step, and centred the term takes the error of the step along."""
FIRM = {"pad_ke": STIFF_PADS.pad_ke, "pad_kd": STIFF_PADS.pad_kd, "impratio": IMPRATIO}  # type: dict
FIRM |= TERMS["centred"] | POSITIONS["kept"]
"""The cure on stiff pads, where the normal rows need none."""
