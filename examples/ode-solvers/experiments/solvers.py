"""Measure error and run time of SciPy's ODE solvers on an orbit that closes."""

import time
from itertools import product

import numpy as np
from scipy.integrate import solve_ivp

SOLVERS = ("RK45", "DOP853", "LSODA", "Radau")
TOLERANCES = ("1e-3", "1e-5", "1e-7", "1e-9")
START = np.array([0.4, 0.0, 0.0, 2.0])  # an ellipse with semi-major axis 1 m
END = 6 * np.pi  # three periods [s]


def rate(seconds: float, state: np.ndarray) -> np.ndarray:
    """Return velocity and acceleration of a body that orbits a mass of G M = 1 m³/s²."""
    return np.concatenate([state[2:], -state[:2] / np.hypot(*state[:2]) ** 3])


def orbit(solver: str, tolerance: str) -> tuple[float, float]:
    """Return the distance from the start after whole periods [m], and the CPU time [ms]."""
    accuracy = {"rtol": float(tolerance), "atol": float(tolerance)}
    began = time.process_time()
    solution = solve_ivp(rate, (0.0, END), START, solver, **accuracy)
    run_ms = 1e3 * (time.process_time() - began)
    return float(np.hypot(*(solution.y[:2, -1] - START[:2]))), run_ms


def measure(conditions) -> list[dict]:
    orbit("LSODA", "1e-3")  # the first run is slower than all others
    rows = []
    # All cases run in turn, so that a slow minute of the machine affects all of them.
    for run, *case in product(
        range(2 if conditions.quick else 11), SOLVERS, TOLERANCES
    ):
        name = "-".join(case)
        repeats = {"case": f"{name}-{run}", "of": name} if run else {"case": name}
        error_m, run_ms = orbit(*case)
        rows.append(
            {**repeats, "solver": case[0], "error_m": error_m, "run_ms": run_ms}
        )
    return rows
