"""A pendulum's energy: how far each integrator lets it stray, though nothing brakes or drives it."""

import numpy as np

from measured_report.measuring.measurement import Conditions, Measurement

STEP_S, START_RAD = 0.001, 1.57
REPEAT_COUNT, JITTER_RAD = (
    8,
    1e-4,
)  # each repeat is let go so much farther than the one before


def euler(rate, state: np.ndarray) -> np.ndarray:
    """Make one step with the rate of change at its start."""
    return state + STEP_S * rate(state)


def rk4(rate, state: np.ndarray) -> np.ndarray:
    """Make one step with four rates, by Runge and Kutta."""
    first = rate(state)
    second = rate(state + STEP_S / 2 * first)
    third = rate(state + STEP_S / 2 * second)
    last = rate(state + STEP_S * third)
    return state + STEP_S / 6 * (first + 2 * second + 2 * third + last)


INTEGRATORS = {"Euler": euler, "RK4": rk4}


def rate(state: np.ndarray) -> np.ndarray:
    """Return how fast angle [rad] and speed change of a rod of 0.5 m that swings about one end."""
    return np.array([state[1], -1.5 * 9.81 / 0.5 * np.sin(state[0])])


def swing(
    integrator: str, start_rad: float, seconds: float
) -> tuple[list[float], list[float]]:
    """Let the rod, of 1 kg, go at an angle from straight down; its times [s] and energies [J], step by step."""
    times, energies = [STEP_S * count for count in range(round(seconds / STEP_S))], []
    state = np.array([start_rad, 0.0])
    for _ in times:
        energies.append(
            float((0.5 * state[1]) ** 2 / 6 + 9.81 * 0.25 * (1 - np.cos(state[0])))
        )
        state = INTEGRATORS[integrator](rate, state)
    return times, energies


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each integrator, and repeats of the first one, whose spread is the noise."""
    seconds = 0.5 if conditions.quick else 2.0
    runs = [("euler", "Euler", 0.0, {}), ("rk4", "RK4", 0.0, {})]
    runs += [
        (f"repeat-{n}", "Euler", n * JITTER_RAD, {"of": "euler"})
        for n in range(REPEAT_COUNT)
    ]
    rows, traces = [], {}
    for case, name, jitter, said in runs:
        times, energies = swing(name, START_RAD + jitter, seconds)
        changes = [1e3 * (energy - energies[0]) for energy in energies]
        error = max(map(abs, changes))
        rows.append(
            {
                "case": case,
                **said,
                "integrator": name,
                "duration_s": seconds,
                "energy_error_mj": error,
            }
        )
        if not said:
            traces[case] = {"time_s": times, "energy_change_mj": changes}
    return Measurement(rows, traces)
