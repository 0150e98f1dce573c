"""What the robot looks like: the meshes of ``assets/visual/``, shaded smoothly but for their edges."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from measured_report.files.root import ROOT

FOLDER = ROOT / "assets/visual"
ARM_LINKS = {f"fr3_link{number}": f"link{number}" for number in range(8)}
LINKS = ARM_LINKS | {"fr3_hand": "hand", "fr3_leftfinger": "finger", "fr3_rightfinger": "finger"}
"""Which meshes each link of the robot description shows. Both fingers show the same ones: the description turns the
right finger by π already."""
CREASE_DEG = 35.0
"""Faces that meet at a larger angle than this have an edge between them."""


@dataclass(frozen=True)
class Part:
    """A mesh of one colour, in the frame of its link. No two triangles share a corner."""

    link: str
    corners: np.ndarray
    """Positions [m], three for each triangle, shape [corners, 3]."""
    normals: np.ndarray
    """Shape [corners, 3]."""
    rgb: tuple[float, float, float]
    """As displayed (sRGB), from 0 to 1."""


def robot_parts() -> Iterator[Part]:
    """Return the parts of every link."""
    listing = json.loads((FOLDER / "visual.json").read_text(encoding="utf-8"))
    for link, mesh in LINKS.items():
        for part in listing[mesh]:
            vertices, faces = read_obj(FOLDER / part["file"])
            yield Part(link, vertices[faces.reshape(-1)], corner_normals(vertices, faces), tuple(part["rgba"][:3]))


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices [m], shape [vertices, 3], and triangles as indices of them, shape [triangles, 3]."""
    lines = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    vertices = np.array([line[1:] for line in lines if line[0] == "v"], dtype=np.float32)
    return vertices, np.array([line[1:] for line in lines if line[0] == "f"], dtype=np.int32) - 1


def corner_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return the normal of each corner: the mean, by area, of the faces about its vertex that meet at no edge, shape
    [3 * triangles, 3]."""
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
            area[near[unit[near] @ own >= np.cos(np.radians(CREASE_DEG))]].sum(axis=0) if len(near) else own
        )
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
