"""Make warnings of MuJoCo's C engine count as failures.

The engine continues after these warnings, but the results are no longer valid.
"""

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
"""Kind and reason of the failure for each warning.

A state that was reset is finite again, so that only the warning shows the failure.
"""


class RunFailed(Exception):
    """Signal a run without valid numbers; the text is the reason."""


def failure_of(data: mujoco.MjData, frame: int) -> Failure | None:
    """Return the failure that a warning of the engine has shown until ``frame``, if
    any.
    """
    reason = next(
        (failure for kind, failure in FAILURES.items() if data.warning[kind].number),
        None,
    )
    return Failure(reason[0], frame, reason[1]) if reason else None


def refuse_warned(data: mujoco.MjData) -> None:
    """Raise an error if the engine has warned of a failure.

    Raises:
        RunFailed: The engine has raised a warning.
    """
    if failure := failure_of(data, 0):
        raise RunFailed(failure.detail)
