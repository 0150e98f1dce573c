// The robot with its simplified meshes, as what `import description from "robot"` finds.

import { readFileSync } from "node:fs";

import { MeshoptSimplifier } from "meshoptimizer";

const ASSETS = new URL("../", import.meta.url);
const UNIT_M = 1e-4; // the meshes are rounded to this
const ERROR_M = { finger: 0.0003, hand: 0.0003, other: 0.0006 };
const LEAST_TRIANGLES = 8; // what is left of a light or a screw is left out
const LINKS = {
  ...Object.fromEntries([...Array(8).keys()].map((number) => [`fr3_link${number}`, `link${number}`])),
  fr3_hand: "hand",
  fr3_leftfinger: "finger",
  fr3_rightfinger: "finger",
};

const text = (path) => readFileSync(new URL(path, ASSETS), "utf8");
const numbers = (words) => words.trim().split(/\s+/).map(Number);

function readObj(path) {
  const vertices = [];
  const indices = [];
  for (const line of text(path).split("\n")) {
    const [kind, ...words] = line.split(" ");
    if (kind === "v") vertices.push(...words.map(Number));
    if (kind === "f") indices.push(...words.map((word) => Number(word) - 1));
  }
  return { vertices: new Float32Array(vertices), indices: new Uint32Array(indices) };
}

// Fewer triangles, no farther than `error` [m] from where they were, as integers of UNIT_M.
function simplified({ vertices, indices }, error) {
  const [kept] = MeshoptSimplifier.simplify(indices, vertices, 3, 0, error, ["ErrorAbsolute"]);
  const places = new Map();
  const positions = [];
  const renumbered = Array.from(kept, (vertex) => {
    if (!places.has(vertex)) {
      places.set(vertex, places.size);
      positions.push(...vertices.subarray(3 * vertex, 3 * vertex + 3).map((value) => Math.round(value / UNIT_M)));
    }
    return places.get(vertex);
  });
  return { positions: base64(new Int16Array(positions)), indices: base64(new Uint16Array(renumbered)), count: kept.length / 3 };
}

const base64 = (array) => Buffer.from(array.buffer).toString("base64");

function parts() {
  const meshes = JSON.parse(text("visual/visual.json"));
  const shared = Object.fromEntries(
    Object.entries(meshes).map(([mesh, listed]) => [
      mesh,
      listed
        .map(({ file, rgba }) => ({ rgb: rgba.slice(0, 3), ...simplified(readObj(`visual/${file}`), ERROR_M[mesh] ?? ERROR_M.other) }))
        .filter(({ count }) => count >= LEAST_TRIANGLES),
    ]),
  );
  return { links: LINKS, meshes: shared, unit: UNIT_M };
}

// Joints and, of the fingers, the boxes that collide; the description is our own, so this reads no other.
function description() {
  const urdf = text("fr3.urdf");
  const attribute = (element, tag, name) => element.match(new RegExp(`<${tag}\\b[^>]*\\b${name}="([^"]*)"`))?.[1];
  const triple = (element, tag, name) => numbers(attribute(element, tag, name) ?? "0 0 0");
  const joints = [...urdf.matchAll(/<joint name="[^"]*" type="([a-z]+)">[^]*?<\/joint>/g)].map(([element, kind]) => ({
    kind,
    parent: attribute(element, "parent", "link"),
    child: attribute(element, "child", "link"),
    xyz: triple(element, "origin", "xyz"),
    rpy: triple(element, "origin", "rpy"),
    axis: triple(element, "axis", "xyz"),
  }));
  const finger = urdf.match(/<link name="fr3_leftfinger">[^]*?<\/link>/)[0];
  const boxes = [...finger.matchAll(/<collision>[^]*?<\/collision>/g)].map(([element]) => ({
    xyz: triple(element, "origin", "xyz"),
    roll: triple(element, "origin", "rpy")[0],
    size: triple(element, "box", "size"),
  }));
  return { joints, boxes };
}

await MeshoptSimplifier.ready;
const contents = JSON.stringify({ ...parts(), ...description() });
export const robot = {
  name: "robot",
  setup(build) {
    build.onResolve({ filter: /^robot$/ }, () => ({ path: "robot", namespace: "robot" }));
    build.onLoad({ filter: /.*/, namespace: "robot" }, () => ({ contents, loader: "json" }));
  },
};
