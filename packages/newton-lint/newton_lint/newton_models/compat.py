"""Differences between Newton's releases."""

import newton

KF_RELEASE = (1, 5)
"""First release in which ``SolverMuJoCo`` reads ``ShapeConfig.kf``.

With an elliptic cone, kf gives the friction rows of Newton's contacts a timeconst of
their own, 2 / (kf w ((1 - dmax) / impratio + dmax)), where w is the sum of the bodies'
``body_invweight0``. A kf of 0 removes the friction, and a negative kf removes the
timeconst. MuJoCo's own contacts ignore kf in every release.
"""


def kf_is_read() -> bool:
    """Return whether the installed ``SolverMuJoCo`` reads ``ShapeConfig.kf``."""
    return tuple(map(int, newton.__version__.split(".")[:2])) >= KF_RELEASE
