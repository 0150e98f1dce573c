"""Implements ``newton-lint prescribe``: searches settings that reduce creep.

The law ranks the settings; the best ones are simulated in MuJoCo C.
"""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from mujoco import MjData, MjModel

from newton_lint.advice import for_option
from newton_lint.command import CLEAN, FOUND, Parser, add_work, engine_of, work_of
from newton_lint.findings import Change
from newton_lint.law import M
from newton_lint.mend import fix
from newton_lint.output import rated
from newton_lint.report import scene_of
from newton_lint.scene import ELLIPTIC, Scene, changed
from newton_lint.settle import (
    Hold,
    Work,
    predicted_hold,
    settled,
    settled_hold,
    started,
)
from newton_lint.target import Target, TargetError, read_target

BELOW_MM_S = 0.1
# A setting is tried first if its prediction is below this share of the bound.
SAFETY = 0.8
# At most this many settings are simulated.
MOST_TRIES = 5
MEASURED_S = 1.0
"""Time over which creep is measured once the scene has settled."""
TIMECONSTS_S = (0.01, 0.005, 0.002)
IMPRATIOS = (10.0, 100.0, 1000.0)
NOSLIP = 10


@dataclass(frozen=True)
class Setting:
    """A timeconst for the touching geoms, and options; None and absent ones stay."""

    timeconst_s: float | None = None
    options: dict[str, float] = field(default_factory=dict)

    def attributes(self) -> dict[str, str]:
        """Return the attributes of ``<option>``."""
        return {
            name: "elliptic" if name == "cone" else f"{value:g}"
            for name, value in self.options.items()
        }

    @property
    def change_count(self) -> int:
        """Return the number of changes.

        A noslip pass counts twice, because most releases of MuJoCo Warp do not have it.
        """
        return (
            len(self.options)
            + (self.timeconst_s is not None)
            + ("noslip_iterations" in self.options)
        )

    def __str__(self) -> str:
        attributes = self.attributes() | (
            {} if self.timeconst_s is None else {"solref": f"{self.timeconst_s:g} 1"}
        )
        return (
            " ".join(f'{name}="{value}"' for name, value in attributes.items())
            or "as it is"
        )


@dataclass(frozen=True)
class Trial:
    """A setting with its predicted and its measured creep."""

    setting: Setting
    predicted_mm_s: float
    measured_mm_s: float


def main(arguments: Sequence[str]) -> int:
    parser = Parser(
        prog="newton-lint prescribe",
        description="Search settings that keep the creep of a held body below a bound,"
        " and measure the best of them.",
    )
    parser.add_argument(
        "target", metavar="TARGET", help="FILE.xml, or FILE.py:function"
    )
    add_work(parser)
    parser.add_argument(
        "--fix",
        action="store_true",
        help="write the smallest change that reaches the bound into the files",
    )
    parser.set_defaults(turn=0.0)  # --hold predicts it, but it is not simulated here.
    options = parser.parse_args(arguments)
    if not options.hold:
        parser.error("prescribe needs --hold BODY")
    target = read_target(options.target)
    scene = scene_of(target, engine_of(options, {}))
    bound = options.below or BELOW_MM_S
    hold, trials = prescribed(scene, target, work_of(options), bound)
    print("\n".join(_table(trials, bound)))
    if trials[-1].measured_mm_s > bound:
        reason = (
            "slides because its load exceeds the friction of its contacts: increase μ"
            " or the grip force"
            if hold.slides
            else f"creeps: no setting that was tried keeps it below {bound:g} mm/s"
        )
        print(f"{options.hold} {reason}")
        return FOUND
    changes = changes_of(scene, trials[-1].setting, touched(scene, hold))
    print(
        "smallest change that reaches the bound:"
        if changes
        else "the scene reaches the bound without a change"
    )
    print("\n".join(f"  {change}" for change in changes))
    if options.fix:
        print("\n".join(fix(changes, scene.source, target)))
    return CLEAN


def prescribed(
    scene: Scene, target: Target, work: Work, bound_mm_s: float
) -> tuple[Hold, list[Trial]]:
    """Measure the slip of a held body, then of other settings, until one holds it."""
    if (hold := settled_hold(scene, target, work)) is None:
        raise TargetError(
            f"{target.name}: nothing touches {work.body}:"
            " raise --settle, or add a keyframe in which it is gripped"
        )
    trials = [measured(scene, target, work, Setting(), hold, hold.mm_s)]
    ranked = sorted(
        candidates(scene, hold, work),
        key=lambda candidate: _rank(candidate, bound_mm_s),
    )
    for setting, predicted in () if hold.slides else ranked:
        if len(trials) > MOST_TRIES or trials[-1].measured_mm_s <= bound_mm_s:
            break
        trials.append(measured(scene, target, work, setting, hold, predicted))
    return hold, trials


