"""Measure the energy error of integrators for a pendulum without friction or drive."""

import numpy as np

from measured_report.measuring.measurement import Conditions, Measurement

STEP_S = 0.001
START_RAD = 1.57
REPEAT_COUNT = 8
JITTER_RAD = 1e-4  # the step between the start angles of the repeats


def euler(rate, state: np.ndarray) -> np.ndarray:
    """Return the state after one step with the rate of change at its start."""
    return state + STEP_S * rate(state)


def rk4(rate, state: np.ndarray) -> np.ndarray:
    """Return the state after one Runge-Kutta step, which uses four rates of change."""
    first = rate(state)
    second = rate(state + STEP_S / 2 * first)
    third = rate(state + STEP_S / 2 * second)
    last = rate(state + STEP_S * third)
    return state + STEP_S / 6 * (first + 2 * second + 2 * third + last)


INTEGRATORS = {"Euler": euler, "RK4": rk4}


def rate(state: np.ndarray) -> np.ndarray:
    """Return the derivatives of the angle [rad] and the speed of a rod of 0.5 m on a
    hinge.
    """
    return np.array([state[1], -1.5 * 9.81 / 0.5 * np.sin(state[0])])


def swing(
    integrator: str, start_rad: float, seconds: float
) -> tuple[list[float], list[float]]:
    """Return times [s] and energies [J] of a swinging 1 kg rod at each step.

    The rod starts at rest, at an angle from straight down.
    """
    times = [STEP_S * count for count in range(round(seconds / STEP_S))]
    energies = []
    state = np.array([start_rad, 0.0])
    for _ in times:
        angle, speed = state
        kinetic = (0.5 * speed) ** 2 / 6
        energies.append(float(kinetic + 9.81 * 0.25 * (1 - np.cos(angle))))
        state = INTEGRATORS[integrator](rate, state)
    return times, energies


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each integrator, and repeats of the first one.

    The scatter of the repeats is the noise.
    """
    seconds = 0.5 if conditions.quick else 2.0
    runs = [("euler", "Euler", 0.0), ("rk4", "RK4", 0.0)]
    runs += [(f"repeat-{n}", "Euler", n * JITTER_RAD) for n in range(REPEAT_COUNT)]
    rows = []
    traces = {}
    for case, integrator, jitter in runs:
        times, energies = swing(integrator, START_RAD + jitter, seconds)
        changes = [1e3 * (energy - energies[0]) for energy in energies]
        row = {"case": case, "integrator": integrator, "duration_s": seconds}
        row["energy_error_mj"] = max(map(abs, changes))
        if case.startswith("repeat"):
            row["of"] = "euler"
        else:
            traces[case] = {"time_s": times, "energy_change_mj": changes}
        rows.append(row)
    return Measurement(rows, traces)
