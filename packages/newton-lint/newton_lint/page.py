"""``newton-lint page``: a page of a scene, made with the figures and the stylesheet of measured-report."""

import argparse
import base64
import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from newton_lint.command import CLEAN, Parser, add_work, engine_of, positive, work_of
from newton_lint.findings import alike
from newton_lint.output import LEAST_MM_S, rated, sentence
from newton_lint.prediction import Load, predictions
from newton_lint.prescribe import BELOW_MM_S, Prescription, Trial, changes_of, prescribed, touched, with_setting
from newton_lint.report import Asked, Report, report_of, scene_of
from newton_lint.scene import Scene
from newton_lint.settle import Hold
from newton_lint.target import Target, TargetError, read_target

NEEDS_GENERATOR = "a page takes measured-report: pip install 'newton-lint[page]'"
MOST_BARS = 10
PICTURE = (480, 640)
"""Height and width of the scene's picture [px]."""


def main(arguments: Sequence[str]) -> int:
    about = "Write a page of a scene: what holds what, predicted creep, what was tried, and the findings."
    made = Parser(prog="newton-lint page", description=about)
    made.add_argument("target", metavar="TARGET", help="FILE.xml, or FILE.py:function that returns a model")
    made.add_argument("-o", "--out", type=Path, default=Path("page"), metavar="FOLDER", help="default: page")
    made.add_argument("--load", type=positive, default=1.0, metavar="N", help="on each contact point; default: 1")
    add_work(made)
    given = made.parse_args(arguments)
    target = read_target(given.target)
    if target.model is None:
        raise TargetError(f"{given.target}: is no model of MuJoCo's")
    written = write(target, given, given.out)
    print(written)
    return CLEAN


def write(target: Target, given: argparse.Namespace, folder: Path) -> Path:
    """Write the page of a scene into a folder, and return its file.

    Raises:
        TargetError: measured-report is not installed, or there is no such body.
    """
    try:
        import jinja2

        from measured_report.pages.prose import stylesheet
    except ImportError as error:
        raise TargetError(NEEDS_GENERATOR) from error
    engine, work = engine_of(given, {}), work_of(given)
    scene = scene_of(target, engine)
    bound = given.below or BELOW_MM_S
    found = prescribed(scene, target, work, bound) if work else None
    best = found.best(bound) if found else None
    load = found.hold.load_n / max(found.hold.point_count, 1.0) if found else given.load
    report = report_of(target, Asked(engine=engine, load=Load(load_n=load), work=work))
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "style.css").write_text(stylesheet(), encoding="utf-8")
    environment = jinja2.Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True)
    template = environment.from_string((Path(__file__).parent / "page.html.j2").read_text(encoding="utf-8"))
    pictures = {"bars": _pictures("bars", _bars, scene, report, best, found), "scene": _pictured(scene, target)}
    if found:
        pictures["tried"] = _pictures("trials", _trials, found, bound)
    text = template.render(
        report=report,
        groups=[(group[0], sentence(group)) for group in alike(report.findings)],
        hold=found and found.hold,
        touches=_touches(scene, found.hold) if found else (),
        trials=found.trials if found else (),
        changes=changes_of(scene, best.setting, touched(scene, found.hold)) if best else (),
        best=best,
        bound=bound,
        load=load,
        rated=rated,
        **pictures,
    )
    place = folder / "index.html"
    place.write_text(text, encoding="utf-8")
    return place


def _pictures(name: str, draw: Any, *given: Any) -> Any:
    from markupsafe import Markup

    from measured_report.parts.figures import draw_svgs

    return Markup("").join(draw_svgs(lambda: draw(*given), name=name))


