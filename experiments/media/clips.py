"""Draw the clips and the long exposure: two kept runs side by side.

The runs are synchronous, and their displacements are shown.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.ticker import MaxNLocator
from PIL import Image

from experiments.facts.kept import TCP, KeptRun
from experiments.media.stage import CUBE, START, Camera, Stage, display

FRAME_RATE = 30
WIDTH, HEIGHT = 1280, 720
HEAD = 92  # height of the line with the names and the numbers [pixels]
PANEL_HEIGHT = 448
"""Height of a run's picture [pixels].

Both pictures are at the bottom, so that the controls of a player cover only the ground.
"""
GAP = 2  # half the space between the two pictures [pixels]
LEAD_S = 2.5  # time before the shake at which a clip begins [s]
# Time in which the camera approaches [s]. It arrives at the start of the shake.
APPROACH_S = 1.2
# Time after a cube has left the grasp [s], in which the camera moves back to show where
# it fell.
FALL_S = 4.0
STAY_S = 1.0  # time for which the last picture is shown [s]
ENCODER = {"crf": "28", "preset": "veryslow", "threads": "2"}
JPEG_QUALITY = 85

INK, SOFT, GRID, STRIP = "#f2f4f6", "#aab4be", "#3d444c", "#14171a"
# Colours of the two runs in text and curves, from the page's dark theme.
COLOURS = (
    "#f59a5f",
    "#6db3f2",
)
CUBE_RGB = ((0.87, 0.37, 0.08), (0.10, 0.45, 0.82))  # colours of their cubes

WIDE = ((1.10, -1.75, 0.86), (-0.20, -0.45, 0.31), 27.0)
"""Eye, target and vertical field of view [°] that show the whole arm, in the world."""
CLOSE = ((0.19, -0.30, 0.075), (0.0, 0.0, 0.001), 18.5)
"""Eye, target and field of view that show the grasp, relative to the TCP.

