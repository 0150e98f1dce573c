"""Render kept runs without a window or a GPU, with Newton's tiled camera sensor."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import newton
import numpy as np
import warp as wp
from newton import ModelBuilder
from newton.sensors import SensorTiledCamera

from measured_report.files.root import ROOT

FOLDER = ROOT / "assets/visual"
ARM_LINKS = {f"fr3_link{number}": f"link{number}" for number in range(8)}
LINKS = ARM_LINKS | {
    "fr3_hand": "hand",
    "fr3_leftfinger": "finger",
    "fr3_rightfinger": "finger",
}
"""The meshes of each link in the robot description.

Both fingers use the same meshes, because the description already rotates the right
finger by π.
"""
# Faces that meet at a larger angle have an edge between them [°].
CREASE_DEG = 35.0
# The cube, and the edges of a cube at its position when the shake began.
CUBE, START = (
    "cube",
    "start",
)
EDGE_M = 0.0005  # width of those edges
GROUND_RGB = (0.40, 0.43, 0.46)
GRID_RGB = (0.46, 0.49, 0.52)
EDGE_RGB = (0.98, 0.98, 0.98)
GRID_STEP_M, GRID_COUNT = 0.2, 20
# Half the width and the height of the lines on the ground.
GRID_WIDTH_M, GRID_HEIGHT_M = (
    0.003,
    1e-4,
)
SUN = (-0.42, 0.50, -0.76)  # direction of the light
EXPOSURE = 0.92
BACKDROP = (0.10, 0.115, 0.13)  # linear colour of the distant background
FADE_M = (1.6, 6.0)  # distances at which the fading of the ground begins and ends
SAMPLE_COUNT = 6  # rays per pixel at edges; all other pixels have one
CONTRAST = 0.05  # difference in brightness that counts as an edge
NOTHING = 0xFFFFFFFF


@dataclass(frozen=True)
class Camera:
    """Describe the view that a picture shows."""

    eye: np.ndarray  # position [m], shape [3]
    target: np.ndarray  # centre of the picture [m], shape [3]
    height_deg: float  # vertical field of view

    @property
    def pose(self) -> np.ndarray:
        """Return the pose of the camera, which looks along −z, shape [4, 4]."""
        back = self.eye - self.target
        back = back / np.linalg.norm(back)
        right = np.cross((0.0, 0.0, 1.0), back)
        right /= np.linalg.norm(right)
        return np.vstack(
            [
                np.stack([right, np.cross(back, right), back, self.eye], axis=1),
                (0, 0, 0, 1),
            ]
        )

    def rays(self, x: np.ndarray, y: np.ndarray, width: int, height: int) -> np.ndarray:
        """Return the origins and the directions of rays through points of the picture.

        The points are in pixels, and the rays are in the frame of the camera. For
        points in arrays of any shape, the result has the shape [..., 2, 3].
        """
        reach = np.tan(np.radians(self.height_deg) / 2)
        direction = np.stack(
            [
                (2 * x - width) / height * reach,
                (1 - 2 * y / height) * reach,
                np.full(x.shape, -1.0),
            ],
            axis=-1,
        )
        direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
        return np.stack([np.zeros_like(direction), direction], axis=-2).astype(
            np.float32
        )


class Stage:
    """Show several runs from the same view, each in its own world."""

    def __init__(
        self,
        cube_rgb: Sequence[tuple[float, float, float]],
        cube_edge_m: float,
        device: str,
    ):
        self.world_count = len(cube_rgb)
        self.bodies = (*LINKS, CUBE, START)
        self.model = _build(cube_rgb, cube_edge_m).finalize(device=device)
        self.state = self.model.state()
        self.sensor = SensorTiledCamera(self.model)
        self.sensor.default_render_config.enable_shadows = True
        self.sensor.default_render_config.render_order = (
            SensorTiledCamera.RenderOrder.VIEW_PRIORITY
        )
        sun = np.array(SUN) / np.linalg.norm(SUN)
        self.sensor.utils.create_default_light(
            enable_shadows=True, direction=wp.vec3f(*sun)
        )

    def place(self, poses: Sequence[Mapping[str, np.ndarray]]) -> None:
        """Set the poses of the bodies in each world; bodies without a pose are hidden.

        A pose is a matrix, shape [4, 4].
        """
        hidden = np.eye(4)
        hidden[2, 3] = -100.0
        self.state.body_q.assign(
            [
                transform(world.get(body, hidden))
                for world in poses
                for body in self.bodies
            ]
        )
        self.model.bvh_refit_shapes(self.state)

    def picture(self, camera: Camera, width: int, height: int) -> np.ndarray:
        """Return the pictures of all worlds, shape [worlds, height, width, 3].

        The colours are linear.
        """
        x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
        colour, shape = self._trace(camera, camera.rays(x, y, width, height))
        edge = _is_edge(display(colour).mean(axis=-1), shape)
        rows, columns = np.nonzero(edge)
        spots = _spread(SAMPLE_COUNT)
        rays = camera.rays(
            columns[:, None] + spots[:, 0], rows[:, None] + spots[:, 1], width, height
        )
        if len(rows):
            colour[:, rows, columns] = display_mean(self._trace(camera, rays)[0])
        return colour

    def _trace(self, camera: Camera, rays: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the linear colour and the shape that each ray hits in each world.

        The rays have the shape [rows, columns, 2, 3].
        """
        size = (self.world_count, 1, *rays.shape[:2])
        device = self.model.device
        colour, depth, shape = (
            wp.zeros(size, dtype=dtype, device=device)
            for dtype in (wp.vec3f, float, wp.uint32)
        )
        self.sensor.update(
            self.state,
            wp.array(
                [[transform(camera.pose)] * self.world_count],
                dtype=wp.transformf,
                device=device,
            ),
            wp.array(rays[None], dtype=wp.vec3f, device=device),
            hdr_color_image=colour,
            depth_image=depth,
            shape_index_image=shape,
        )
        colour, depth, shape = (array.numpy()[:, 0] for array in (colour, depth, shape))
        near, far = FADE_M
        fade = np.where(
            shape == NOTHING, 1.0, np.clip((depth - near) / (far - near), 0.0, 1.0)
        )[..., None]
        return EXPOSURE * colour * (1.0 - fade) + np.array(BACKDROP) * fade, shape


