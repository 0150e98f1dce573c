// Draw the run in 3D while it is computed. Without WebGL nothing is drawn, and with reduced motion only the end.

import { HERE } from "./dom.js";
import { DROP_DISTANCE } from "./metrics.js";

/** Time between two pictures, because the engine needs most of the processor [ms]. */
const EVERY_MS = 120;
const BASE_M = [-0.5, -0.5, 0];

export class View {
  /** @param {HTMLElement} element with a canvas in it */
  constructor(element) {
    this.element = element;
    this.isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
    /** @type {any[]} */
    this.states = [];
    /** @type {number[] | undefined} */
    this.from = undefined;
    /** @type {Promise<any> | undefined} */
    this.stage = undefined;
    this.shaken = -1;
    this.edge_m = 0;
    this.drawn_ms = 0;
  }

  /** Remove the last run. @param {number} edge_m */
  begin(edge_m) {
    this.states = [];
    this.from = undefined;
    this.shaken = -1;
    this.edge_m = edge_m;
    this.stage ??= import(new URL("stage.js", HERE).href).then(({ open }) => {
      this.element.hidden = false; // this comes first, because hidden elements have no size
      return open(this.element, { edge_m, base_m: BASE_M });
    }).catch(() => {
      this.element.hidden = true;
      return null;
    });
  }

  /**
   * Add frames of the run, and return the displacement of the cube in the frames of the shake [mm].
   * @param {any[]} frames @param {number} shaken the index of the first frame of the shake, or −1
   * @returns {number[]}
   */
  add(frames, shaken) {
    this.shaken = shaken;
    const found = [];
    for (const { cube, turn, tcp, matrix, joints } of frames) {
      const apart = cube.map((/** @type {number} */ value, /** @type {number} */ axis) => value - tcp[axis]);
      const position = [0, 1, 2].map((axis) => matrix[axis] * apart[0] + matrix[3 + axis] * apart[1] + matrix[6 + axis] * apart[2]);
      const index = this.states.push({ joints, position, turn, matrix }) - 1;
      if (shaken < 0 || index < shaken) continue;
      const from = (this.from ??= position);
      const isHeld = Math.hypot(...position) < DROP_DISTANCE;
      found.push(isHeld ? 1e3 * Math.hypot(...position.map((value, axis) => value - from[axis])) : NaN);
    }
    if (!this.isStill && performance.now() - this.drawn_ms > EVERY_MS) this.draw();
    return found;
  }

  end() {
    this.draw();
  }

  async draw() {
    this.drawn_ms = performance.now();
    const stage = await this.stage;
    const state = this.states.at(-1);
    if (!stage || !state) return;
    const begin = this.states[Math.max(this.shaken, 0)];
    stage.show(state, begin, this.shaken >= 0 ? 1 : -1, this.edge_m);
  }
}
