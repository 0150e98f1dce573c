// Run the shake test in the engine, frame by frame.

import { ArmSolver } from "./ik.js";
import { classify, creepMmS, displacement, slipMm, slope } from "./metrics.js";
import { caseOf } from "./settings.js";
import { FINGER_OPEN, FRAME_RATE, PHASE, READY, sitePose, Task } from "./task.js";
import { damping, pointBias, Term } from "./term.js";

const SETUP_FRAME_LIMIT = 600;
const PAD_DMAX = 0.95;
const CUBE_PLACE = [0, -0.44];

/** The shake of one case, which can be run in parts. */
export class Shake {
  /**
   * @param {import("./engine.js").Engine} mujoco
   * @param {string} mjcf the scene
   * @param {import("./settings.js").Settings} settings
   * @param {number} shakeFrames number of frames in the shake
   */
  constructor(mujoco, mjcf, settings, shakeFrames) {
    this.mujoco = mujoco;
    this.case = caseOf(settings);
    this.shakeFrames = shakeFrames;
    const model = (this.model = mujoco.MjModel.from_xml_string(mjcf));
    applyCase(mujoco, model, this.case);
    const data = (this.data = new mujoco.MjData(model));
    this.site = model.site("tcp").id;
    this.hand = model.site_bodyid[this.site];
    this.cube = model.body("cube").id;
    this.solver = new ArmSolver(mujoco, model, READY);
    const start = [...CUBE_PLACE, this.case.cube_edge_m / 2];
    const { shake_amplitude_m: amplitude_m, shake_frequency_hz: frequency_hz, finger_closed_m } = this.case;
    this.task = new Task(this.solver, { amplitude_m, frequency_hz, finger_closed_m }, start);
    data.qpos.set([...this.task.angles, FINGER_OPEN, FINGER_OPEN, ...start, 1, 0, 0, 0]);
    data.ctrl.set([...this.task.angles, FINGER_OPEN, FINGER_OPEN]);
    mujoco.mj_kinematics(model, data);
    this.task.start = sitePose(data, this.site);
    this.term = new Term(mujoco, model, data, this.case.bias_centred);
    /** @type {{cube: number[], turn: number[], tcp: number[], matrix: number[], joints: number[]}[]} */
    this.frames = [];
    /** @type {number[]} */
    this.axis = [1, 0, 0];
    this.shaken = -1;
    this.leftOut = 0; // ∫ J̇ q̇ dt of the cube's point relative to the hand's, along the main axis [m/s]
    /** @type {number[]} */
    this.leftOuts = [];
    this.force = new mujoco.DoubleBuffer(6);
    this.coneUse = 0;
    this.failure = "";
    this.engine_ms = 0;
    this.stepCount = 0;
    this.task.plan(this.cubePlace());
  }

  get isDone() {
    const over = this.shaken >= 0 ? this.frames.length - this.shaken >= this.shakeFrames : this.frames.length >= SETUP_FRAME_LIMIT;
    return Boolean(this.failure) || over;
  }

  cubePlace() {
    return Array.from(this.data.xpos.subarray(3 * this.cube, 3 * this.cube + 3));
  }

  /** Run the next frame. */
  frame() {
    const { mujoco, model, data, task, site } = this;
    data.ctrl.set(task.command(sitePose(data, site)));
    task.plan(this.cubePlace());
    const begun = performance.now();
    for (let step = 0; step < this.case.substeps; step++) {
      if (this.case.contact_bias) this.term.step();
      else mujoco.mj_step(model, data);
    }
    this.engine_ms += performance.now() - begun;
    this.stepCount += this.case.substeps;
    mujoco.mj_kinematics(model, data);
    const matrix = Array.from(data.site_xmat.subarray(9 * site, 9 * site + 9));
    const tcp = Array.from(data.site_xpos.subarray(3 * site, 3 * site + 3));
    const turn = Array.from(data.xquat.subarray(4 * this.cube, 4 * this.cube + 4));
    this.frames.push({ cube: this.cubePlace(), turn, tcp, matrix, joints: Array.from(data.qpos.subarray(0, 9)) });
    this.failure = failureOf(data, this.frames.length - 1);
    if (task.phase === PHASE.shake) this.watch(matrix);
  }

  /** Add the causes of the cube's motion in the shake. @param {number[]} matrix of the TCP */
  watch(matrix) {
    if (this.shaken < 0) {
      this.shaken = this.frames.length - 1;
      this.axis = [matrix[0], matrix[1], matrix[2]]; // the main axis, x of the world, in the TCP's frame
    }
    const place = this.cubePlace();
    const [hand, cube] = [this.hand, this.cube].map((body) => pointBias(this.term, body, place)[0]);
    const missing = cube.map((value, axis) => value - hand[axis]);
    const inHand = [0, 1, 2].map((axis) => matrix[axis] * missing[0] + matrix[3 + axis] * missing[1] + matrix[6 + axis] * missing[2]);
    this.leftOut += inHand.reduce((sum, value, axis) => sum + value * this.axis[axis], 0) / FRAME_RATE;
    this.leftOuts.push(this.leftOut);
    this.coneUse = Math.max(this.coneUse, this.coneUseNow());
  }

  /** Return the largest ratio of tangential force to friction times normal force of a contact. */
  coneUseNow() {
    const { mujoco, model, data } = this;
    const { force } = this;
    const contacts = data.contact;
    let largest = 0;
    for (let index = 0; index < contacts.size(); index++) {
      const contact = /** @type {import("@mujoco/mujoco").MjContact} */ (contacts.get(index));
      mujoco.mj_contactForce(model, data, index, force);
      const [normal, one, other] = force.GetView();
      if (normal > 0) largest = Math.max(largest, Math.hypot(one, other) / (contact.friction[0] * normal));
      contact.delete();
    }
    contacts.delete();
    return largest;
  }

