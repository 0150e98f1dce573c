// Measure how fast a box on a turning table walks outward, and compare it with the law, as experiments/cure/turntable.py does.

import { numberOf } from "./shake.js";
import { damping, Term } from "./term.js";

const MASS_KG = 0.2;
const SECONDS = 6;
const SETTLE_S = 1;
const SAMPLE_S = 0.1;
const FEET = [
  [0.04, 0.04],
  [0.04, -0.04],
  [-0.04, 0.04],
  [-0.04, -0.04],
];

/**
 * @typedef {Object} Turning
 * @property {number} turn_rad_s
 * @property {number} radius_m
 * @property {number} timeconst_s
 * @property {number} step_s
 * @property {number} impratio
 * @property {string} integrator
 * @property {string} cone
 * @property {string} term off, on, centred
 */

/** @type {Turning} */
export const PLAIN = { turn_rad_s: 2, radius_m: 0.2, timeconst_s: 0.02, step_s: 0.002, impratio: 1, integrator: "implicitfast", cone: "elliptic", term: "off" };

/** @param {Turning} turning */
const mjcf = ({ radius_m, timeconst_s, step_s, impratio, cone }) => `<mujoco>
<option timestep="${step_s}" cone="${cone}" impratio="${impratio}"/>
<default><geom solref="${timeconst_s} 1"/></default>
<worldbody>
<body><joint axis="0 0 1" armature="1000"/><geom type="box" size="0.5 0.5 0.05"/></body>
<body pos="${radius_m} 0 0.1"><freejoint/>
<geom type="box" size="0.05 0.05 0.04" mass="${MASS_KG}" contype="0" conaffinity="0"/>
${FEET.map(([x, y]) => `<geom type="sphere" size="0.01" pos="${x} ${y} -0.04" mass="0"/>`).join("\n")}
</body>
</worldbody>
</mujoco>`;

/**
 * Return the measured and the predicted growth of the box's distance from the axis [1/s]; null with a reason if the box
 * leaves the table.
 * @param {import("./engine.js").Engine} mujoco @param {Turning} turning
 */
export function turntable(mujoco, turning) {
  const model = mujoco.MjModel.from_xml_string(mjcf(turning));
  model.opt.integrator = numberOf(mujoco.mjtIntegrator, `mjINT_${turning.integrator.toUpperCase()}`);
  const data = new mujoco.MjData(model);
  const { turn_rad_s: turn, radius_m, step_s } = turning;
  data.qvel.set([turn, 0, turn * radius_m, 0, 0, 0, turn]);
  mujoco.mj_forward(model, data);
  const term = new Term(mujoco, model, data, turning.term === "centred");
  try {
    /** @type {[number, number][]} */
    const path = [];
    for (let sample = 0; sample <= Math.round(SECONDS / SAMPLE_S); sample++) {
      for (let step = 0; sample && step < Math.round(SAMPLE_S / step_s); step++) {
        if (turning.term === "off") mujoco.mj_step(model, data);
        else term.step();
      }
      path.push([sample * SAMPLE_S, Math.hypot(data.qpos[1], data.qpos[2])]);
    }
    const loaded = loadedContacts(mujoco, model, data);
    if (!path.every(([, radius]) => Number.isFinite(radius))) return { growth_per_s: null, reason: "not finite" };
    if (!loaded.count) return { growth_per_s: null, reason: "nothing is touched at the end" };
    return { growth_per_s: growth(path), predicted_growth_per_s: predicted(turning, model, loaded.softness), path, reason: "" };
  } finally {
    for (const each of [term, data, model]) each.delete();
  }
}

/** Return the slope of the logarithm of the distance after the box has settled. @param {[number, number][]} path */
function growth(path) {
  const points = path.filter(([time]) => time >= SETTLE_S - 1e-9).map(([time, radius]) => [time, Math.log(radius)]);
  const [x, y] = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / points.length);
  return points.reduce((sum, [time, log]) => sum + (time - x) * (log - y), 0) / points.reduce((sum, [time]) => sum + (time - x) ** 2, 0);
}

/**
 * Return the number of contacts that carry force, and R / n of their friction rows [1/kg].
 * @param {import("./engine.js").Engine} mujoco @param {import("./engine.js").Model} model @param {import("./engine.js").Data} data
 */
function loadedContacts(mujoco, model, data) {
  const force = new mujoco.DoubleBuffer(6);
  const contacts = data.contact;
  const isElliptic = model.opt.cone === mujoco.mjtCone.mjCONE_ELLIPTIC.value;
  const rows = [];
  for (let index = 0; index < contacts.size(); index++) {
    const contact = /** @type {import("@mujoco/mujoco").MjContact} */ (contacts.get(index));
    mujoco.mj_contactForce(model, data, index, force);
    if (contact.efc_address >= 0 && force.GetView()[0] > 0) {
      const row = contact.efc_address;
      // In a pyramid, two edges form a direction, and each of them yields by μ².
      rows.push(isElliptic ? data.efc_R[row + 1] : data.efc_R[row] / (2 * contact.friction[0] ** 2));
    }
    contact.delete();
  }
  for (const each of [contacts, force]) each.delete();
  return { count: rows.length, softness: rows.reduce((sum, value) => sum + value, 0) / rows.length ** 2 };
}

/** Return the growth by the law of experiments/cure/turntable.py. @param {Turning} turning @param {import("./engine.js").Model} model @param {number} softness_1_kg */
function predicted({ turn_rad_s: turn, step_s: h, integrator, term }, model, softness_1_kg) {
  const b = damping(h, model.geom_solref.slice(0, 2), model.geom_solimp.slice(0, 5));
  const left = { off: 1, on: 0, centred: 0.5 * h * b }[term] ?? 1;
  const step = { RK4: 0, discrete: -0.5 * h }[integrator] ?? 0.5 * h;
  return turn ** 2 * ((left + MASS_KG * softness_1_kg) / b - step) * (1 - 5 * (turn / b) ** 2);
}
