// Draw a section of the grasp along the direction in which the fingers close: the depth of the cube in the pads, and the forces.

import description from "robot";

import { change, shape } from "./drawing.js";

const WIDTH = 92; // width of the whole drawing [mm]
const TOP = -31;
const HEIGHT = 57;
const ARROW_MM_N = 0.55;

const inHand = description.joints.find(({ child }) => child === "fr3_leftfinger").xyz[2] - description.joints.find(({ child }) => child === "fr3_hand_tcp").xyz[2];

export class Section {
  constructor(svg, edge_m, colour) {
    this.half = 500 * edge_m;
    change(svg, { viewBox: `${-WIDTH / 2} ${TOP} ${WIDTH} ${HEIGHT}` });
    this.fingers = [1, -1].map((side) => {
      const finger = shape(svg, "g", { class: "finger" });
      for (const { xyz, roll, size } of description.boxes) {
        const [, depth, height] = size.map((length) => 1e3 * length);
        const [, y, z] = xyz.map((place) => 1e3 * place);
        const turned = `translate(${side * y} ${z + 1e3 * inHand}) rotate(${(side * roll * 180) / Math.PI})`;
        shape(finger, "rect", { x: -depth / 2, y: -height / 2, width: depth, height, transform: turned });
      }
      return finger;
    });
    this.cube = shape(svg, "rect", { x: -this.half, y: -this.half, width: 2 * this.half, height: 2 * this.half, fill: colour, class: "cube" });
    this.overlaps = [1, -1].map(() => shape(svg, "rect", { class: "overlap" }));
    this.arrows = [1, -1].map(() => shape(svg, "path", { class: "arrow" }));
  }

  // Positions are in mm in the TCP frame: y points to the right, and z, which points to the ground, down.
  draw(state) {
    const [, y, z] = state.position.map((place) => 1e3 * place);
    const [qx, qy, qz, qw] = state.quaternion;
    const roll = Math.atan2(2 * (qw * qx + qy * qz), 1 - 2 * (qx * qx + qy * qy)) * (180 / Math.PI);
    change(this.cube, { transform: `translate(${y} ${z}) rotate(${roll})` });
    const pad = description.boxes.at(-1);
    const middle = 1e3 * (pad.xyz[2] + inHand);
    const reach = 500 * pad.size[2];
    const pressed = state.penetration_mm > 0 && state.normal_n > 1;
    [1, -1].forEach((side, number) => {
      const face = 1e3 * (state.joints[7 + number] + pad.xyz[1] - pad.size[1] / 2);
      change(this.fingers[number], { transform: `translate(${side * 1e3 * state.joints[7 + number]} 0)` });
      const deep = Math.max(side * y + this.half - face, 0);
      const shown = pressed && deep < 5;
      const top = Math.max(middle - reach, z - this.half);
      const bottom = Math.min(middle + reach, z + this.half);
      change(this.overlaps[number], {
        x: side > 0 ? face : -face - deep,
        y: top,
        width: shown ? deep : 0,
        height: Math.max(bottom - top, 0),
      });
      // Each pad carries half of the total contact force.
      const length = shown ? (ARROW_MM_N * state.normal_n) / 2 : 0;
      const tip = side * (face + 8);
      const tail = tip + side * (length + 3);
      change(this.arrows[number], { d: length > 0.3 ? `M${tail} ${middle}H${tip}m${side * 2.6} -2l${-side * 2.6} 2l${side * 2.6} 2` : "" });
    });
  }
}