  /** Return the present mean depth of the loaded contacts [mm]. */
  penetrationMm() {
    const contacts = this.data.contact;
    const depths = [];
    for (let index = 0; index < contacts.size(); index++) {
      const contact = /** @type {import("@mujoco/mujoco").MjContact} */ (contacts.get(index));
      if (contact.efc_address >= 0 && contact.dist < 0) depths.push(-1e3 * contact.dist);
      contact.delete();
    }
    contacts.delete();
    return depths.length ? depths.reduce((sum, depth) => sum + depth, 0) / depths.length : null;
  }

  /** Return the results of the run, in the columns of the records. @param {number} floor_mm_s */
  row(floor_mm_s) {
    const frames = this.shaken < 0 ? [] : this.frames.slice(this.shaken);
    const { vector, along } = displacement(frames);
    const run = { cube: this.frames.map((frame) => frame.cube), tcp: this.frames.map((frame) => frame.tcp), shaken: Math.max(this.shaken, 0), failure: this.failure };
    const kind = this.shaken < 0 && !this.failure ? "dropped" : classify(this.case, run, vector, floor_mm_s);
    const isKept = kind === "creeping" || kind === "holding";
    const reason = isKept ? "" : this.failure || `the run ended as ${kind}`;
    const numbers = {
      slip_mm: frames.length && kind !== "non-finite" ? slipMm(vector) : null,
      drift_mm_s: isKept ? 1e3 * slope(along) : null,
      creep_mm_s: isKept ? creepMmS(this.case, vector) : null,
      penetration_mm: isKept ? this.penetrationMm() : null,
      cone_use: isKept ? this.coneUse : null,
      predicted_drift_mm_s: isKept ? this.predictedDriftMmS() : null,
    };
    return { ...this.case, class: kind, dropped: kind === "dropped", ...numbers, reason, step_ms: this.engine_ms / this.stepCount, shake_duration_s: frames.length / FRAME_RATE };
  }

  /** Return the drift that the law predicts, ½ (dmax · timeconst − h) J̇ q̇; with the term, only the remaining part [mm/s]. */
  predictedDriftMmS() {
    const h = this.model.opt.timestep;
    const b = damping(h, this.solref, [0, PAD_DMAX]);
    const left = this.case.contact_bias ? (this.case.bias_centred ? 0.5 * h * b : 0) : 1;
    const { integrator } = this.case;
    const step = { RK4: 0, discrete: -0.5 * h }[integrator] ?? 0.5 * h;
    return 1e3 * (left / b - step) * slope(this.leftOuts);
  }

  get solref() {
    return padSolref(this.case);
  }

  delete() {
    this.term.delete();
    this.solver.delete();
    this.force.delete();
    this.data.delete();
    this.model.delete();
  }
}

/** Return the timeconst [s] and the damping ratio that Newton computes from ke and kd. @param {{pad_ke: number, pad_kd: number}} of */
export const padSolref = ({ pad_ke, pad_kd }) => [2 / pad_kd, pad_kd / (2 * Math.sqrt(pad_ke))];

/**
 * Write a case into a model of the scene as shipped.
 * @param {import("./engine.js").Engine} mujoco @param {import("./engine.js").Model} model @param {any} of
 */
function applyCase(mujoco, model, of) {
  const { opt } = model;
  opt.timestep = 1 / FRAME_RATE / of.substeps;
  opt.impratio = of.impratio;
  opt.cone = numberOf(mujoco.mjtCone, `mjCONE_${of.cone.toUpperCase()}`);
  opt.integrator = numberOf(mujoco.mjtIntegrator, `mjINT_${of.integrator.toUpperCase()}`);
  opt.gravity.set([0, 0, -of.gravity_m_s2]);
  const cube = model.body("cube").id;
  for (let geom = 0; geom < model.ngeom; geom++) {
    if (model.geom_priority[geom] > 0) {
      model.geom_solref.set(padSolref(of), 2 * geom);
      model.geom_friction[3 * geom] = of.pad_mu;
    }
    if (model.geom_bodyid[geom] === cube) {
      const half = of.cube_edge_m / 2;
      model.geom_size.set([half, half, half], 3 * geom);
      model.geom_rbound[geom] = half * Math.sqrt(3);
      model.geom_aabb.set([half, half, half], 6 * geom + 3);
    }
  }
  const mass = of.cube_density_kg_m3 * of.cube_edge_m ** 3;
  model.body_mass[cube] = mass;
  model.body_inertia.fill((mass * of.cube_edge_m ** 2) / 6, 3 * cube, 3 * cube + 3);
  const data = new mujoco.MjData(model);
  mujoco.mj_setConst(model, data);
  data.delete();
}

/** Return the value of a name in the engine. @param {any} names @param {string} name @returns {number} */
export const numberOf = (names, name) => names[name].value;

/** @param {import("./engine.js").Data} data @param {number} frame */
function failureOf(data, frame) {
  if (data.qpos.every(Number.isFinite) && data.qvel.every(Number.isFinite) && !isReset(data)) return "";
  return `not finite in frame ${frame}`;
}

/** Return whether the engine was reset, which happens if a number is not finite. @param {import("./engine.js").Data} data */
function isReset(data) {
  return data.time === 0;
}
