"""The points of the diagram of error against run time: which settings, with which pads, through which engine."""

from dataclasses import dataclass, replace

from experiments.case import AS_SHIPPED, STIFF_PADS, Case

PADS = {"as-shipped": AS_SHIPPED, "stiff": STIFF_PADS}
SUBSTEPS = (1, 2, 4, 8, 16, 32, 64)
LADDERS = {
    "full": {"newton": SUBSTEPS, "mujoco": SUBSTEPS, "newton-each-substep": (4, 16, 64), "cpu": (1, 4, 16)},
    "quick": {"newton": (2, 4, 16), "mujoco": (4, 16), "newton-each-substep": (16,), "cpu": ()},
}
"""Substeps of each method; ``cpu`` is Warp on the CPU of a machine that has a GPU."""
KNOBS = {
    "full": {
        "as-shipped": {
            "iterations": (1, 2, 5, 50, 200),
            "ls_iterations": (5, 20),
            "solver": ("cg",),
            "cone": ("pyramidal",),
            "impratio": (1.0, 1000.0),
            "integrator": ("euler", "rk4"),
        },
        "stiff": {"iterations": (5, 200), "solver": ("cg",), "cone": ("pyramidal",), "impratio": (1.0,)},
    },
    "quick": {
        "as-shipped": {"iterations": (1, 200), "cone": ("pyramidal",), "impratio": (1.0,)},
        "stiff": {"iterations": (200,), "impratio": (1.0,)},
    },
}
"""What else is varied, one at a time, in the method and with the substeps as shipped."""
TIGHT = {"iterations": 200, "ls_iterations": 200, "tolerance": 1e-12, "ls_tolerance": 1e-6}
MODEL_FIELDS = ("cone", "impratio")
"""Knobs that make it another model, which converges to another solution."""
CYCLE_COUNT = 3
"""Shake cycles: one to settle, and the two after which the whole motion repeats."""
FRAME_COUNT = 60 * CYCLE_COUNT + 1


@dataclass(frozen=True)
class Setting:
    """One point of the diagram."""

    case: Case
    pads: str
    """Key of PADS."""
    method: str
    """Whose contacts, through which engine: ``newton``, ``newton-each-substep``, ``mujoco``, ``cpu`` or ``c``; or
    ``reference``."""
    knob: str
    """The parameter that is varied."""

    @property
    def is_native(self) -> bool:
        """Whether it runs in MuJoCo's own loop."""
        return self.case.backend == "mujoco"


def settings(profile: str, *, cpu_too: bool) -> list[Setting]:
    """All points: substeps of each method, the other knobs as shipped, and whatever is in Warp also in C.

    Args:
        profile: ``full`` or ``quick``.
        cpu_too: Whether Warp is run on the CPU as well.
    """
    points = []
    for pads, base in PADS.items():
        for method, ladder in LADDERS[profile].items():
            if method != "cpu" or cpu_too:
                points += [setting(by_method(base, method, n), pads, method, "substeps") for n in ladder]
        for knob, values in KNOBS[profile][pads].items():
            points += [setting(replace(base, **{knob: value}), pads, "newton", knob) for value in values]
    return points + list(dict.fromkeys(map(native_of, points)))


def by_method(base: Case, method: str, substeps: int) -> Case:
    changes = {
        "newton": {},
        "mujoco": {"contacts": "mujoco"},
        "newton-each-substep": {"collide_count": substeps},
        "cpu": {"device": "cpu"},
    }
    return replace(base, substeps=substeps, **changes[method])


def setting(case: Case, pads: str, method: str, knob: str) -> Setting:
    value = getattr(case, knob)
    name = f"{pads}/{method}/{knob}-{value:g}" if isinstance(value, float) else f"{pads}/{method}/{knob}-{value}"
    return Setting(replace(case, name=name, frame_count=FRAME_COUNT), pads, method, knob)


def native_of(point: Setting) -> Setting:
    """The same setting in MuJoCo's C engine, which makes its own contacts in every step."""
    case = replace(point.case, backend="mujoco", contacts="newton", collide_count=1, device=None)
    return setting(case, point.pads, "c", point.knob)


def reference_of(point: Setting, substeps: int) -> Setting:
    """The converged solution of the setting's model, in C."""
    model = {name: getattr(point.case, name) for name in MODEL_FIELDS}
    case = replace(PADS[point.pads], backend="mujoco", substeps=substeps, frame_count=FRAME_COUNT, **model, **TIGHT)
    name = f"{point.pads}/reference/{case.cone}-impratio-{case.impratio:g}-substeps-{substeps}"
    return Setting(replace(case, name=name), point.pads, "reference", "substeps")
