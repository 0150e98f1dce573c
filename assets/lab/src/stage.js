// Show one run on the stage of the replay.

import { Stage } from "../../replay/src/stage.js";
import { quaternion } from "./ik.js";

/** @param {number[]} q (w, x, y, z) @param {number[]} r @returns {number[]} the inverse of the first times the second, as (x, y, z, w) */
function within([w, x, y, z], [a, b, c, d]) {
  return [w * b - x * a - y * d + z * c, w * c + x * d - y * a - z * b, w * d - x * c + y * b - z * a, w * a + x * b + y * c + z * d];
}

/** @param {HTMLElement} element @param {{edge_m: number, base_m: number[]}} scene */
export function open(element, scene) {
  /** @type {any} */
  let last;
  const stage = new Stage(element.querySelector("canvas"), scene, () => last && draw());
  const named = (/** @type {string} */ name) => {
    element.style.color = `var(${name})`;
    const { color } = getComputedStyle(element);
    element.style.color = "";
    return color;
  };
  stage.colour({ back: named("--panel"), lines: named("--faint"), edges: named("--ink") });
  const posed = (/** @type {any} */ state) => ({ joints: state.joints, position: state.position, quaternion: within(quaternion(state.matrix), state.turn) });
  const draw = () => stage.draw([{ begin: last.begin, inGrasp: () => true }], [last.state], 1, last.time, 0);
  return {
    /** @param {any} state @param {any} begin @param {number} time @param {number} edge_m */
    show(state, begin, time, edge_m) {
      last = { state: posed(state), begin: posed(begin), time };
      const scale = edge_m / scene.edge_m;
      stage.panes[0].cube.scale.setScalar(scale);
      stage.panes[0].start.scale.setScalar(1.004 * scale);
      draw();
    },
  };
}
