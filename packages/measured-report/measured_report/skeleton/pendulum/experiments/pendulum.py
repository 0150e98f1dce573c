"""A pendulum's energy: how far each integrator lets it stray, though nothing brakes or drives it."""

from collections.abc import Callable

import numpy as np

from measured_report.measuring.measurement import Conditions, Measurement

GRAVITY_M_S2, STEP_S = 9.81, 0.001
LENGTH_M, MASS_KG = 0.5, 1.0
"""Of the rod, which swings about one end."""
START_RAD = 1.57
REPEAT_COUNT = 8
JITTER_RAD = 1e-4
"""How much farther each repeat is let go than the one before."""
Rate = Callable[[np.ndarray], np.ndarray]


def euler(rate: Rate, state: np.ndarray) -> np.ndarray:
    """Make one step with the rate of change at its start."""
    return state + STEP_S * rate(state)


def rk4(rate: Rate, state: np.ndarray) -> np.ndarray:
    """Make one step with four rates, by Runge and Kutta."""
    first = rate(state)
    second = rate(state + STEP_S / 2 * first)
    third = rate(state + STEP_S / 2 * second)
    last = rate(state + STEP_S * third)
    return state + STEP_S / 6 * (first + 2 * second + 2 * third + last)


def _rate(state: np.ndarray) -> np.ndarray:
    """Return how fast angle and speed of the rod change."""
    return np.array([state[1], -1.5 * GRAVITY_M_S2 / LENGTH_M * np.sin(state[0])])


INTEGRATORS = {"Euler": euler, "RK4": rk4}


def swing(integrator: str, start_rad: float, seconds: float) -> tuple[list[float], list[float]]:
    """Let the pendulum go at an angle from straight down; its times [s] and energies [J], step by step."""
    times = [STEP_S * count for count in range(round(seconds / STEP_S))]
    state, energies = np.array([start_rad, 0.0]), []  # angle and speed
    for _ in times:
        moving = MASS_KG * (LENGTH_M * state[1]) ** 2 / 6
        energies.append(float(moving + MASS_KG * GRAVITY_M_S2 * LENGTH_M / 2 * (1 - np.cos(state[0]))))
        state = INTEGRATORS[integrator](_rate, state)
    return times, energies


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each integrator, and repeats of the first one, whose spread is the noise."""
    seconds = 1.0 if conditions.quick else 10.0
    runs = [("euler", "Euler", 0.0, {}), ("rk4", "RK4", 0.0, {})]
    runs += [(f"repeat-{n}", "Euler", n * JITTER_RAD, {"of": "euler"}) for n in range(REPEAT_COUNT)]
    rows, traces = [], {}
    for case, integrator, jitter, said in runs:
        times, energies = swing(integrator, START_RAD + jitter, seconds)
        error = max(abs(energy - energies[0]) for energy in energies)
        rows.append(
            {"case": case, **said, "integrator": integrator, "duration_s": seconds, "energy_error_mj": 1e3 * error}
        )
        if not said:
            changes = [1e3 * (energy - energies[0]) for energy in energies]
            traces[case] = {"time_s": times, "energy_change_mj": changes}
    return Measurement(rows, traces)
