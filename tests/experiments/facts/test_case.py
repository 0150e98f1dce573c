"""Test the named cases by the laws that they are named after, and numbers that do not
define a case.
"""

import ast
import re
from dataclasses import replace
from types import SimpleNamespace

import newton
import numpy as np
import pytest

from experiments.facts import case as cases
from experiments.facts.case import (
    AS_SHIPPED,
    FIXED,
    HOLD,
    LEAN,
    STIFF_PADS,
    UNTRIMMED,
    Case,
    CaseError,
    differences,
)
from experiments.facts.fix_files import FIXED_SCENE
from experiments.facts.metrics import DROP_DISTANCE
from experiments.simulation import scene, stepper_c, task
from measured_report.files.root import ROOT

SHIPPED = (ROOT / FIXED_SCENE).read_text(encoding="utf-8")
"""Source of the scene in one file, a download that does not import any module of this
project.
"""


def test_the_scene_has_the_numbers_of_the_file_that_is_offered():
    known: dict = {"np": np, "wp": SimpleNamespace(constant=lambda value: value)}
    for line in ast.parse(SHIPPED).body:
        if isinstance(line, ast.Assign) and "Path" not in ast.unparse(line):
            exec(ast.unparse(line), known)
    named = {
        scene: "ROBOT_POSITION READY_POSE ARM_DOF_COUNT ROBOT_DOF_COUNT CUBE_EDGE CUBE_POSITION",
        task: "FRAME_DT PHASE_SECONDS APPROACH_HEIGHT LIFT_HEIGHT FINGER_OPEN POSITION_TOLERANCE ROTATION_TOLERANCE",
        stepper_c: "CONTACT_MAX CONSTRAINT_MAX",
    }
    for module, names in named.items():
        for name in names.split():
            assert getattr(module, name) == known[name], name
    case, names = (
        AS_SHIPPED,
        "SHAKE_AMPLITUDE SHAKE_FREQUENCY FINGER_CLOSED SUBSTEP_COUNT IK_ITERATION_COUNT CUBE_EDGE",
    )
    found = (
        case.shake_amplitude_m,
        case.shake_frequency_hz,
        case.finger_closed_m,
        case.substeps,
        case.ik_iterations,
    )
    assert (*found, case.cube_edge_m) == tuple(known[name] for name in names.split())
    assert (
        known["DROP_DISTANCE"] == DROP_DISTANCE
        and case.frame_count == 900
        and "--num-frames 900" in SHIPPED
    )

    def all_of(pattern: str) -> list[float]:
        [numbers] = re.findall(pattern, SHIPPED)
        return [
            float(each)
            for each in re.findall(r"(?<![\w.])-?\d[\d.]*(?:e-?\d+)?", numbers)
        ]

    assert all_of(r"density=.*mu=[\d.]+") == [
        case.cube_density_kg_m3,
        case.cube_ke,
        case.cube_kd,
        case.cube_mu,
    ]
    assert all_of(r"add_ground_plane\(.*gap=[\d.]+") == [
        scene.GROUND_MU,
        case.ground_gap_m,
    ]
    assert all_of(r"rigid_gap = .*") == [case.robot_gap_m]
    assert all_of(r"\Witerations=\d+,\s+ls_iterations=\d+") == [
        case.iterations,
        case.ls_iterations,
    ]
    assert all_of(r"impratio=.*") == [case.impratio]
    assert (
        tuple(all_of(r"geom_solimp.*")) == scene.PAD_SOLIMP
        and case.pad_dmax == scene.PAD_SOLIMP[1]
    )
    assert all_of(r"joint_target_k[e].*\]") == [scene.TARGET_KE] and all_of(
        r"joint_target_k[d].*\]"
    ) == [scene.TARGET_KD]
    for pattern, values in (
        ("effort_limit", scene.EFFORT_LIMIT),
        ("armature", scene.ARMATURE),
    ):
        pairs = np.reshape(all_of(rf"joint_{pattern}.*"), (-1, 2))
        assert np.repeat(pairs[:, 0], pairs[:, 1].astype(int)).tolist() == list(values)
    lifted = np.subtract(scene.CUBE_IN_HAND, known["CUBE_POSITION"])
    assert lifted == pytest.approx([0.0, 0.0, known["LIFT_HEIGHT"]])
    assert (
        case.cube_offset_m,
        case.start_overlap_m,
        case.noslip_iterations,
        case.gravity_m_s2,
    ) == (0.0, 0.0, 0, 9.81)


def test_pads_as_shipped_are_what_newton_gives_a_shape_and_both_are_critically_damped():
    shape = newton.ModelBuilder.ShapeConfig()
    pads = (AS_SHIPPED.pad_ke, AS_SHIPPED.pad_kd, AS_SHIPPED.pad_mu, AS_SHIPPED.pad_kf)
    assert pads == (shape.ke, shape.kd, shape.mu, shape.kf)
    assert AS_SHIPPED.cube_gap_m == newton.ModelBuilder().rigid_gap
    # With timeconst 2 / kd and dampratio kd / (2 √ke) this gives 20 ms, and a tenth of
    # it, 2 ms, at a ratio of 1.
    for case, timeconst_s in ((AS_SHIPPED, 0.02), (STIFF_PADS, 0.002), (FIXED, 0.002)):
        assert 2.0 / case.pad_kd == pytest.approx(timeconst_s)
        assert case.pad_kd**2 == pytest.approx(4.0 * case.pad_ke)
    assert (
        differences(STIFF_PADS).keys() == {"pad_ke", "pad_kd"}
        and cases.FIRM["pad_ke"] == STIFF_PADS.pad_ke
    )
    assert differences(HOLD) == {"shake_amplitude_m": 0.0}
    assert (
        differences(FIXED).keys()
        == differences(LEAN).keys() | differences(STIFF_PADS).keys()
    )
    assert (
        cases.BEST["impratio"]
        == cases.FIRM["impratio"]
        == cases.IMPRATIO
        == 8.0 * AS_SHIPPED.impratio
    )
    assert UNTRIMMED.ik_iterations == 3 * AS_SHIPPED.ik_iterations


@pytest.mark.parametrize(
    ("name", "least"),
    [
        ("pad_mu", 0.0),
        ("cube_mu", 0.0),
        ("cube_gap_m", 0.0),
        ("robot_gap_m", 0.0),
        ("ground_gap_m", 0.0),
    ]
    + [
        ("shake_amplitude_m", 0.0),
        ("iterations", 1),
        ("ls_iterations", 1),
        ("ik_iterations", 1),
        ("frame_count", 1),
    ],
)
def test_the_least_that_makes_a_case_is_taken_and_less_is_not(name, least):
    assert getattr(Case("least", **{name: least}), name) == least
    with pytest.raises(CaseError, match=name):
        Case("less", **{name: least - 1})


@pytest.mark.parametrize(
    "name", ["pad_kd", "cube_ke", "cube_kd", "cube_density_kg_m3", "cube_edge_m"]
)
def test_what_cannot_be_nothing_is_refused_as_nothing(name):
    with pytest.raises(CaseError, match=name):
        replace(AS_SHIPPED, **{name: 0.0})
    with pytest.raises(CaseError, match=name):
        replace(AS_SHIPPED, **{name: float("inf")})


def test_parts_of_the_term_need_the_term_and_collisions_divide_substeps():
    for name in ("bias_centred", "bias_normal"):
        with pytest.raises(CaseError, match=name):
            replace(AS_SHIPPED, **{name: True})
    assert replace(AS_SHIPPED, substeps=4, collide_count=4).collide_count == 4
