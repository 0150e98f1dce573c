"""List the hands, the places of their models, and a grasp for each."""

import os
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from measured_report.editions.environment import python_with
from measured_report.files.errors import UsageError

MENAGERIE = "mujoco-menagerie==2026.10.4"
DOWN = (0.0, 1.0, 0.0, 0.0)  # turns z, along the fingers of most hands, downwards


@dataclass(frozen=True)
class Hand:
    """Describe a hand and a grasp, which suits all objects."""

    name: str
    model: str  # its folder in MuJoCo Menagerie
    tree: str  # git's hash of this folder, shortened as the package does
    entry: str
    at_m: tuple[float, float, float]  # the object before the hand closes
    closed: Mapping[str, float]  # controls of actuators by name; others are 0
    open: Mapping[str, float] = field(default_factory=dict)
    """Positions of joints that are not 0 before the hand closes [rad, m]."""
    body: str = ""  # the hand as a part of a robot
    turn: tuple[float, float, float, float] = DOWN

    def mjcf(self) -> Path:
        """Return the file of the model, which is downloaded if it is missing.

        Raises:
            UsageError: The model is missing and cannot be downloaded.
        """
        cache = os.environ.get("MENAGERIE_CACHE_DIR", "~/.cache/mujoco_menagerie")
        root = Path(cache).expanduser()
        folder = root / "models" / f"{self.model}-{self.tree}"
        if not (folder / ".complete").is_file():
            done = subprocess.run(
                [
                    python_with("menagerie", [MENAGERIE]),
                    "-m",
                    "mujoco_menagerie",
                    "prefetch",
                    self.model,
                ],
                env=os.environ | {"MENAGERIE_CACHE_DIR": str(root)},
                capture_output=True,
                check=False,
            )
            if done.returncode:
                raise UsageError(f"{MENAGERIE} cannot download {self.model}")
        return folder / f"{self.entry}.xml"


HANDS = (
    Hand(
        "franka",
        "franka_emika_panda",
        "3d2262eeb81ecec1",
        "hand",
        at_m=(0.0, 0.0, -0.103),
        closed={"actuator8": 0.0},
    ),
    Hand(
        "robotiq",
        "robotiq_2f85",
        "3c3ba06388c18961",
        "2f85",
        at_m=(0.0, 0.0, -0.148),
        closed={"fingers_actuator": 255.0},
    ),
    Hand(
        "robotiq-v4",
        "robotiq_2f85_v4",
        "d6c34a7e5192fad4",
        "2f85",
        at_m=(0.0, 0.0, -0.148),
        closed={"fingers_actuator": 255.0},
    ),
    Hand(
        "xarm",
        "ufactory_xarm7",
        "16cfe120310f44c0",
        "hand",
        at_m=(0.0, 0.0, -0.148),
        closed={"fingers_actuator": 255.0},
    ),
    Hand(
        "umi",
        "umi_gripper",
        "c906d8c87d1ac659",
        "umi_gripper",
        at_m=(0.0, 0.0, -0.175),
        closed={"fingers_actuator": 0.05},
    ),
    Hand(
        "so-arm100",
        "trs_so_arm100",
        "1214e62ef659a338",
        "so_arm100",
        body="Fixed_Jaw",
        turn=(0.70710678, 0.70710678, 0.0, 0.0),
        at_m=(0.0, 0.005, -0.075),
        open={"Jaw": 1.0},
        closed={"Jaw": -0.17},
    ),
    Hand(
        "viperx",
        "trossen_vx300s",
        "659ff3e33ef9b996",
        "vx300s",
        body="gripper_link",
        turn=(0.70710678, 0.0, 0.70710678, 0.0),
        at_m=(0.0, 0.0, -0.12),
        open={"left_finger": 0.057, "right_finger": -0.057},
        closed={"gripper": 0.021},
    ),
    Hand(
        "allegro",
        "wonik_allegro",
        "42564d556620bc0c",
        "right_hand",
        at_m=(0.039, -0.013, 0.019),
        closed={
            **dict.fromkeys(("ffa1", "mfa1", "rfa1"), 1.5),
            **dict.fromkeys(("ffa2", "mfa2", "rfa2"), 1.66),
            **dict.fromkeys(("ffa3", "mfa3", "rfa3"), 0.56),
            "tha0": 1.02,
            "tha1": 0.4,
            "tha2": 1.46,
            "tha3": 1.16,
        },
    ),
    Hand(
        "leap",
        "leap_hand",
        "efe8f001e555cc08",
        "right_hand",
        at_m=(-0.063, 0.046, 0.083),
        closed={
            **dict.fromkeys(("if_mcp_act", "mf_mcp_act", "rf_mcp_act"), 1.46),
            **dict.fromkeys(("if_pip_act", "mf_pip_act", "rf_pip_act"), 1.2),
            **dict.fromkeys(("if_dip_act", "mf_dip_act", "rf_dip_act"), 0.53),
            "th_cmc_act": 1.57,
            "th_axl_act": 1.54,
            "th_mcp_act": 0.58,
            "th_ipl_act": 1.63,
        },
    ),
    Hand(
        "shadow",
        "shadow_hand",
        "8f85903630df9e07",
        "right_hand",
        at_m=(0.037, -0.017, -0.356),
        closed={
            **{f"rh_A_{finger}J3": 0.2 for finger in ("FF", "MF", "RF", "LF")},
            **{f"rh_A_{finger}J0": 3.06 for finger in ("FF", "MF", "RF", "LF")},
            "rh_A_THJ5": 0.79,
            "rh_A_THJ4": 0.81,
            "rh_A_THJ2": 0.69,
            "rh_A_THJ1": 1.12,
        },
    ),
)
