"""What MuJoCo's C engine warns of and then goes on from: a run that it warns in counts for nothing."""

from dataclasses import replace

import mujoco

from experiments.trace import Failure

_KINDS = mujoco.mjtWarning
_RESET = Failure("non-finite", 0, "MuJoCo found its state unusable and reset it")
FAILURES = {
    _KINDS.mjWARN_BADQPOS: _RESET,
    _KINDS.mjWARN_BADQVEL: _RESET,
    _KINDS.mjWARN_BADQACC: _RESET,
    _KINDS.mjWARN_CONTACTFULL: Failure("overflow", 0, "the contact buffer overflowed"),
    _KINDS.mjWARN_CNSTRFULL: Failure("overflow", 0, "the constraint buffer overflowed"),
}
"""By the warning; a state that is reset is finite again, and shows nothing of it."""


def failure_of(data: mujoco.MjData, frame: int) -> Failure | None:
    """What has gone wrong by frame ``frame``."""
    found = next((failure for kind, failure in FAILURES.items() if data.warning[kind].number), None)
    return found and replace(found, frame=frame)