def candidates(scene: Scene, hold: Hold, work: Work) -> Iterator[tuple[Setting, float]]:
    """Yield settings with the creep that the law predicts for each."""
    option = scene.option
    stiffest = min(scene.model.geom_solref[geom, 0] for geom in touched(scene, hold))
    # getsolparam clamps shorter timeconsts to this.
    least = 2.0 * option.timestep_s if option.refsafe else 0.0
    most = stiffest if stiffest > 0.0 else np.inf
    timeconsts = [
        None,
        *(timeconst for timeconst in TIMECONSTS_S if least <= timeconst < most),
    ]
    noslips: list[dict[str, float]] = [{}]
    if not option.noslip and scene.engine.name == "mujoco":
        noslips.append({"noslip_iterations": NOSLIP})
    # With a pyramidal cone, impratio would harden the normal rows too.
    cone = {"cone": ELLIPTIC} if option.cone == "pyramidal" else {}
    ratios = [
        {},
        *(cone | {"impratio": ratio} for ratio in IMPRATIOS if ratio > option.impratio),
    ]
    for timeconst, ratio, noslip in itertools.product(timeconsts, ratios, noslips):
        setting = Setting(timeconst, ratio | noslip)
        if setting.change_count:
            variant = replace(scene, model=with_setting(scene, setting, hold))
            yield (
                setting,
                predicted_hold(variant, hold.body, hold.touches, work, hold.data).mm_s,
            )


def touched(scene: Scene, hold: Hold) -> list[int]:
    """Return the touching geoms whose parameters count."""
    geoms = {geom for touch in hold.touches for geom in touch.geoms if geom >= 0}
    return sorted(geom for geom in geoms if scene.counts[geom]) or sorted(geoms)


def with_setting(scene: Scene, setting: Setting, hold: Hold) -> MjModel:
    """Return a copy of the model that has a setting."""
    model = changed(scene.model, **setting.options)
    if setting.timeconst_s is not None:
        model.geom_solref[touched(scene, hold)] = (setting.timeconst_s, 1.0)
        pairs = scene.pair_indices
        named = [scene.contacts.named[pairs[touch.geoms]] for touch in hold.touches]
        model.pair_solref[[index for index in named if index >= 0]] = (
            setting.timeconst_s,
            1.0,
        )
    return model


def _rank(candidate: tuple[Setting, float], bound_mm_s: float) -> tuple:
    """Rank good settings by the number of changes, and the others by their creep."""
    setting, predicted = candidate
    is_good = predicted <= SAFETY * bound_mm_s
    changes = setting.change_count
    return (0, changes, -predicted) if is_good else (1, predicted, changes)


def measured(
    scene: Scene,
    target: Target,
    work: Work,
    setting: Setting,
    hold: Hold,
    predicted_mm_s: float,
) -> Trial:
    """Simulate a setting from the start and measure how fast the body creeps."""
    model = with_setting(scene, setting, hold)
    # In the frame of a hand that accelerates upward, gravity is larger.
    model.opt.gravity *= 1.0 + work.lift_m_s2 / max(
        np.linalg.norm(model.opt.gravity), 1e-9
    )
    data = started(model, target.data)
    settled(model, data, work.settle_s)
    return Trial(
        setting, predicted_mm_s, M * along(model, data, hold, MEASURED_S) / MEASURED_S
    )


def along(model: MjModel, data: MjData, hold: Hold, time_s: float) -> float:
    """Step the simulation, and return how far a held body slides on its support [m].

    Motion along the contact normal is sinking and does not count.
    """
    support = hold.touches[0].support
    normal = hold.touches[0].normal
    normal = hold.data.xmat[support].reshape(3, 3).T @ normal
    begin = within(data, hold.body, support)
    settled(model, data, time_s)
    moved = within(data, hold.body, support) - begin
    return np.linalg.norm(moved - (moved @ normal) * normal)


def within(data: MjData, body: int, support: int) -> np.ndarray:
    """Return the position of a body in the frame of another body [m]."""
    return data.xmat[support].reshape(3, 3).T @ (data.xipos[body] - data.xpos[support])


def changes_of(scene: Scene, setting: Setting, geoms: Sequence[int]) -> list[Change]:
    changes = [*for_option(scene, setting.attributes(), "").changes]
    if setting.timeconst_s is not None:
        solref = ("solref", f"{setting.timeconst_s:g} 1")
        changes += [
            Change(scene.names[geom], (solref,), scene.source.geom(geom))
            for geom in geoms
        ]
    return changes


def _table(trials: Sequence[Trial], bound_mm_s: float) -> Iterator[str]:
    heading = f"setting (bound {bound_mm_s:g} mm/s)"
    yield f"{'':2}{'predicted':>18}{'measured':>18}  {heading}"
    for trial in trials:
        predicted = (
            "slides" if np.isinf(trial.predicted_mm_s) else rated(trial.predicted_mm_s)
        )
        yield f"{'':2}{predicted:>18}{rated(trial.measured_mm_s):>18}  {trial.setting}"
