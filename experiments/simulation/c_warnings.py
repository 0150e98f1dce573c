"""What MuJoCo's C engine warns of and then goes on from: nothing that such a run shows is a measurement."""

import mujoco

from experiments.facts.trace import Failure

_KINDS = mujoco.mjtWarning
_RESET = "non-finite", "MuJoCo found its state unusable and reset it"
FAILURES = {
    _KINDS.mjWARN_BADQPOS: _RESET,
    _KINDS.mjWARN_BADQVEL: _RESET,
    _KINDS.mjWARN_BADQACC: _RESET,
    _KINDS.mjWARN_CONTACTFULL: ("overflow", "the contact buffer overflowed"),
    _KINDS.mjWARN_CNSTRFULL: ("overflow", "the constraint buffer overflowed"),
}
"""Kind and reason of the failure, by the warning; a state that is reset is finite again, and shows nothing of it."""


class RunFailed(Exception):
    """A run that gives no numbers; its text is the reason."""


def failure_of(data: mujoco.MjData, frame: int) -> Failure | None:
    """Return what the engine has warned of by frame ``frame``."""
    reason = next(
        (failure for kind, failure in FAILURES.items() if data.warning[kind].number),
        None,
    )
    return Failure(reason[0], frame, reason[1]) if reason else None


def refuse_warned(data: mujoco.MjData) -> None:
    """Let no run go on that the engine has warned of.

    Raises:
        RunFailed: It has.
    """
    if failure := failure_of(data, 0):
        raise RunFailed(failure.detail)
