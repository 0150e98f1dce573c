"""A lint for scenes: contact parameters that say one thing and do another in MuJoCo's engines.

``python -m experiments.lint`` reads the shake test as shipped and with its fix; ``lint`` reads any finalized model.
"""

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import newton
import numpy as np
import warp as wp

from experiments.case import AS_SHIPPED, STIFF_PADS, UNTRIMMED, Case
from experiments.compat import kf_is_read
from experiments.measurement import SETUP_FRAME_COUNT, Conditions, Measurement
from experiments.scene import build_scene
from experiments.simulation import CONSTRAINT_MAX, CONTACT_MAX
from experiments.task import FRAME_RATE

SAME = 1e-5
"""Relative difference up to which two float32 parameters are the same."""
LARGE_RATIO = 4.0
"""A buffer that holds more than this many times the measured peak is called too large."""
FORCE_SPACE, RAW, CONVERTED = 0, 1, 2
"""``mujoco.solref_mode`` of a shape: ke and kd act as a force, solref is taken as authored, or made from ke and kd."""
DEFAULT_SOLREF = (0.02, 1.0)
"""What Newton writes when ke or kd is 0."""
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)
CONDIM = 3
"""Defaults of the solver's custom attributes."""


@dataclass(frozen=True)
class Finding:
    """One thing that is authored and not what the solver does."""

    rule: str
    """``priority``, ``default-gap``, ``timeconst`` or ``buffer``."""
    shapes: tuple[str, ...]
    """The shape that it is about, then the other one if it is about a pair; empty for a buffer."""
    parameter: str
    value: float
    """As authored."""
    used: float
    """What is used instead; for a buffer, what was needed."""
    unit: str
    message: str


@dataclass(frozen=True)
class Group:
    """Findings that say the same of the same body."""

    first: Finding
    subject: str
    against: str
    count: int


@dataclass(frozen=True)
class Buffer:
    """A buffer of the engine or of the collision pipeline, per world."""

    name: str
    capacity: int
    peak: int
    """Most that a run needed."""


def lint(
    model: newton.Model,
    substep_dt: float,
    *,
    buffers: Sequence[Buffer] = (),
    refsafe: bool = True,
    world: int = 0,
) -> list[Finding]:
    """Everything in a finalized model that ``SolverMuJoCo`` will not use as it was authored.

    Args:
        model: Any finalized model, with or without the solver's custom attributes.
        substep_dt: Time step of the solver [s].
        buffers: Buffers with what a run was measured to need of them.
        refsafe: Whether the engine keeps a contact's timeconst at 2 time steps or more, as it does by default.
        world: World whose shapes are read, with those that all worlds share.
    """
    shapes = _Shapes(model)
    pairs = shapes.colliding_pairs(world)
    found = [*_outranked(shapes, pairs), *_default_gaps(shapes, pairs)]
    if refsafe:
        found += _clamped(shapes, pairs, substep_dt)
    return found + [finding for buffer in buffers for finding in _missized(buffer)]