The camera moves with the hand.
"""

# Size of the long exposure [pixels], as required for link previews.
STILL = (
    1200,
    630,
)
# View that the long exposure shows, relative to the TCP.
STILL_VIEW = (
    (0.15, -0.35, 0.075),
    (0.010, 0.0, 0.004),
    14.5,
)
MAGNIFIED = 5


@dataclass(frozen=True)
class Clip:
    """Two runs, from which the contents of each frame of their clip are computed."""

    runs: tuple[KeptRun, KeptRun]
    names: tuple[str, str]

    @property
    def fall_s(self) -> float:
        """Return the time at which the first cube leaves the grasp [s], or infinity."""
        return min(
            np.inf if run.left_grasp_s is None else run.left_grasp_s
            for run in self.runs
        )

    @cached_property
    def frames(self) -> np.ndarray:
        """Return the index of the kept frame for each frame of the clip.

        The last one is repeated.
        """
        time_s = self.runs[0].time_s
        step = round(1.0 / (FRAME_RATE * (time_s[1] - time_s[0])))
        last = int(np.searchsorted(time_s, self.fall_s + FALL_S)) - 1
        moving = np.arange(last, np.argmax(time_s >= -LEAD_S), -step)[::-1]
        return np.append(moving, np.full(round(STAY_S * FRAME_RATE), last))

    def readout(self) -> dict[str, np.ndarray]:
        """Return the time since the shake began and the displacements.

        A displacement is NaN before the shake and after the cube has left the grasp.
        """
        found = {"time_s": self.runs[0].time_s[self.frames]}
        for name, run in zip(self.names, self.runs, strict=True):
            found[f"{name}_mm"] = np.where(run.in_grasp(), run.slip_mm, np.nan)[
                self.frames
            ]
        return found

    def camera(self, frame: int) -> Camera:
        """Return the view at a kept frame.

        It shows the whole arm, then moves with the hand, and shows the whole arm again
        after a cube has fallen.
        """
        run = self.runs[0]
        time_s = run.time_s[frame]
        near = _smooth(1.0 + time_s / APPROACH_S) * _smooth(
            1.0 - (time_s - self.fall_s) / APPROACH_S
        )
        hand = run.links[TCP][frame, :3, 3]
        (wide_eye, wide_target, wide_deg), (eye, target, deg) = WIDE, CLOSE
        return Camera(
            eye=(1.0 - near) * np.array(wide_eye) + near * (hand + eye),
            target=(1.0 - near) * np.array(wide_target) + near * (hand + target),
            height_deg=wide_deg * (deg / wide_deg) ** near,
        )


def _smooth(share: float) -> float:
    share = np.clip(share, 0.0, 1.0)
    return float(share * share * (3.0 - 2.0 * share))


def pictures(clip: Clip, device: str) -> Iterator[np.ndarray]:
    """Return the frames of a clip, shape [HEIGHT, WIDTH, 3], 8 bits.

    They show two panels below names, numbers and a growing plot.
    """
    stage = Stage(CUBE_RGB, clip.runs[0].cube_edge_m, device)
    readout, sheet = clip.readout(), Sheet(WIDTH, HEIGHT, HEIGHT - PANEL_HEIGHT)
    axes = plot_axes(sheet, readout)
    style = {
        "linewidth": 4,
        "marker": "o",
        "markersize": 11,
        "markevery": [-1],
        "clip_on": False,
    }
    labels = [
        sheet.name_panel(*item)
        for item in zip(range(2), clip.names, COLOURS, strict=True)
    ]
    curves = [axes.plot([], [], color=colour, **style)[0] for colour in COLOURS]
    picture = None
    for number, frame in enumerate(clip.frames):
        if number == 0 or frame != clip.frames[number - 1]:
            stage.place([bodies(run, frame) for run in clip.runs])
            panels = display(
                stage.picture(clip.camera(frame), WIDTH // 2, PANEL_HEIGHT)
            )
            time_s = readout["time_s"][: number + 1]
            for name, label, curve in zip(clip.names, labels, curves, strict=True):
                values = readout[f"{name}_mm"][: number + 1]
                label.set_text(reading(values[-1]) if time_s[-1] >= 0.0 else "")
                curve.set_data(time_s, values)
            picture = sheet.on(panels)
        yield picture


def plot_axes(sheet: "Sheet", readout: Mapping[str, np.ndarray]) -> Axes:
    """Return the axes above the panels, scaled for all displacements."""
    bottom, height = (
        (PANEL_HEIGHT + 46) / HEIGHT,
        (HEIGHT - PANEL_HEIGHT - HEAD - 46) / HEIGHT,
    )
    axes = sheet.figure.add_axes((0.1, bottom, 0.875, height), facecolor="none")
    axes.set_xlim(0.0, readout["time_s"][-1] * 1.015)
    axes.set_ylim(
        0.0,
        1.2
        * max(
            np.nanmax(values) for name, values in readout.items() if name != "time_s"
        ),
    )
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=(1, 2, 5, 10)))
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=(1, 2, 5, 10)))
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g} s" if value else "")
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g} mm" if value else "0")
    axes.text(
        0.01,
        0.94,
        "displacement in the grasp",
        transform=axes.transAxes,
        color=SOFT,
        fontsize=19,
        va="top",
    )
    axes.tick_params(colors=SOFT, labelsize=19, length=0, pad=6)
    axes.grid(color=GRID, linewidth=1)
    for side, spine in axes.spines.items():
        spine.set(visible=side == "bottom", color=SOFT)
    return axes


def write_video(path: Path, frames: Iterable[np.ndarray]) -> np.ndarray:
    """Encode the frames as an H.264 video in MP4 and return the last frame.

    The frames have the shape [HEIGHT, WIDTH, 3], 8 bits. The video can be played while
    it loads.
    """
    import av  # only needed to make clips

    with av.open(
        path, "w", format="mp4", options={"movflags": "+faststart"}
    ) as container:
        stream = container.add_stream("libx264", rate=FRAME_RATE, options=ENCODER)
        stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, "yuv420p"
        for frame in frames:
            container.mux(
                stream.encode(av.VideoFrame.from_ndarray(frame, format="rgb24"))
            )
        container.mux(stream.encode())
    return frame


def write_image(path: Path, picture: np.ndarray) -> None:
    """Write a picture as JPEG, shape [height, width, 3], 8 bits."""
    Image.fromarray(picture).save(
        path, format="JPEG", quality=JPEG_QUALITY, optimize=True, progressive=True
    )


def bodies(run: KeptRun, frame: int) -> dict[str, np.ndarray]:
    """Return the poses of all bodies at a frame.

    The edges that mark the cube's start are included after the shake has begun.
    """
    found = {name: poses[frame] for name, poses in run.links.items()} | {
        CUBE: run.cube[frame]
    }
    return found | ({START: run.start[frame]} if run.time_s[frame] >= 0.0 else {})


class Sheet:
    """Compose a picture of two panels with text above them and other drawings."""

    def __init__(self, width: int, height: int, top: int):
        self.width, self.height, self.top = width, height, top
        self.figure = Figure(
            figsize=(width / 100, height / 100), dpi=100, facecolor="none"
        )
        self.canvas = FigureCanvasAgg(self.figure)

    def write(
        self, left: float, top: float, text: str, size: float, colour: str, **style
    ) -> Text:
        """Return a text of ``size`` whose baseline begins at a position [pixels]."""
        place = left / self.width, 1.0 - top / self.height
        return self.figure.text(
            *place, text, fontsize=0.72 * size, color=colour, **style
        )

    def name_panel(self, number: int, name: str, colour: str) -> Text:
        """Write a run's name above its panel and return the text for its number."""
        left = number * self.width / 2 + 26
        self.write(left, HEAD - 26, name.replace("-", " "), 40, INK)
        return self.write(left + 240, HEAD - 26, "", 58, colour, weight="bold")

    def on(self, panels: np.ndarray) -> np.ndarray:
        """Return the whole picture, shape [height, width, 3], 8 bits.

        Args:
            panels: The two panels, shape [2, PANEL_HEIGHT, width / 2, 3], from 0 to 1.
        """
        self.canvas.draw()
        drawn = np.asarray(self.canvas.buffer_rgba()) / 255.0
        below = np.tile(np.array(to_rgb(STRIP)), (self.height, self.width, 1))
        rows = slice(self.top, self.top + PANEL_HEIGHT)
        below[rows] = np.concatenate(list(panels), axis=1)
        below[rows, self.width // 2 - GAP : self.width // 2 + GAP] = to_rgb(STRIP)
        opacity = drawn[..., 3:]
        return (
            255 * (opacity * drawn[..., :3] + (1.0 - opacity) * below) + 0.5
        ).astype(np.uint8)


def reading(slip_mm: float) -> str:
    """Return the text that shows a displacement."""
    return "fell out" if np.isnan(slip_mm) else f"{slip_mm:.2f} mm"


def long_exposure(clip: Clip, frequency_hz: float, device: str) -> np.ndarray:
    """Return a picture with several positions of the cube.

    It shows the hand at the start of the shake. The cube is shown at that time, and in
    every second cycle back from the last frame. Displacements are MAGNIFIED. The shape
    is [STILL height, STILL width, 3], 8 bits.
    """
    stage = Stage(CUBE_RGB, clip.runs[0].cube_edge_m, device)
    first = clip.runs[0]
    times = np.append(np.arange(first.time_s[-1], 0.0, -2.0 / frequency_hz), 0.0)[::-1]
    start = first.shake_start
    hand = first.links[TCP][start, :3, 3]
    eye, target, deg = STILL_VIEW
    camera = Camera(hand + eye, hand + target, deg)
    exposures = []
    for frame in np.searchsorted(first.time_s, times - 1e-9):
        stage.place([_magnified(run, start, frame) for run in clip.runs])
        exposures.append(stage.picture(camera, STILL[0] // 2, PANEL_HEIGHT))
    # Only averaging would make the edges of each exposure too faint.
    picture = 0.5 * np.mean(exposures, axis=0) + 0.5 * np.max(exposures, axis=0)
    sheet = Sheet(*STILL, HEAD)
    for number, (name, run, colour) in enumerate(
        zip(clip.names, clip.runs, COLOURS, strict=True)
    ):
        sheet.name_panel(number, name, colour).set_text(reading(run.slip_mm[-1]))
    words = f"The cube every second cycle, its displacement drawn ×{MAGNIFIED}"
    sheet.write(26, STILL[1] - 32, words, 34, SOFT)
    return sheet.on(display(picture))


def _magnified(run: KeptRun, start: int, frame: int) -> dict[str, np.ndarray]:
    in_hand = run.cube_in_hand[frame].copy()
    origin = run.begin_in_hand[:3, 3]
    in_hand[:3, 3] = origin + MAGNIFIED * (in_hand[:3, 3] - origin)
    cube = run.links[TCP][start] @ in_hand
    return {name: poses[start] for name, poses in run.links.items()} | {
        CUBE: cube,
        START: cube,
    }
