"""Warnings of MuJoCo's C engine after which nothing that a run shows is a measurement."""

import mujoco

BAD_STATE = (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL, mujoco.mjtWarning.mjWARN_BADQACC)
"""Warnings after which MuJoCo has put the state back to the beginning."""
FULL = (mujoco.mjtWarning.mjWARN_CONTACTFULL, mujoco.mjtWarning.mjWARN_CNSTRFULL)
REASONS = {BAD_STATE: "MuJoCo found its state unusable and reset it", FULL: "MuJoCo had no room for all contacts"}


class RunFailed(Exception):
    """A run that gives no numbers; its text is the reason."""


def refuse_warned(data: mujoco.MjData) -> None:
    """Let no run go on that the engine has warned of.

    Raises:
        RunFailed: It has.
    """
    for kinds, reason in REASONS.items():
        if any(data.warning[kind].number for kind in kinds):
            raise RunFailed(reason)