class _Shapes:
    """Contact parameters of a model's shapes on the host, as the solver reads them."""

    def __init__(self, model: newton.Model):
        self.model = model
        attributes = getattr(model, "mujoco", None)

        def attribute(name: str, default: float | Sequence[float]) -> np.ndarray:
            array = getattr(attributes, name, None)
            return np.array([default] * model.shape_count) if array is None else array.numpy()

        self.priority = attribute("geom_priority", 0)
        self.gap = model.shape_gap.numpy()
        self.mix = attribute("geom_solmix", 1.0)
        self.mode = attribute("solref_mode", CONVERTED)
        self.ke, self.kd = model.shape_material_ke.numpy(), model.shape_material_kd.numpy()
        self.solref = np.where((self.mode == RAW)[:, None], attribute("solref", (0.0, 0.0)), self._converted_solref())
        config = newton.ModelBuilder.ShapeConfig()
        solimp = attribute("geom_solimp", SOLIMP)
        self.parameters = {
            "ke": (self.ke, config.ke),
            "kd": (self.kd, config.kd),
            **({"kf": (model.shape_material_kf.numpy(), config.kf)} if kf_is_read() else {}),
            "mu": (model.shape_material_mu.numpy(), config.mu),
            "mu_torsional": (model.shape_material_mu_torsional.numpy(), config.mu_torsional),
            "mu_rolling": (model.shape_material_mu_rolling.numpy(), config.mu_rolling),
            "condim": (attribute("condim", CONDIM), CONDIM),
            **{f"solimp[{index}]": (solimp[:, index], default) for index, default in enumerate(SOLIMP)},
        }
        """Values of all shapes and the default, by the name of the parameter."""

    def colliding_pairs(self, world: int) -> list[tuple[int, int]]:
        """Pairs of shapes of one world, shared shapes included, that no filter keeps apart."""
        pairs = self.model.shape_contact_pairs.numpy().reshape(-1, 2)
        worlds = self.model.shape_world.numpy()[pairs]
        return [tuple(pair) for pair in pairs[((worlds == world) | (worlds == -1)).all(axis=1)].tolist()]

    def name(self, shape: int) -> str:
        """Body and shape, e.g. ``fr3_leftfinger/shape_21``; only the shape's label where that says it all."""
        body = int(self.model.shape_body.numpy()[shape])
        label = self.model.shape_label[shape].rsplit("/", 1)[-1]
        owner = self.model.body_label[body].rsplit("/", 1)[-1] if body >= 0 else label
        return label if owner == label else f"{owner}/{label}"

    def ranked(self, pair: tuple[int, int]) -> tuple[int, int]:
        """The pair with the shape of higher priority first."""
        return pair if self.priority[pair[0]] >= self.priority[pair[1]] else pair[::-1]

    def timeconst(self, pair: tuple[int, int]) -> float:
        """timeconst [s] of the pair's contacts, as ``contact_params`` of Newton's MuJoCo kernels resolves it."""
        first, second = self.ranked(pair)
        if min(self.solref[first, 0], self.solref[second, 0]) <= 0.0:
            return float(min(self.solref[first, 0], self.solref[second, 0]))
        total = self.mix[first] + self.mix[second]
        share = self.mix[first] / total if total > 0.0 else 0.5
        if self.priority[first] != self.priority[second]:
            share = 1.0
        return float(share * self.solref[first, 0] + (1.0 - share) * self.solref[second, 0])

    def _converted_solref(self) -> np.ndarray:
        there = (self.ke > 0.0) & (self.kd > 0.0)
        ke, kd = np.where(there, self.ke, 1.0), np.where(there, self.kd, 1.0)
        converted = np.stack([2.0 / kd, kd / (2.0 * np.sqrt(ke))], axis=1)
        return np.where(there[:, None], converted, DEFAULT_SOLREF)


def _outranked(shapes: _Shapes, pairs: list[tuple[int, int]]) -> Iterator[Finding]:
    """Authored parameters of the shape of lower priority: of such a pair only the other's values are used."""
    for pair in pairs:
        winner, loser = shapes.ranked(pair)
        if shapes.priority[winner] == shapes.priority[loser]:
            continue
        for name, (values, default) in shapes.parameters.items():
            if name in ("ke", "kd") and RAW in shapes.mode[[winner, loser]]:
                continue  # ke and kd are not what the solver reads of a shape with a solref of its own
            if not _same(values[loser], default) and not _same(values[loser], values[winner]):
                yield Finding(
                    "priority",
                    (shapes.name(loser), shapes.name(winner)),
                    name,
                    float(values[loser]),
                    float(values[winner]),
                    "1",
                    f"never reaches the solver: the other geom's priority is {shapes.priority[winner]}, "
                    f"this one's {shapes.priority[loser]}",
                )


def _default_gaps(shapes: _Shapes, pairs: list[tuple[int, int]]) -> Iterator[Finding]:
    """Shapes that were left at the builder's gap although some that they can touch were not. Gaps of a pair add."""
    default = newton.ModelBuilder().rigid_gap
    for shape in sorted({shape for pair in pairs for shape in pair}):
        neighbours = {a if b == shape else b for a, b in pairs if shape in (a, b)}
        authored = [shapes.gap[other] for other in neighbours if not _same(shapes.gap[other], default)]
        if authored and _same(shapes.gap[shape], default):
            yield Finding(
                "default-gap",
                (shapes.name(shape),),
                "gap",
                float(shapes.gap[shape]),
                float(shapes.gap[shape] + max(authored)),
                "m",
                "is the builder's default although its neighbours' gaps were set; gaps of a pair add",
            )


def _clamped(shapes: _Shapes, pairs: list[tuple[int, int]], substep_dt: float) -> Iterator[Finding]:
    for pair in pairs:
        first, second = shapes.ranked(pair)
        if (shapes.mode[[first, second]] == FORCE_SPACE).all():
            continue  # its timeconst depends on the bodies' masses
        timeconst = shapes.timeconst(pair)
        if 0.0 < timeconst < 2.0 * substep_dt and not _same(timeconst, 2.0 * substep_dt):
            yield Finding(
                "timeconst",
                (shapes.name(first), shapes.name(second)),
                "timeconst",
                timeconst,
                2.0 * substep_dt,
                "s",
                "is below two substeps, which the engine clamps it to",
            )


def _missized(buffer: Buffer) -> Iterator[Finding]:
    message = None
    if buffer.capacity < buffer.peak:
        message = "is smaller than the measured peak: what does not fit is lost"
    elif buffer.capacity > LARGE_RATIO * max(buffer.peak, 1):
        message = "is much larger than the measured peak: every world pays for it"
    if message:
        yield Finding("buffer", (), buffer.name, buffer.capacity, buffer.peak, "count", message)