def _bars(scene: Scene, report: Report, best: Trial | None, found: Prescription | None):
    from measured_report.parts.figures import fold, new_figure

    shown = [each for each in report.creep if each.load_mm_s[1] > 0.0][:MOST_BARS]
    drawing, axes = new_figure(height=1.5 + 0.5 * max(len(shown), 1))
    places = np.arange(len(shown))[::-1]
    sides = [("as it is", shown, 0.2, "")]
    if best and found:
        changed = replace(scene, model=with_setting(scene, best.setting, found.hold))
        after = {pair: each for each in predictions(changed, report.load) for pair in each.pairs}
        sides.append((str(best.setting), [after[each.pairs[0]] for each in shown], -0.2, "//"))
    for label, creeps, offset, hatch in sides:
        least, most = np.array([each.load_mm_s for each in creeps]).reshape(-1, 2).T
        error = [np.zeros(len(least)), most - least]
        axes.barh(places + offset, least, 0.36, xerr=error, ecolor="gray", label=fold(label), hatch=hatch)
    drawing.legend(loc="outside lower center", ncols=2)
    axes.set_yticks(places, [fold(" on ".join(each.pairs[0])) for each in shown])
    axes.set_xlabel(f"predicted creep under {report.load.load_n:.3g} N on a contact point [mm/s]")
    worst = shown[0] if shown else None
    axes.set_title(f"{worst.pairs[0][0]} creeps at {rated(worst.load_mm_s[0])} or more" if worst else "nothing creeps")
    return drawing


def _trials(found: Prescription, bound: float):
    from measured_report.parts.figures import fold, new_figure

    drawing, axes = new_figure(height=1.5 + 0.5 * len(found.trials))
    places = np.arange(len(found.trials))[::-1]
    for offset, label, values in (
        (0.2, "predicted", [trial.predicted_mm_s for trial in found.trials]),
        (-0.2, "measured", [trial.measured_mm_s for trial in found.trials]),
    ):
        told = [max(value, LEAST_MM_S) if np.isfinite(value) else 1e3 for value in values]
        axes.barh(places + offset, told, 0.36, label=label, hatch="" if offset > 0 else "//")
    axes.axvline(bound, linestyle="--", marker="", label=f"bound, {bound:g} mm/s")
    axes.set_xscale("log")
    axes.set_yticks(places, [fold(str(trial.setting)) for trial in found.trials])
    axes.set_xlabel("creep [mm/s]")
    good = sum(trial.measured_mm_s <= bound for trial in found.trials)
    axes.set_title(f"{good} of {len(found.trials)} settings keep {found.hold.name} below {bound:g} mm/s")
    drawing.legend(loc="outside lower center", ncols=3)
    return drawing


def _touches(scene: Scene, hold: Hold) -> list[tuple[str, str, str, str, str]]:
    rows: dict[tuple[int, int], list] = {}
    for touch in hold.touches:
        rows.setdefault(touch.geoms, []).append(touch)
    return [
        (
            " on ".join(scene.names[geom] for geom in geoms),
            f"{sum(touch.share for touch in touches):.3g}",
            f"{sum(touch.normal_n for touch in touches):.3g}",
            f"{np.linalg.norm(sum(touch.tangential_n for touch in touches)):.3g}",
            f"{max(touch.used for touch in touches):.0%}",
        )
        for geoms, touches in rows.items()
    ]


def _pictured(scene: Scene, target: Target) -> Any:
    """Render the scene with MuJoCo; empty where that can't be done."""
    from markupsafe import Markup

    try:
        image = _rendered(scene, target)
    except Exception:  # without a display or a library for one it fails in many ways
        return ""
    return Markup('<img alt="The scene" src="data:image/png;base64,{}">').format(base64.b64encode(image).decode())


def _rendered(scene: Scene, target: Target) -> bytes:
    import io

    import mujoco
    from matplotlib.image import imsave

    from newton_lint.settle import started

    if os.name == "posix" and not any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL")):
        raise RuntimeError("there is no display, and asking for one would end the process")
    data = started(scene.model, target.data)
    mujoco.mj_forward(scene.model, data)
    with mujoco.Renderer(scene.model, *PICTURE) as renderer:
        renderer.update_scene(data)
        buffer = io.BytesIO()
        imsave(buffer, renderer.render())
    return buffer.getvalue()
