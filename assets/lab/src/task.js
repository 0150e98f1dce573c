// Run the task (approach, descend, grasp, lift, shake) as experiments/simulation/task.py does, for one world.

import { quaternion, turnBetween } from "./ik.js";

export const FRAME_RATE = 60;
const FRAME_S = Math.fround(1 / FRAME_RATE);
export const PHASE = { approach: 0, descend: 1, grasp: 2, lift: 3, shake: 4 };
const PHASE_SECONDS = [0.25, 1.0, 0.75, 1.5];
export const FINGER_OPEN = 0.035;
const APPROACH_HEIGHT = 0.1;
const LIFT_HEIGHT = 0.2;
/** Peak speed, in the middle of the lift, whose path is s²(3 − 2s). */
export const LIFT_PEAK_M_S = (1.5 * LIFT_HEIGHT) / PHASE_SECONDS[PHASE.lift];
const SHAKE_RATIO = [0.65, 0.35];
const POSITION_TOLERANCE = 0.005;
const ROTATION_TOLERANCE = (2 * Math.PI) / 180;
const APPROACH_SOLVE_COUNT = 30;
export const IK_ITERATIONS = 8;
const TOOL_DOWN = [0, 1, 0, 0];
export const READY = [0, 0.5, 0, -1.5, 0, 2, Math.PI / 4];

/** Compute the targets of the TCP and the fingers, frame by frame. */
export class Task {
  /**
   * @param {import("./ik.js").ArmSolver} solver
   * @param {{amplitude_m: number, frequency_hz: number, finger_closed_m: number}} shake
   * @param {number[]} cube its position before the first frame [m]
   */
  constructor(solver, shake, cube) {
    this.solver = solver;
    this.shake = shake;
    this.phase = PHASE.approach;
    this.elapsed = 0;
    const above = [cube[0], cube[1], cube[2] + APPROACH_HEIGHT];
    for (let count = 0; count < APPROACH_SOLVE_COUNT; count++) solver.step(above, TOOL_DOWN, IK_ITERATIONS);
    this.angles = solver.angles;
    this.nextFinger = FINGER_OPEN;
    /** @type {{position: number[], rotation: number[]}} */
    this.start = { position: above, rotation: TOOL_DOWN };
    this.goal = this.start;
  }

  /**
   * Advance the clock by a frame, and solve for the target of the TCP at this time.
   * @param {number[]} cube its position now [m]
   */
  plan(cube) {
    const t = (this.elapsed = Math.fround(this.elapsed + FRAME_S)); // in single precision, because this sum decides when phases end
    const { start, phase, shake } = this;
    let { position, rotation } = start;
    let [from, to] = [FINGER_OPEN, FINGER_OPEN];
    if (phase === PHASE.approach || phase === PHASE.descend) {
      position = [cube[0], cube[1], cube[2] + (phase === PHASE.approach ? APPROACH_HEIGHT : 0)];
      rotation = TOOL_DOWN;
    } else if (phase === PHASE.grasp) {
      to = shake.finger_closed_m;
    } else {
      from = to = shake.finger_closed_m;
      const offset = phase === PHASE.lift ? [0, 0, LIFT_HEIGHT] : shakeOffset(shake, t);
      position = position.map((value, axis) => value + offset[axis]);
    }
    this.goal = { position, rotation };
    const progress = phase < PHASE.shake ? Math.min(1, t / PHASE_SECONDS[phase]) : 1;
    const blend = phase < PHASE.shake ? progress * progress * (3 - 2 * progress) : 1;
    const target = position.map((value, axis) => (1 - blend) * start.position[axis] + blend * value);
    this.angles = this.solver.step(target, slerp(start.rotation, rotation, blend), IK_ITERATIONS);
    this.nextFinger = (1 - blend) * from + blend * to;
  }

  /**
   * Return the joint targets of this frame. The phase ends when its time is over and the TCP has reached its target.
   * @param {{position: number[], rotation: number[]}} tcp
   * @returns {number[]} targets of the arm [rad] and both fingers [m]
   */
  command(tcp) {
    const targets = [...this.angles, this.nextFinger, this.nextFinger];
    if (this.phase < PHASE.shake && !(this.elapsed < PHASE_SECONDS[this.phase])) {
      const distance = Math.hypot(...tcp.position.map((value, axis) => value - this.goal.position[axis]));
      const angle = Math.hypot(...turnBetween(tcp.rotation, this.goal.rotation));
      if (distance < POSITION_TOLERANCE && angle < ROTATION_TOLERANCE) {
        this.phase += 1;
        this.elapsed = 0;
        this.start = tcp;
      }
    }
    return targets;
  }
}

/**
 * Return the position of the shake's target relative to its middle [m].
 * @param {{amplitude_m: number, frequency_hz: number}} shake @param {number} t [s]
 */
export function shakeOffset({ amplitude_m, frequency_hz }, t) {
  const angle = 2 * Math.PI * frequency_hz * t;
  return [Math.sin(angle), SHAKE_RATIO[0] * Math.sin(2 * angle), SHAKE_RATIO[1] * Math.sin(1.5 * angle)].map((part) => amplitude_m * part);
}

/** @param {number[]} from @param {number[]} to unit quaternions @param {number} part */
function slerp(from, to, part) {
  let cosine = from.reduce((sum, value, index) => sum + value * to[index], 0);
  const sign = cosine < 0 ? -1 : 1;
  cosine *= sign;
  const angle = Math.acos(Math.min(1, cosine));
  const [a, b] = angle < 1e-6 ? [1 - part, part] : [Math.sin((1 - part) * angle) / Math.sin(angle), Math.sin(part * angle) / Math.sin(angle)];
  return from.map((value, index) => a * value + sign * b * to[index]);
}

/** Return the present pose of a site. @param {import("./engine.js").Data} data @param {number} site */
export function sitePose(data, site) {
  return { position: Array.from(data.site_xpos.subarray(3 * site, 3 * site + 3)), rotation: quaternion(data.site_xmat.subarray(9 * site, 9 * site + 9)) };
}
