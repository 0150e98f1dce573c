"""Run time of a frame at each time step, in one world and in many."""

from report.shared import (
    TIMED_WORLDS,
    Claim,
    Results,
    RowsBy,
    Section,
    at_most,
    combined,
    constant,
    resolution,
    table_of,
    worlds_name,
)

order = 127
page = "step"
label = "run time at each step"

SETTINGS = {
    "stiff": "Newton's contacts, elliptic cone",
    "pyramidal": "Newton's contacts, pyramidal cone",
    "mujoco": "MuJoCo's contacts, elliptic cone",
    "mujoco-pyramidal": "MuJoCo's contacts, pyramidal cone",
    "cure": "the root cure",
    "rk4": "RK4",
}


def derive(results: Results) -> Section:
    return Section()
