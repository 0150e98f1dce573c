"""Compares the pairs with those that MuJoCo's collision detection checks."""

import copy

import mujoco
import numpy as np
import pytest

from newton_lint.combined import contacts_of
from newton_lint.pairs import OFF, pairs_of

BODIES = """
<mujoco>
  <option>{flag}</option>
  <default><geom size="0.1"/></default>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/><geom name="wall"/>
    <body name="a"><joint/><geom name="a1"/><geom name="a2" contype="2" conaffinity="0"/>
      <body name="fixed"><geom name="f"/></body>
      <body name="b"><joint/><geom name="b1"/><body name="c"><joint/><geom name="c1" conaffinity="3"/></body></body>
    </body>
    <body name="mocap" mocap="true"><geom name="m"/></body>
    <body name="still"><geom name="s"/></body>
    <body name="d"><freejoint/><geom name="d1" contype="0"/><geom name="d2" contype="0" conaffinity="0"/></body>
  </worldbody>
  <contact><exclude body1="a" body2="d"/><pair geom1="a1" geom2="b1"/><pair geom1="d2" geom2="floor"/>
    <pair geom1="wall" geom2="s"/></contact>
</mujoco>
"""


def asked_for(model: mujoco.MjModel) -> set[tuple[int, int]]:
    """Return the pairs that the engine checks if all geoms are near, and the named ones."""
    if model.opt.disableflags & OFF:
        return set()
    near = copy.copy(model)
    found = set()
    near.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
    near.geom_margin[:] = near.pair_margin[:] = near.body_margin[:] = 1e4

    def ask(model: mujoco.MjModel, _: mujoco.MjData, one: int, other: int) -> int:
        bits = model.geom_contype[one] & model.geom_conaffinity[other]
        if bits | (model.geom_contype[other] & model.geom_conaffinity[one]):
            found.add((min(one, other), max(one, other)))
        return 1

    mujoco.set_mjcb_contactfilter(ask)
    try:
        data = mujoco.MjData(near)
        mujoco.mj_kinematics(near, data)
        mujoco.mj_comPos(near, data)
        mujoco.mj_collision(near, data)
    finally:
        mujoco.set_mjcb_contactfilter(None)
    planes = set(
        np.flatnonzero(model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)).tolist()
    )
    named = {
        (int(min(pair)), int(max(pair)))
        for pair in zip(model.pair_geom1, model.pair_geom2, strict=True)
    }
    return named | {pair for pair in found if not set(pair) <= planes}


@pytest.mark.parametrize(
    "flag", ["", '<flag filterparent="disable"/>', '<flag contact="disable"/>']
)
def test_pairs_are_those_that_the_engine_asks_for(flag):
    model = mujoco.MjModel.from_xml_string(BODIES.format(flag=flag))
    pairs, named = pairs_of(model)
    assert {tuple(pair) for pair in pairs.tolist()} == asked_for(model)
    assert len(pairs) == len({tuple(pair) for pair in pairs.tolist()})
    assert sorted(named[named >= 0]) == ([] if "contact" in flag else [0, 1, 2])


GEOMS = """
<mujoco>
  <option>{flag}</option>
  <worldbody>
    <geom type="plane" size="1 1 1" {floor}/>
    <body pos="0 0 0.09"><freejoint/><geom size="0.1" {ball}/></body>
  </worldbody>
</mujoco>
"""


@pytest.mark.parametrize(
    ("floor", "ball", "flag"),
    [
        (
            'solref="0.05 0.5" friction="0.3 0.1 0.2"',
            'solimp="0.5 0.6 0.01 0.3 3" condim="6"',
            "",
        ),
        ('solref="0.05 1" solmix="3"', 'solmix="0" condim="1"', ""),
        ('solref="-100 -10"', 'solref="0.01 1"', ""),
        ('solref="-100 -10" priority="1"', 'solref="-50 -20" friction="2"', ""),
        ('friction="0"', 'friction="0"', ""),
        ("", 'solref="0.01 1"', '<flag override="enable"/>'),
    ],
)
def test_parameters_are_those_of_the_engines_contacts(floor, ball, flag):
    model = mujoco.MjModel.from_xml_string(
        GEOMS.format(floor=floor, ball=ball, flag=flag)
    )
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    ours = contacts_of(model)
    contact = data.contact[0]
    for mine, theirs in (
        *(
            (ours.solref, contact.solref),
            (ours.solimp, contact.solimp),
            (ours.condim, contact.dim),
        ),
        (ours.friction, contact.friction[[0, 2, 3]]),
    ):
        np.testing.assert_allclose(mine[0], theirs)
