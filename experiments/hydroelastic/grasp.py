"""Build the shake with pads and an object that touch over an area under a pressure."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import warp as wp
from newton import ModelBuilder, ShapeFlags

from experiments.facts.case import Case, batch_key
from experiments.simulation import scene
from experiments.simulation.scene import BASELINE, GROUND_MU, Scene, pad_shapes
from experiments.simulation.simulation import Simulation

KH_N_M3 = 1e10  # default of ``ShapeConfig``
RESOLUTION = 64
NARROW_BAND_M = (-0.01, 0.01)
"""Range of distances that the grids hold, as in Newton's example ``panda_hydro``."""
PLATE_M = 0.002  # thickness of the plate


@dataclass(frozen=True)
class Grasp:
    """Describe a run of the shake with its pads and its object."""

    case: Case
    is_hydroelastic: bool = True
    # Rise of the pressure per depth [N/m³] of the pads and the object.
    kh_n_m3: float = KH_N_M3
    resolution: int = RESOLUTION  # cells of a grid along its longest side
    shape: str = "cube"
    """``cube``, ``plate`` for a thin plate of the same mass, or ``edge`` for the cube
    turned so that two of its edges touch the pads.
    """

    @property
    def key(self) -> tuple[object, ...]:
        """Return the settings that all worlds of a simulation share."""
        return (
            batch_key(self.case),
            self.is_hydroelastic,
            self.resolution,
            self.shape,
            self.case.cube_gap_m,
        )


class GraspSimulation(Simulation):
    """Run grasps with the same ``key`` as the worlds of one batch."""

    def __init__(self, grasps: Sequence[Grasp], device: wp.Device):
        cases = [grasp.case for grasp in grasps]
        super().__init__(cases, device)
        with wp.ScopedDevice(device):
            self.scene = build_scene(grasps, device)
            self.model = self.scene.model
            self.stepper = self.stepper_of(self.scene, cases)
            self.pipeline, self.contacts = self.stepper.pipeline, self.stepper.contacts
            self._build_state()
            if self.case.ik_beside:
                self.task.plan(self.body_q)
                self.task.solve()
        wp.synchronize_device(device)
        self._start_uncaptured()


def build_scene(grasps: Sequence[Grasp], device: wp.Device) -> Scene:
    """Build one world for each grasp."""
    grasp, cases = grasps[0], [each.case for each in grasps]
    world, links = scene._world_builder(grasp.case)
    pads, cube = pad_shapes(world), world.shape_count - 1
    if grasp.shape == "plate":
        half = 0.5 * scene.CUBE_EDGE
        world.shape_scale[cube] = (half, 0.5 * PLATE_M, half)
    if grasp.shape == "edge":
        turn = wp.quat_from_axis_angle(wp.vec3(0.0, 0.0, 1.0), np.pi / 4.0)
        world.shape_transform[cube] = wp.transform(wp.vec3(), turn)
    if grasp.is_hydroelastic:
        # The grids reach as far beyond a shape as its gap.
        world.shape_gap[cube] = grasp.case.cube_gap_m
        for shape in (*pads, cube):
            world.shape_flags[shape] |= ShapeFlags.HYDROELASTIC
            world.shape_sdf_max_resolution[shape] = grasp.resolution
            world.shape_sdf_narrow_band_range[shape] = NARROW_BAND_M
    whole = ModelBuilder()
    whole.replicate(world, len(grasps))
    ground = ModelBuilder.ShapeConfig(mu=GROUND_MU, gap=BASELINE.ground_gap_m)
    whole.add_ground_plane(cfg=ground)
    model = whole.finalize(device=device)
    robot = scene.robot_builder(grasp.case)[0].finalize(device=device)
    built = Scene(model, robot, links, pads=pads, cube=cube)
    scene._apply_world_parameters(built, cases)
    stiffness = np.array([each.kh_n_m3 for each in grasps], dtype=np.float32)
    scene._write(model.shape_material_kh, (*pads, cube), stiffness)
    return built
