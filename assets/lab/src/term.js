// Add the missing term J̇ q̇ to the contact rows, as packages/contact-bias/contact_bias_c.py does.

/** Adds the term in every step of one model. */
export class Term {
  /**
   * @param {import("./engine.js").Engine} mujoco @param {import("./engine.js").Model} model
   * @param {import("./engine.js").Data} data @param {boolean} isCentred
   */
  constructor(mujoco, model, data, isCentred) {
    this.mujoco = mujoco;
    this.model = model;
    this.data = data;
    this.isCentred = isCentred;
    this.isElliptic = model.opt.cone === mujoco.mjtCone.mjCONE_ELLIPTIC.value;
    this.buffers = [0, 1].map(() => new mujoco.DoubleBuffer(3 * model.nv));
  }

  /** Run one step of the engine with the term. */
  step() {
    const { mujoco, model, data } = this;
    mujoco.mj_step1(model, data);
    const contacts = data.contact;
    for (let index = 0; index < contacts.size(); index++) {
      const contact = /** @type {import("@mujoco/mujoco").MjContact} */ (contacts.get(index));
      if (contact.efc_address >= 0) this.subtract(contact);
      contact.delete();
    }
    contacts.delete();
    mujoco.mj_step2(model, data);
  }

  /** @param {any} contact */
  subtract(contact) {
    const { model, data } = this;
    const { dim, efc_address: row, frame } = contact;
    const [linear, angular] = this.velocityProduct(contact);
    const missing = Array.from({ length: dim }, (_, axis) => {
      const vector = axis < 3 ? linear : angular;
      const at = 3 * (axis % 3);
      return frame[at] * vector[0] + frame[at + 1] * vector[1] + frame[at + 2] * vector[2];
    });
    missing[0] = 0;
    if (this.isCentred) {
      const own = this.isElliptic && contact.solreffriction.some(Boolean);
      const part = 1 - 0.5 * model.opt.timestep * damping(model.opt.timestep, own ? contact.solreffriction : contact.solref, contact.solimp);
      for (let axis = 1; axis < dim; axis++) missing[axis] *= part;
    }
    const aref = data.efc_aref;
    if (this.isElliptic || dim === 1) {
      for (let axis = 0; axis < dim; axis++) aref[row + axis] -= missing[axis];
      return;
    }
    for (let axis = 1; axis < dim; axis++) {
      const leaning = contact.friction[axis - 1] * missing[axis];
      aref[row + 2 * (axis - 1)] -= missing[0] + leaning;
      aref[row + 2 * (axis - 1) + 1] -= missing[0] - leaning;
    }
  }

  /** Return J̇ q̇ of the second geom of a contact relative to the first, in the world [m/s², rad/s²]. @param {any} contact */
  velocityProduct(contact) {
    const pos = Array.from(contact.pos);
    const [first, second] = Array.from(contact.geom, (geom) => this.model.geom_bodyid[geom]);
    const ahead = pointBias(this, second, pos);
    const behind = pointBias(this, first, pos);
    return ahead.map((vector, kind) => vector.map((value, axis) => value - behind[kind][axis]));
  }

  delete() {
    for (const buffer of this.buffers) buffer.delete();
  }
}

/**
 * Return J̇ q̇ of a point on a body: linear and angular, in the world.
 * @param {{mujoco: any, model: any, data: any, buffers: any[]}} of @param {number} body @param {number[]} pos
 */
export function pointBias({ mujoco, model, data, buffers }, body, pos) {
  if (body === 0) return [[0, 0, 0], [0, 0, 0]];
  mujoco.mj_jacDot(model, data, buffers[0], buffers[1], pos, body);
  const { nv } = model;
  const qvel = data.qvel;
  return buffers.map((buffer) => {
    const rows = buffer.GetView();
    return [0, 1, 2].map((axis) => {
      let sum = 0;
      for (let dof = 0; dof < nv; dof++) sum += rows[axis * nv + dof] * qvel[dof];
      return sum;
    });
  });
}

/**
 * Return b [1/s] of a row (MuJoCo documentation, "Solver parameters").
 * @param {number} step_s @param {ArrayLike<number>} solref @param {ArrayLike<number>} solimp
 */
export function damping(step_s, solref, solimp) {
  const dmax = Math.min(Math.max(solimp[1], 0.0001), 0.9999);
  if (solref[1] <= 0) return -solref[1] / dmax;
  return 2 / (dmax * Math.max(solref[0], 2 * step_s));
}