def _same(a: float, b: float) -> bool:
    return bool(np.isclose(a, b, rtol=SAME, atol=0.0))


def grouped(findings: Sequence[Finding]) -> list[Group]:
    """The findings with those put together that only differ in the shapes of the bodies they are about."""
    groups: dict[object, list[Finding]] = {}
    for finding in findings:
        subject = _body(finding.shapes[0]) if finding.shapes else ""
        groups.setdefault((subject, replace(finding, shapes=())), []).append(finding)
    return [
        Group(
            members[0],
            subject or members[0].parameter,
            ", ".join(dict.fromkeys(_body(shape) for finding in members for shape in finding.shapes[1:])),
            len(members),
        )
        for (subject, _), members in groups.items()
    ]


def _body(name: str) -> str:
    return name.split("/", 1)[0]


@dataclass(frozen=True)
class LintedScene:
    """A scene to be linted, and the case whose run says what its buffers need."""

    case: Case
    peaks: Case


SCENES = {
    # The buffers of the untrimmed scene make a run on the CPU slow; what it needs of them the trimmed one needs too.
    "as-shipped": LintedScene(UNTRIMMED, AS_SHIPPED),
    "fixed": LintedScene(*[replace(STIFF_PADS, cube_gap_m=STIFF_PADS.robot_gap_m)] * 2),
}
PEAK_FRAME_COUNT = SETUP_FRAME_COUNT + FRAME_RATE
"""Frames of the run for the peaks: the set-up and one cycle of the shake."""


def lint_scenes(conditions: Conditions, names: Sequence[str]) -> dict[str, list[Finding]]:
    """Build each scene, run it as far as its peaks, and lint it."""
    runs = [replace(SCENES[name].peaks, frame_count=PEAK_FRAME_COUNT) for name in names]
    traces = conditions.simulate(runs, title="lint")
    found = {}
    for name, trace in zip(names, traces, strict=True):
        case = SCENES[name].case
        buffers = (
            Buffer("contacts", case.contact_max or CONTACT_MAX, trace.peak_contact_count),
            Buffer("constraints", case.constraint_max or CONSTRAINT_MAX, trace.peak_constraint_count),
        )
        model = build_scene([case], wp.get_device("cpu")).model
        found[name] = lint(model, 1.0 / FRAME_RATE / case.substeps, buffers=buffers)
    return found


def measure(conditions: Conditions) -> Measurement:
    """A row for each scene, and one for each group of its findings."""
    rows = []
    for name, findings in lint_scenes(conditions, list(SCENES)).items():
        groups = grouped(findings)
        rows.append({"case": name, "finding_count": len(groups)})
        rows += [{"case": f"{name}-{index}", "scene": name, **columns(group)} for index, group in enumerate(groups, 1)]
    return Measurement(rows)


def columns(group: Group) -> dict[str, object]:
    """A group as columns of a row; values in a column that says their unit."""
    finding = group.first
    unit = "" if finding.unit == "1" else f"_{finding.unit}"
    return {
        "rule": finding.rule,
        "subject": group.subject,
        "against": group.against,
        "pair_count": group.count,
        "parameter": finding.parameter,
        f"authored{unit}": finding.value,
        f"used{unit}": finding.used,
        "message": finding.message,
    }


def describe(group: Group) -> str:
    """A group as one line of text."""
    finding = group.first
    unit = f" {finding.unit}" if finding.unit in ("m", "s") else ""
    pairs = f" ({group.count} pairs)" if group.count > 1 else ""
    place = f"{group.subject} against {group.against}{pairs}: " if group.against else f"{group.subject}: "
    name = finding.parameter if finding.rule == "buffer" else place + finding.parameter
    word = "peak" if finding.rule == "buffer" else "used"
    return f"{finding.rule:12} {name} {finding.value:g}{unit} {finding.message} ({word}: {finding.used:g}{unit})"


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m experiments.lint", description=__doc__.split(":")[0])
    parser.add_argument("scene", nargs="*", help=f"{' or '.join(SCENES)}; default: both")
    parser.add_argument("--strict", action="store_true", help="exit with 1 when anything is found")
    arguments = parser.parse_args()
    if unknown := sorted(set(arguments.scene) - set(SCENES)):
        print(f"{unknown[0]} is no scene; use one of: {', '.join(SCENES)}", file=sys.stderr)
        return 2
    wp.config.log_level = wp.LOG_WARNING
    found = lint_scenes(Conditions(device="cpu", quick=True), arguments.scene or list(SCENES))
    for name, findings in found.items():
        groups = grouped(findings)
        print(f"{name}: {len(groups)} findings" if groups else f"{name}: nothing found")
        for group in groups:
            print(f"  {describe(group)}")
    return 1 if arguments.strict and any(found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