def display(linear: np.ndarray) -> np.ndarray:
    """Convert linear colours to sRGB, from 0 to 1.

    Colours that are almost white or brighter remain distinguishable.
    """
    knee = 0.7
    over = np.maximum(linear - knee, 0.0)
    soft = np.where(linear > knee, knee + (1 - knee) * over / (over + 1 - knee), linear)
    return np.where(
        soft <= 0.0031308,
        12.92 * soft,
        1.055 * np.maximum(soft, 0.0031308) ** (1 / 2.4) - 0.055,
    )


def display_mean(linear: np.ndarray) -> np.ndarray:
    """Return the mean of a pixel's samples, shape [..., samples, 3].

    Samples that are too bright count as white.
    """
    return np.minimum(linear, 1.0).mean(axis=-2)


def transform(matrix: np.ndarray) -> wp.transformf:
    """Return a pose, shape [4, 4], as a Warp transform."""
    return wp.transformf(
        wp.vec3f(*matrix[:3, 3]),
        wp.quat_from_matrix(wp.mat33f(*matrix[:3, :3].reshape(-1))),
    )


def _build(
    cube_rgb: Sequence[tuple[float, float, float]], cube_edge_m: float
) -> ModelBuilder:
    parts = [
        (
            part,
            newton.Mesh(
                part.corners,
                np.arange(len(part.corners)),
                normals=part.normals,
                compute_inertia=False,
            ),
        )
        for part in robot_parts()
    ]
    look = ModelBuilder.ShapeConfig(density=0.0, has_shape_collision=False)
    half = 0.5 * cube_edge_m
    scene = ModelBuilder()
    for rgb in cube_rgb:
        world = ModelBuilder()
        for link in LINKS:
            body = world.add_body(mass=1.0, inertia=wp.mat33(np.eye(3)))
            for part, mesh in parts:
                if part.link == link:
                    world.add_shape_mesh(body, mesh=mesh, cfg=look, color=part.rgb)
        cube = world.add_body(mass=1.0, inertia=wp.mat33(np.eye(3)))
        _add_box(world, cube, np.zeros(3), np.full(3, half), look, rgb)
        start = world.add_body(mass=1.0, inertia=wp.mat33(np.eye(3)))
        for centre, size in _edges(half):
            _add_box(world, start, centre, size, look, EDGE_RGB)
        scene.add_world(world)
    scene.add_ground_plane(cfg=look, color=GROUND_RGB)
    reach = 0.5 * GRID_COUNT * GRID_STEP_M
    for place in np.linspace(-reach, reach, GRID_COUNT + 1):
        for centre, size in (
            ((place, 0, 0), (GRID_WIDTH_M, reach, 1e-4)),
            ((0, place, 0), (reach, GRID_WIDTH_M, 1e-4)),
        ):
            _add_box(scene, -1, centre, size, look, GRID_RGB)
    return scene


