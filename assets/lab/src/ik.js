// Compute the inverse kinematics of the arm with the steps of experiments/simulation/arm_ik.py: δ = −Jᵀ (J Jᵀ + λ 1)⁻¹ r.

const LAMBDA = { initial: 0.1, factor: 2, least: 1e-5, most: 1e10 };
const LEAST_GAIN = 1e-3;
const ARM_DOF_COUNT = 7;

/** Move the arm of a model in a separate state. */
export class ArmSolver {
  /**
   * @param {import("./engine.js").Engine} mujoco
   * @param {import("./engine.js").Model} model
   * @param {number[]} ready initial coordinates [rad]
   */
  constructor(mujoco, model, ready) {
    this.mujoco = mujoco;
    this.model = model;
    this.data = new mujoco.MjData(model);
    this.site = model.site("tcp").id;
    this.jacobian = [0, 1].map(() => new mujoco.DoubleBuffer(3 * model.nv));
    this.angles = ready.slice(0, ARM_DOF_COUNT);
  }

  /**
   * Take some steps towards a pose of the TCP, from the end of the last call.
   * @param {number[]} position [m]
   * @param {number[]} rotation unit quaternion (w, x, y, z)
   * @param {number} iterations
   * @returns {number[]} angles [rad]
   */
  step(position, rotation, iterations) {
    let here = this.residual(this.angles, position, rotation);
    let damping = LAMBDA.initial;
    for (let count = 0; count < iterations; count++) {
      const x = solved(here.columns, damping, here.off);
      let predicted = 0;
      const there = this.angles.map((angle, joint) => {
        const step = -dot(here.columns[joint], x);
        predicted += 0.5 * step * (damping * step - dot(here.columns[joint], here.off));
        return angle + step;
      });
      const next = this.residual(there, position, rotation);
      const gain = 0.5 * (dot(here.off, here.off) - dot(next.off, next.off));
      if (gain >= LEAST_GAIN * (predicted + 1e-8)) {
        this.angles = there;
        here = next;
        damping /= LAMBDA.factor;
      } else {
        damping = Math.min(Math.max(damping * LAMBDA.factor, LAMBDA.least), LAMBDA.most);
      }
    }
    return this.angles;
  }

  /**
   * Return the error of the TCP's position and its rotation vector, and the columns of its Jacobian.
   * @param {number[]} angles
   * @param {number[]} position
   * @param {number[]} rotation
   */
  residual(angles, position, rotation) {
    const { mujoco, model, data, site, jacobian } = this;
    data.qpos.set(angles);
    mujoco.mj_kinematics(model, data);
    mujoco.mj_comPos(model, data);
    mujoco.mj_jacSite(model, data, jacobian[0], jacobian[1], site);
    const [linear, angular] = jacobian.map((buffer) => buffer.GetView());
    const place = data.site_xpos.subarray(3 * site, 3 * site + 3);
    const turn = turnBetween(quaternion(data.site_xmat.subarray(9 * site, 9 * site + 9)), rotation);
    const off = [0, 1, 2].map((axis) => place[axis] - position[axis]).concat(turn);
    const nv = model.nv;
    const columns = angles.map((_, dof) => [0, 1, 2].map((row) => linear[row * nv + dof]).concat([0, 1, 2].map((row) => angular[row * nv + dof])));
    return { off, columns };
  }

  delete() {
    for (const each of [...this.jacobian, this.data]) each.delete();
  }
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function dot(a, b) {
  let sum = 0;
  for (let index = 0; index < a.length; index++) sum += a[index] * b[index];
  return sum;
}

/**
 * Return the x for which (J Jᵀ + λ 1) x = r, by Cholesky's decomposition.
 * @param {number[][]} columns @param {number} damping @param {number[]} right
 */
function solved(columns, damping, right) {
  const size = right.length;
  const lower = right.map(() => Array(size).fill(0));
  for (let i = 0; i < size; i++) {
    for (let j = 0; j <= i; j++) {
      let rest = i === j ? damping : 0;
      for (const column of columns) rest += column[i] * column[j];
      for (let k = 0; k < j; k++) rest -= lower[i][k] * lower[j][k];
      lower[i][j] = i === j ? Math.sqrt(rest) : rest / lower[j][j];
    }
  }
  const x = [...right];
  for (let i = 0; i < size; i++) {
    for (let k = 0; k < i; k++) x[i] -= lower[i][k] * x[k];
    x[i] /= lower[i][i];
  }
  for (let i = size - 1; i >= 0; i--) {
    for (let k = i + 1; k < size; k++) x[i] -= lower[k][i] * x[k];
    x[i] /= lower[i][i];
  }
  return x;
}

/**
 * Return the rotation vector [rad] between two unit quaternions (w, x, y, z).
 * @param {number[]} now @param {number[]} wanted
 */
export function turnBetween(now, wanted) {
  const [w, x, y, z] = now;
  const [a, b, c, d] = [wanted[0], -wanted[1], -wanted[2], -wanted[3]];
  let off = [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c, w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a];
  if (off[0] < 0) off = off.map((value) => -value);
  const vector = off.slice(1);
  const length = Math.hypot(...vector);
  const scale = length > 1e-8 ? (2 * Math.atan2(length, off[0])) / length : 2;
  return vector.map((value) => scale * value);
}

/**
 * Return the unit quaternion (w, x, y, z) of a rotation matrix in row order.
 * @param {ArrayLike<number>} m
 */
export function quaternion(m) {
  const trace = m[0] + m[4] + m[8];
  if (trace > 0) {
    const s = 2 * Math.sqrt(trace + 1);
    return [s / 4, (m[7] - m[5]) / s, (m[2] - m[6]) / s, (m[3] - m[1]) / s];
  }
  const i = m[0] > m[4] && m[0] > m[8] ? 0 : m[4] > m[8] ? 1 : 2;
  const [j, k] = [(i + 1) % 3, (i + 2) % 3];
  const s = 2 * Math.sqrt(1 + m[4 * i] - m[4 * j] - m[4 * k]);
  const q = [(m[3 * k + j] - m[3 * j + k]) / s, 0, 0, 0];
  q[1 + i] = s / 4;
  q[1 + j] = (m[3 * j + i] + m[3 * i + j]) / s;
  q[1 + k] = (m[3 * k + i] + m[3 * i + k]) / s;
  return q;
}
