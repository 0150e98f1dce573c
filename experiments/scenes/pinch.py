"""Define the pinched capsule that ends between the pads, for engines without MJCF."""

from experiments.cure.turntable import SAMPLE_S
from experiments.drivers.scene import Body, Scene, Support
from experiments.scenes import capsule

# Force of each pad, as in the publication of the pinched capsule.
PRESS_N = 12.0
CAPSULE = capsule.Pinch("within-pads", half_length_m=0.02)
ACROSS = capsule.MASS_KG * (capsule.RADIUS_M**2 / 4.0 + CAPSULE.half_length_m**2 / 3.0)
HELD = Body(
    mass_kg=capsule.MASS_KG,
    inertia_kg_m2=[ACROSS, capsule.MASS_KG * capsule.RADIUS_M**2 / 2.0, ACROSS],
    foot_m=capsule.RADIUS_M,
    feet=[(0.0, end * CAPSULE.half_length_m, 0.0) for end in (-1.0, 1.0)],
)


def pad(side: float) -> Support:
    size = capsule.PAD_HALF_SIZE_M
    return Support(
        joint="slide",
        axis=(1.0, 0.0, 0.0),
        half_size_m=size,
        position_m=(side * (capsule.RADIUS_M + size[0]), 0.0, 0.0),
        mass_kg=capsule.PAD_MASS_KG,
        inertia_kg_m2=1e-3,
        force_n=-side * PRESS_N,
    )


def pinch(step_s: float, seconds: float) -> Scene:
    """Return two pads that touch a capsule and press on its ends."""
    return Scene(
        step_s,
        SAMPLE_S,
        [capsule.TARGET] * round(seconds / SAMPLE_S),
        mjcf=CAPSULE.mjcf(),
        qvel=[0.0] * 8,
        body=HELD,
        supports=[pad(-1.0), pad(1.0)],
        friction=capsule.FRICTION[0],
    )
