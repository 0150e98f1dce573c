"""Applies the rules to Newton models, and checks ke, kd and kf, which MuJoCo lacks."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

import newton
import numpy as np
from mujoco import MjData
from newton.solvers import SolverMuJoCo

from newton_lint.combined import share
from newton_lint.findings import Finding, Hits, Remedy, findings_of
from newton_lint.law import DEFAULT_SOLREF
from newton_lint.newton_models.compat import kf_is_read
from newton_lint.rules import SAME
from newton_lint.scene import Engine, Scene, qualified
from newton_lint.source import Source
from newton_lint.warp_engine import muted_standard_error

CONVERTED = 2
"""Value of ``mujoco.solref_mode`` for a solref that is computed from ke and kd."""


@dataclass(frozen=True)
class Shapes(Scene):
    """A Newton model, compiled by the solver, with geoms named after their shapes."""

    shapes: newton.Model = field(kw_only=True)
    start: MjData = field(kw_only=True)
    """The initial state of the model, as the solver converts it."""

    @classmethod
    def of(cls, model: newton.Model, engine: Engine) -> "Shapes":
        """Compile a model that has shapes."""
        with muted_standard_error():
            solver = SolverMuJoCo(model, use_mujoco_cpu=True)
        compiled = engine.configured(solver.mj_model)
        source = Source(None, compiled)
        return cls(compiled, source, engine, shapes=model, start=solver.mj_data)

    # SolverMuJoCo steps in MuJoCo Warp by default.
    contact_engine = "warp"

    @cached_property
    def index(self) -> np.ndarray:
        """Return the shape of each geom, which is the number at the end of its name."""
        names = (self.model.geom(geom).name for geom in range(self.model.ngeom))
        return np.array([int(name.rpartition("_")[2]) for name in names], dtype=int)

    @cached_property
    def names(self) -> list[str]:
        """Return the body and shape names of each geom, such as ``fr3_leftfinger/shape_21``."""
        labels = [label.rsplit("/", 1)[-1] for label in self.shapes.shape_label]
        bodies = [label.rsplit("/", 1)[-1] for label in self.shapes.body_label]
        owners = [
            bodies[body] if body >= 0 else "" for body in self.shapes.shape_body.numpy()
        ]
        return [qualified(owners[shape], labels[shape]) for shape in self.index]

    def of_geoms(self, name: str) -> np.ndarray:
        """Return an array of the model's shapes, indexed by geom."""
        return getattr(self.shapes, name).numpy()[self.index]


def findings_in(scene: Shapes) -> list[Finding]:
    """Return all parameters that ``SolverMuJoCo`` does not use as they are written."""
    rules = (ke_without_kd, friction_gain, restitution)
    return [
        replace(finding, hint=" ".join(hint for _, hint in remedy))
        for rule in rules
        for hits in rule(scene)
        for findings, remedy in findings_of(hits, scene.names)
        for finding in findings
    ]


def ke_without_kd(scene: Shapes) -> Iterator[Hits]:
    """Yield a ke without kd, or a kd without ke, which the solver ignores."""
    timeconst_s, ratio = DEFAULT_SOLREF
    mode = getattr(getattr(scene.shapes, "mujoco", None), "solref_mode", None)
    # In the mode RAW, which importers of MJCF and USD set, ke and kd are not read.
    converted = scene.counts & (
        True if mode is None else mode.numpy()[scene.index] == CONVERTED
    )
    values = {name: scene.of_geoms(f"shape_material_{name}") for name in ("ke", "kd")}
    for name, zero, used in (
        ("ke", "kd", 1.0 / (timeconst_s * ratio) ** 2),
        ("kd", "ke", 2.0 / timeconst_s),
    ):
        hit = converted & (values[name] > 0.0) & (values[zero] <= 0.0)
        yield Hits(
            Finding(
                "ke-without-kd",
                "",
                name,
                0.0,
                f"$shape has a {name} of $value, which is not read because its {zero} is 0,"
                f" so the solver uses solref ({timeconst_s:g}, {ratio:g})",
            ),
            hit,
            values[name],
            used,
        )


def restitution(scene: Shapes) -> Iterator[Hits]:
    """Yield a restitution, which ``SolverMuJoCo`` does not read."""
    values = scene.of_geoms("shape_material_restitution")
    hit = scene.counts & (values > 0.0)

    def advise(geom: int) -> Remedy:
        # A linear contact rebounds with e = exp(-π ζ / √(1 - ζ²)).
        log = math.log(min(max(values[geom], 1e-3), 0.999))
        ratio = -log / math.hypot(math.pi, log)
        return [
            (
                (),
                "Set kd to"
                f" {2.0 * ratio:.2g}·√ke, which gives a damping ratio of {ratio:.2g}.",
            )
        ]

    yield Hits(
        Finding(
            "restitution",
            "",
            "restitution",
            0.0,
            "$shape has a restitution of $value, which is ignored because SolverMuJoCo"
            " has no restitution; the damping of a contact decides how it rebounds",
        ),
        hit,
        values,
        advise=advise,
    )


def friction_gain(scene: Shapes) -> Iterator[Hits]:
    """Yield a kf that is not read, is clamped, or removes the friction."""
    contacts = scene.contacts
    kf = scene.of_geoms("shape_material_kf")
    authored = ~np.isclose(kf, newton.ModelBuilder.ShapeConfig().kf, rtol=SAME)
    if reason := kf_unread(scene):
        unread = authored & scene.counts
        yield Hits(
            Finding(
                "kf",
                "",
                "kf",
                0.0,
                f"$shape has a kf of $value, which is not read {reason}",
            ),
            unread,
            kf,
        )
        return
    first = contacts.first
    second = contacts.second
    solmix = scene.model.geom_solmix
    mix = share(solmix[first], solmix[second], contacts.outranked)[:, 0]
    mixed = mix * kf[first] + (1.0 - mix) * kf[second]
    mu = contacts.friction[:, 0]
    frictionless = (contacts.condim > 1) & (mixed == 0.0)
    wording = Finding(
        "kf",
        "",
        "mu",
        0.0,
        "$shape has a mu of $value against $against, which is not read because a kf"
        " of 0 removes the friction",
    )
    yield Hits(wording, frictionless, mu, shape=first, partner=second)
    option = scene.option
    dmax = contacts.solimp[:, 1]
    portion = (1.0 - dmax) / option.impratio + dmax
    most = 1.0 / (option.timestep_s * contacts.weight * portion)
    is_authored = authored[first] | authored[second] & ~contacts.outranked
    clamped = (contacts.named < 0) & is_authored & (mixed > most * (1.0 + SAME))
    wording = Finding(
        "kf",
        "",
        "kf",
        0.0,
        "$shape has a kf of $value against $against, but MuJoCo uses $used, because"
        " the timeconst of friction cannot be shorter than two time steps",
    )
    hit = clamped & option.refsafe
    yield Hits(wording, hit, mixed, used=most, shape=first, partner=second)


def kf_unread(scene: Scene) -> str:
    """Return why kf is not read, or an empty string if it is."""
    if not kf_is_read():
        return "by SolverMuJoCo in this release"
    if scene.engine.name != "newton":
        return "by SolverMuJoCo with MuJoCo's contacts"
    return "" if scene.option.cone == "elliptic" else "with a pyramidal friction cone"
