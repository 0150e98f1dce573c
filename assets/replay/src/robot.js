// Build the robot as a tree of three.js objects that its joints move.

import { BufferAttribute, BufferGeometry, Color, Group, Mesh, MeshLambertMaterial, SRGBColorSpace, Vector3 } from "three";

import description from "robot";

const CREASE = Math.cos((35 * Math.PI) / 180); // triangles that meet at a larger angle have an edge between them

const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;

function geometry({ positions, indices }) {
  const vertices = Float32Array.from(new Int16Array(bytes(positions)), (value) => value * description.unit);
  const corners = new Uint16Array(bytes(indices));
  const result = new BufferGeometry();
  result.setAttribute("position", new BufferAttribute(Float32Array.from(spread(vertices, corners)), 3));
  result.setAttribute("normal", new BufferAttribute(normals(vertices, corners), 3));
  return result;
}

function* spread(vertices, corners) {
  for (const corner of corners) yield* vertices.subarray(3 * corner, 3 * corner + 3);
}

// Each corner gets the mean normal, weighted by area, of the triangles around it that do not meet at an edge.
function normals(vertices, corners) {
  const point = (corner) => new Vector3().fromArray(vertices, 3 * corner);
  const about = Array.from({ length: vertices.length / 3 }, () => []);
  const areas = [];
  for (let face = 0; face < corners.length / 3; face++) {
    const [a, b, c] = [0, 1, 2].map((corner) => point(corners[3 * face + corner]));
    areas.push(b.sub(a).cross(c.sub(a)));
    for (let corner = 0; corner < 3; corner++) about[corners[3 * face + corner]].push(face);
  }
  const units = areas.map((area) => area.clone().normalize());
  const result = new Float32Array(3 * corners.length);
  const sum = new Vector3();
  corners.forEach((vertex, corner) => {
    const own = units[Math.floor(corner / 3)];
    sum.set(0, 0, 0);
    for (const face of about[vertex]) if (units[face].dot(own) >= CREASE) sum.add(areas[face]);
    sum.normalize().toArray(result, 3 * corner);
  });
  return result;
}

const looks = Object.fromEntries(
  Object.entries(description.meshes).map(([mesh, parts]) => [
    mesh,
    parts.map((part) => ({
      geometry: geometry(part),
      material: new MeshLambertMaterial({ color: new Color().setRGB(...part.rgb, SRGBColorSpace) }),
    })),
  ]),
);

export class Robot {
  constructor(base) {
    this.root = new Group();
    this.root.position.fromArray(base);
    this.links = { [description.joints[0].parent]: this.root };
    this.joints = [];
    for (const joint of description.joints) {
      const place = new Group();
      place.position.fromArray(joint.xyz);
      place.rotation.set(...joint.rpy, "ZYX");
      const link = new Group();
      place.add(link);
      this.links[joint.parent].add(place);
      this.links[joint.child] = link;
      if (joint.kind !== "fixed") this.joints.push({ link, axis: new Vector3().fromArray(joint.axis), kind: joint.kind });
    }
    for (const [link, mesh] of Object.entries(description.links)) {
      for (const look of looks[mesh]) this.links[link].add(new Mesh(look.geometry, look.material));
    }
  }

  move(positions) {
    this.joints.forEach(({ link, axis, kind }, number) => {
      if (kind === "revolute") link.quaternion.setFromAxisAngle(axis, positions[number]);
      else link.position.copy(axis).multiplyScalar(positions[number]);
    });
  }
}
