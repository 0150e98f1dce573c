"""Parts of the cure, alone and together, as fields of a case."""

from experiments.facts.case import STIFF_PADS

TERMS = {
    "plain": {},
    "term": {"contact_bias": True},
    "centred": {"contact_bias": True, "bias_centred": True},
    "full": {"contact_bias": True, "bias_centred": True, "bias_normal": True},
}  # type: dict[str, dict]
"""Settings by what is done about the left-out term; ``full`` also gives it to the normal rows."""
POSITIONS = {"rounded": {}, "kept": {"compensated": True}}  # type: dict[str, dict]
IMPRATIO = 400.0
BEST = {"integrator": "euler", "impratio": IMPRATIO, **TERMS["full"], **POSITIONS["kept"]}  # type: dict
"""All parts together: Euler has no damping in its step, and centred the term takes the error of the step along."""
FIRM = {"pad_ke": STIFF_PADS.pad_ke, "pad_kd": STIFF_PADS.pad_kd, "impratio": IMPRATIO}  # type: dict
FIRM |= TERMS["centred"] | POSITIONS["kept"]
"""The cure on stiff pads, where the normal rows need none."""
