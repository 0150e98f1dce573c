"""A Panda that picks up a small object: its scene, poses and motion; ``assets/panda.xml`` says whose robot it is."""

from collections.abc import Sequence

import numpy as np

from experiments.simulation.mjcf_engines import numbers
from measured_report.files.root import ROOT

SCENE = "assets/panda.xml"
OPEN_M = 0.04
"""How far each finger opens."""
READY = (0.0, 0.0, 0.0, -1.5708, 0.0, 1.5708, -0.7853)
AT_OBJECT = (-1.0104, 1.5623, 1.3601, -1.6840, -1.5863, 1.7810, 1.4598)
LIFTED = (-1.0426, 1.4028, 1.5634, -1.7114, -1.4055, 1.6015, 1.4510)
"""Poses of the arm [rad]."""
PHASES_S = (1.0, 2.0, 3.0, 4.0)
"""Ends of the motion over the object, of the one down to it, of closing and of lifting [s]."""
PAD_HEIGHT_M = 0.00825
"""Half the length of a pad along the finger."""
PAD_SOLREF, PAD_SOLIMP = (0.01, 1.0), (0.99, 0.995, 0.01)
"""As published; the solimp is the scene's."""


def mjcf(object_geom: str, option: str, *, pad_solref: Sequence[float] = PAD_SOLREF) -> str:
    """Write the robot, a floor and one free object, with attributes of the object's geom and of ``option``."""
    scene = (ROOT / SCENE).read_text(encoding="utf-8")
    return scene.format(object_geom=object_geom, option=option, pad_solref=numbers(pad_solref))


def command(time_s: float) -> np.ndarray:
    """Return the controls of arm and fingers while the object is picked up, and after it [rad, m], shape [8]."""
    over, down, closed, lifted = PHASES_S
    at = (0.0, over, down, closed, lifted)
    arm = [np.interp(time_s, at, joint) for joint in zip(READY, LIFTED, AT_OBJECT, AT_OBJECT, LIFTED, strict=True)]
    return np.array([*arm, np.interp(time_s, at, (OPEN_M, OPEN_M, OPEN_M, 0.0, 0.0))])
