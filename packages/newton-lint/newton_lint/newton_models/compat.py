"""Where Newton's releases differ."""

import newton

KF_RELEASE = (1, 5)
"""From this release on ``SolverMuJoCo`` reads ``ShapeConfig.kf``: with an elliptic cone it gives the friction rows of
Newton's contacts a timeconst of their own, 2 / (kf w ((1 - dmax) / impratio + dmax)), where w is the sum of the bodies'
``body_invweight0``. kf = 0 takes the friction away, and a negative one the timeconst. MuJoCo's own contacts have none
in any release."""


def kf_is_read() -> bool:
    """Tell whether ``SolverMuJoCo`` of the installed release reads ``ShapeConfig.kf``."""
    return tuple(map(int, newton.__version__.split(".")[:2])) >= KF_RELEASE
