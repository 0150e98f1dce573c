// Compute the numbers and the class of a run as defined in experiments/facts/metrics.py and classes.py. Here a shake may be
// slower than the lift before it, which does not occur in the cases there.

import { LIFT_PEAK_M_S } from "./task.js";

export const DROP_DISTANCE = 0.08;
const ON_GROUND = 0.025;
const DRIVE_RATIO = 10;
const DRIVE_SHAPE = Math.hypot(1, 1.3, 0.525);
const GROWTH_RATIO = 2;
const GROWTH_SPEED_RATIO = 0.1;
const FRAME_S = 1 / 60;

/**
 * Return the displacement of the cube in the TCP frame since the first frame of the shake [m], and its component along the
 * main axis of the shake.
 * @param {{cube: number[], tcp: number[], matrix: ArrayLike<number>}[]} frames of the shake; matrix is the rotation of the TCP in row order
 */
export function displacement(frames) {
  const relative = frames.map(({ cube, tcp, matrix }) => inFrame(matrix, cube.map((value, axis) => value - tcp[axis])));
  const vector = relative.map((place) => place.map((value, axis) => value - relative[0][axis]));
  const axis = frames.length ? inFrame(frames[0].matrix, [1, 0, 0]) : [1, 0, 0];
  return { vector, along: vector.map((place) => place[0] * axis[0] + place[1] * axis[1] + place[2] * axis[2]) };
}

/** @param {ArrayLike<number>} matrix @param {number[]} v */
const inFrame = (matrix, v) => [0, 1, 2].map((axis) => matrix[axis] * v[0] + matrix[3 + axis] * v[1] + matrix[6 + axis] * v[2]);

/** Return the length of the last displacement [mm]. @param {number[][]} vector */
export const slipMm = (vector) => 1e3 * Math.hypot(...vector[vector.length - 1]);

/** Return the least-squares slope per second of a series with one value per frame. @param {number[]} values */
export function slope(values) {
  const middle = (values.length - 1) / 2;
  let [up, down] = [0, 0];
  values.forEach((value, index) => {
    up += (index - middle) * value;
    down += (index - middle) ** 2;
  });
  return up / down / FRAME_S;
}

/** Return the largest speed at which the lift or the shake drives the hand [m/s]. @param {{shake_amplitude_m: number, shake_frequency_hz: number}} of */
function drivePeak({ shake_amplitude_m, shake_frequency_hz }) {
  return Math.max(LIFT_PEAK_M_S, shake_amplitude_m * 2 * Math.PI * shake_frequency_hz * DRIVE_SHAPE);
}

/**
 * Return the kinetic energy per mass [J/kg] minus the work of gravity since the first frame, at least 0.
 * @param {number[][]} positions @param {number} gravity
 */
function excessEnergy(positions, gravity) {
  return positions.slice(1).map((place, index) => {
    const before = positions[index];
    const speed = Math.hypot(...place.map((value, axis) => value - before[axis])) / FRAME_S;
    const work = -gravity * (0.5 * (place[2] + before[2]) - positions[0][2]);
    return Math.max(0, 0.5 * speed ** 2 - Math.max(0, work));
  });
}

/** @param {any} of a case @param {number[][]} relative positions of the cube relative to the TCP in the shake, in world axes */
function isEnergyGrowing(of, relative) {
  const cycle = Math.round(1 / (of.shake_frequency_hz * FRAME_S));
  const last = relative.slice(-2 * cycle - 1);
  if (last.length < 2 * cycle + 1 || Math.max(...last.map((place) => Math.hypot(...place))) > DROP_DISTANCE) return false;
  const energy = excessEnergy(last, of.gravity_m_s2);
  const mean = (/** @type {number[]} */ values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [before, after] = [mean(energy.slice(0, cycle)), mean(energy.slice(cycle))];
  return Math.sqrt(2 * after) > GROWTH_SPEED_RATIO * drivePeak(of) && after >= GROWTH_RATIO * before;
}

/** Return the speed of the cube in the grasp over the last whole period of the shake [mm/s]. @param {any} of @param {number[][]} vector */
export function creepMmS(of, vector) {
  const period = Math.min(Math.round(2 / (of.shake_frequency_hz * FRAME_S)), vector.length - 1);
  if (period < 1) return 0;
  const [last, before] = [vector[vector.length - 1], vector[vector.length - 1 - period]];
  return (1e3 * Math.hypot(...last.map((value, axis) => value - before[axis]))) / (period * FRAME_S);
}

/**
 * Return how a run ended: the first of non-finite, exploded, dropped, creeping and holding that applies.
 * @param {any} of a case
 * @param {{cube: number[][], tcp: number[][], shaken: number, failure: string}} run positions of all frames, and the first frame of the shake
 * @param {number[][]} vector displacement
 * @param {number} floor_mm_s largest creep that cannot be distinguished from zero
 */
export function classify(of, { cube, tcp, shaken, failure }, vector, floor_mm_s) {
  if (failure || ![...cube, ...tcp].flat().every(Number.isFinite)) return "non-finite";
  const energy = excessEnergy(cube, of.gravity_m_s2);
  const relative = cube.slice(shaken).map((place, index) => place.map((value, axis) => value - tcp[shaken + index][axis]));
  if (Math.sqrt(2 * Math.max(...energy)) > DRIVE_RATIO * drivePeak(of) || isEnergyGrowing(of, relative)) return "exploded";
  const [place, hand] = [cube[cube.length - 1], tcp[tcp.length - 1]];
  if (Math.hypot(...place.map((value, axis) => value - hand[axis])) > DROP_DISTANCE || place[2] < ON_GROUND) return "dropped";
  return creepMmS(of, vector) > floor_mm_s ? "creeping" : "holding";
}