def _add_box(
    builder: ModelBuilder, body: int, centre, size, look: ModelBuilder.ShapeConfig, rgb
) -> None:
    hx, hy, hz = map(float, size)
    builder.add_shape_box(
        body,
        xform=wp.transform(wp.vec3(*centre)),
        hx=hx,
        hy=hy,
        hz=hz,
        cfg=look,
        color=rgb,
    )


def _edges(half: float) -> list[tuple[np.ndarray, np.ndarray]]:
    found = []
    for axis in range(3):
        for first in (-half, half):
            for second in (-half, half):
                size = np.full(3, 0.5 * EDGE_M)
                size[axis] = half + 0.5 * EDGE_M
                found.append((np.insert([first, second], axis, 0.0), size))
    return found


def _is_edge(brightness: np.ndarray, shape: np.ndarray) -> np.ndarray:
    """Return the pixels that differ from a neighbour in any world, [height, width]."""
    edge = np.zeros(brightness.shape, dtype=bool)
    for axis in (1, 2):
        ahead = [slice(None)] * 3
        behind = [slice(None)] * 3
        ahead[axis], behind[axis] = slice(1, None), slice(None, -1)
        ahead, behind = tuple(ahead), tuple(behind)  # type: ignore[assignment]  # the clips were made by these lines
        step = (np.abs(brightness[ahead] - brightness[behind]) > CONTRAST) | (
            shape[ahead] != shape[behind]
        )
        edge[ahead] |= step
        edge[behind] |= step
    return edge.any(axis=0)


def _spread(count: int) -> np.ndarray:
    """Return points that are spread evenly over a pixel, shape [count, 2].

    They are from the R2 sequence (M. Roberts, 2018).
    """
    step = np.array([0.7548776662466927, 0.5698402909980532])
    return (0.5 + np.arange(count)[:, None] * step) % 1.0


@dataclass(frozen=True)
class Part:
    """Describe a mesh of one colour in the frame of its link.

    Each triangle has its own corners.
    """

    link: str
    corners: np.ndarray  # positions [m], three for each triangle, shape [corners, 3]
    normals: np.ndarray  # shape [corners, 3]
    rgb: tuple[float, float, float]  # as displayed (sRGB), from 0 to 1


def robot_parts() -> Iterator[Part]:
    """Yield the parts of every link."""
    listing = json.loads((FOLDER / "visual.json").read_text(encoding="utf-8"))
    for link, mesh in LINKS.items():
        for part in listing[mesh]:
            vertices, faces = read_obj(FOLDER / part["file"])
            yield Part(
                link,
                vertices[faces.reshape(-1)],
                corner_normals(vertices, faces),
                tuple(part["rgba"][:3]),
            )


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices [m] and the triangles of a mesh.

    The shapes are [vertices, 3] and [triangles, 3]; triangles contain indices of
    vertices.
    """
    lines = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    vertices = np.array(
        [line[1:] for line in lines if line[0] == "v"], dtype=np.float32
    )
    return vertices, np.array(
        [line[1:] for line in lines if line[0] == "f"], dtype=np.int32
    ) - 1


def corner_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the normal of each corner, shape [corners, 3].

    It is the mean of the faces that meet there without an edge, weighted by area.
    """
    sides = vertices[faces[:, 1:]] - vertices[faces[:, :1]]
    area = np.cross(sides[:, 0], sides[:, 1])
    unit = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-20)
    about: list[list[int]] = [[] for _ in vertices]
    for face, corners in enumerate(faces):
        for vertex in corners:
            about[vertex].append(face)
    normals = np.empty((faces.size, 3), dtype=np.float32)
    for corner, vertex in enumerate(faces.reshape(-1)):
        own, near = unit[corner // 3], np.array(about[vertex])
        normals[corner] = (
            area[near[unit[near] @ own >= np.cos(np.radians(CREASE_DEG))]].sum(axis=0)
            if len(near)
            else own
        )
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
