"""Define the settings whose error and run time are measured."""

from dataclasses import dataclass, replace

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case
from experiments.simulation.reference import ENGINES_AGREE
from experiments.simulation.stepper_c import is_in_c

PADS = {
    name: replace(case, **ENGINES_AGREE)
    for name, case in (("as-shipped", AS_SHIPPED), ("stiff", STIFF_PADS))
}
SUBSTEPS = (1, 2, 4, 8, 16, 32, 64)
# Numbers of substeps for each method. Settings that run in Warp also run in C.
LADDERS = {
    "full": {
        "newton": SUBSTEPS,
        "mujoco": SUBSTEPS,
        "newton-each-substep": (4, 16),
        "newton-rk4": (2, 4, 16),
        "mujoco-rk4": (2, 4),
        "cpu": (1, 4, 16),
        "c-rk4": (1, 2, 4, 8, 16, 32),
    },
    "quick": {
        "newton": (2, 4, 16),
        "mujoco": (4, 16),
        "newton-each-substep": (16,),
        "c-rk4": (1, 2, 4, 8),
    },
}
METHODS = {
    "newton": {},
    "newton-each-substep": {},
    "mujoco": {"contacts": "mujoco"},
    "newton-rk4": {"integrator": "rk4"},
    "mujoco-rk4": {"contacts": "mujoco", "integrator": "rk4"},
    "cpu": {"device": "cpu"},
    "c-rk4": {"backend": "mujoco", "integrator": "rk4"},
}  # type: dict[str, dict]
"""Contacts, engine and integrator of each method.

The methods use Newton's or MuJoCo's contacts in Warp, Newton's contacts with a
collision pass in each substep, and Newton's contacts in Warp on the CPU of a machine
with a GPU. MuJoCo's C engine is also used as ``c``.
"""
KNOBS = {
    "full": {
        "as-shipped": {
            "iterations": (1, 2, 5, 50, 200),
            "ls_iterations": (5, 20),
            "solver": ("cg",),
            "cone": ("pyramidal",),
            "impratio": (1.0, 1000.0),
            "integrator": ("euler",),
        },
        "stiff": {
            "iterations": (5, 200),
            "solver": ("cg",),
            "cone": ("pyramidal",),
            "impratio": (1.0,),
        },
    },
    "quick": {
        "as-shipped": {
            "iterations": (1, 200),
            "cone": ("pyramidal",),
            "impratio": (1.0,),
        },
        "stiff": {},
    },
}  # type: dict[str, dict[str, dict]]
"""Parameters that are varied one at a time, with the default method and substeps."""
CONVERGED = {
    "integrator": "rk4",
    "iterations": 200,
    "ls_iterations": 200,
    "tolerance": 1e-12,
    "ls_tolerance": 1e-6,
}  # type: dict
# Parameters that change the model, which then converges to another solution.
MODEL_FIELDS = (
    "cone",
    "impratio",
)
# Shake cycles: one to settle, and two after which the whole motion repeats.
CYCLE_COUNT = 3
FRAME_COUNT = 60 * CYCLE_COUNT + 1


@dataclass(frozen=True)
class Setting:
    """Describe one measured setting."""

    case: Case
    pads: str  # key of PADS
    method: str  # key of METHODS, ``c`` or ``reference``
    knob: str  # the parameter that is varied

    @property
    def is_native(self) -> bool:
        """Return whether the setting runs in MuJoCo's own loop."""
        return is_in_c(self.case)


def settings(profile: str, *, cpu_too: bool) -> list[Setting]:
    """Return all settings.

    The substeps of each method are varied, then the other parameters. All settings that
    run in Warp also run in C.

    Args:
        profile: ``full`` or ``quick``.
        cpu_too: Whether Warp also runs on the CPU.
    """
    points = []
    for pads, base in PADS.items():
        for method, ladder in LADDERS[profile].items():
            if method != "cpu" or cpu_too:
                points += [
                    setting(by_method(base, method, n), pads, method, "substeps")
                    for n in ladder
                ]
        for knob, values in KNOBS[profile][pads].items():
            points += [
                setting(replace(base, **{knob: value}), pads, "newton", knob)
                for value in values
            ]
    return list(dict.fromkeys([*points, *map(native_of, points)]))


def by_method(base: Case, method: str, substeps: int) -> Case:
    collide_count = substeps if method == "newton-each-substep" else 1
    return replace(
        base, substeps=substeps, collide_count=collide_count, **METHODS[method]
    )


def setting(case: Case, pads: str, method: str, knob: str) -> Setting:
    value = getattr(case, knob)
    name = (
        f"{pads}/{method}/{knob}-{value:g}"
        if isinstance(value, float)
        else f"{pads}/{method}/{knob}-{value}"
    )
    return Setting(
        replace(case, name=name, frame_count=FRAME_COUNT), pads, method, knob
    )


def native_of(point: Setting) -> Setting:
    """Return the same setting in MuJoCo's C engine.

    This engine generates its own contacts in every step.
    """
    case = replace(
        point.case, backend="mujoco", contacts="newton", collide_count=1, device=None
    )
    return setting(
        case, point.pads, "c-rk4" if case.integrator == "rk4" else "c", point.knob
    )


def reference_of(point: Setting, substeps: int) -> Setting:
    """Return the converged solution of the setting's model, in C."""
    model = {name: getattr(point.case, name) for name in MODEL_FIELDS}
    case = replace(
        PADS[point.pads],
        backend="mujoco",
        substeps=substeps,
        frame_count=FRAME_COUNT,
        **CONVERGED,
        **model,
    )
    name = f"{point.pads}/reference/{case.cone}-impratio-{case.impratio:g}-substeps-{substeps}"
    return Setting(replace(case, name=name), point.pads, "reference", "substeps")
