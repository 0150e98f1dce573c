"""A pendulum's energy: how far each integrator lets it stray, though nothing brakes or drives it."""

import mujoco

from measured_report.measuring.measurement import Conditions, Measurement

MODEL = """
<mujoco>
  <option integrator="{integrator}" timestep="0.005"><flag energy="enable"/></option>
  <worldbody>
    <body>
      <joint type="hinge" axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -0.5" size="0.01" mass="1"/>
    </body>
  </worldbody>
</mujoco>
"""
START_RAD = 1.57
REPEAT_COUNT = 8
JITTER_RAD = 1e-4
"""How much farther each repeat is let go than the one before."""


def swing(integrator: str, start_rad: float, seconds: float) -> tuple[list[float], list[float]]:
    """Let the pendulum go at an angle from straight down; its times [s] and energies [J], step by step."""
    model = mujoco.MjModel.from_xml_string(MODEL.format(integrator=integrator))
    data = mujoco.MjData(model)
    data.qpos[0] = start_rad
    times, energies = [], []
    while data.time < seconds:
        times.append(data.time)
        mujoco.mj_step(model, data)
        energies.append(float(data.energy.sum()))  # at the time before the step
    return times, energies


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each integrator, and repeats of the first one, whose spread is the noise."""
    seconds = 2.0 if conditions.quick else 20.0
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
