"""Remedies of the slide, put into a batch by world: the left-out term and the compensated positions."""

from collections.abc import Sequence

from newton.solvers import SolverMuJoCo

from experiments.facts.case import Case, CaseError
from experiments.simulation import compensated_positions, contact_bias, contact_bias_c


def install_remedies(solver: SolverMuJoCo, cases: Sequence[Case]) -> None:
    """Give each world of a solver what its case asks for; nothing is installed that no case asks for."""
    if any(case.compensated for case in cases):
        if solver.use_mujoco_cpu:
            raise CaseError("compensated must be off with backend mujoco, which sums positions in double precision")
        compensated_positions.install(solver, worlds=[case.compensated for case in cases])
    for kind in sorted({bias_kind(case) for case in cases if case.contact_bias}):
        centred, normal = kind
        if solver.use_mujoco_cpu:
            contact_bias_c.install(solver, centred=centred, normal=normal)
        else:
            worlds = [case.contact_bias and bias_kind(case) == kind for case in cases]
            contact_bias.install(solver, centred=centred, normal=normal, worlds=worlds)


def bias_kind(case: Case) -> tuple[bool, bool]:
    return case.bias_centred, case.bias_normal
