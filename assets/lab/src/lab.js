// Run lab.html: settings, runs and their comparison with the tracked ones, sweeps and the turntable.

import { find, h, HERE, isServed, written } from "./dom.js";
import { Form } from "./form.js";
import { plot } from "./plot.js";
import { coreCount, Pool } from "./pool.js";
import { CASES, CHOICES, RANGES, read, SHIPPED, write } from "./settings.js";
import { curveOf, readTracked, runOf } from "./tracked.js";
import { PLAIN } from "./turntable.js";
import { View } from "./view.js";

const SHAKE_FRAMES = 688;
const NOT_RUN = "not run yet";
const SHAKING = "shaking …";
const FRAME_S = 1 / 60;
const GROUPS = {
  Pads: [
    { name: "ke", label: "ke, stiffness" },
    { name: "kd", label: "kd, damping" },
    { name: "mu", label: "friction" },
  ],
  "Hand and cube": [
    { name: "grip_n", label: "force of each finger", unit: "N" },
    { name: "mass_g", label: "mass", unit: "g" },
    { name: "edge_mm", label: "edge", unit: "mm" },
  ],
  Shake: [
    { name: "amplitude_mm", label: "amplitude", unit: "mm" },
    { name: "frequency_hz", label: "frequency", unit: "Hz" },
    { name: "gravity_m_s2", label: "gravity", unit: "m/s²" },
  ],
  Solver: [
    { name: "substeps", label: "steps per frame" },
    { name: "impratio", label: "impratio" },
    { name: "cone", label: "cone" },
    { name: "integrator", label: "integrator" },
    { name: "term", label: "the left-out term" },
  ],
};
/** @type {Record<string, [number, number, boolean]>} */
const TURN_RANGES = { turn_rad_s: [0.5, 4, false], radius_m: [0.05, 0.4, false], timeconst_s: [0.002, 0.05, true], step_s: [0.0005, 0.008, true], impratio: [1, 1000, true] };
const TURN_GROUPS = {
  Table: [
    { name: "turn_rad_s", label: "ω", unit: "rad/s" },
    { name: "radius_m", label: "radius", unit: "m" },
  ],
  Contact: [
    { name: "timeconst_s", label: "timeconst", unit: "s" },
    { name: "impratio", label: "impratio" },
    { name: "cone", label: "cone" },
  ],
  Steps: [
    { name: "step_s", label: "time step", unit: "s" },
    { name: "integrator", label: "integrator" },
    { name: "term", label: "the left-out term" },
  ],
};
const SHOWN = [
  ["slip", "slip_mm", "mm"],
  ["drift", "drift_mm_s", "mm/s"],
  ["drift predicted by the law", "predicted_drift_mm_s", "mm/s"],
  ["depth of the contacts", "penetration_mm", "mm"],
  ["largest share of friction used", "cone_use", "of 1"],
  ["time of a step", "step_ms", "ms"],
];
/** Names and colours of the tracked curves behind the reader's own curve. */
const BEHIND = { "as-shipped": "--series-2", "stiff-pads": "--series-1" };

const place = find("#lab-bench");
if (place) begin();

/** @param {() => Promise<void>} work @param {HTMLElement} said */
async function guarded(work, said) {
  try {
    await work();
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    said.textContent = message === "cancelled" ? "Cancelled." : `The run failed: ${message}.`;
  }
}

function begin() {
  place.hidden = false;
  if (!isServed || typeof WebAssembly !== "object") {
    const why = isServed ? "This browser has no WebAssembly" : "A page that is opened from a file cannot load the engine";
    place.append(h("p", { id: "lab-status" }, `${why}. The tracked runs are below.`));
    return;
  }
  const pool = new Pool(new URL("worker.js", HERE), coreCount());
  const form = new Form("lab-form", GROUPS, RANGES, CHOICES, SHIPPED);
  const run = h("button", { id: "lab-run", type: "submit", form: "lab-form", class: "lab-main" }, "Run");
  const cancel = h("button", { id: "lab-cancel", type: "button", disabled: true, click: () => pool.cancel() }, "Cancel");
  const link = h("button", { id: "lab-link", type: "button", click: () => copy(link, location.href) }, "Copy link");
  const cases = Object.entries(CASES).map(([name, changes]) => h("button", { type: "button", click: () => (form.set({ ...SHIPPED, ...changes }), start()) }, name));
  const slip = h("output", { id: "lab-slip", "aria-live": "polite" }, NOT_RUN);
  const status = h("p", { id: "lab-status", role: "status" });
  const view = new View(h("div", { id: "lab-stage", hidden: true }, h("canvas", { tabindex: 0, role: "img", "aria-label": "The arm and the cube in 3D. The arrow keys turn the view, and plus and minus zoom." })));
  const svg = curveElement("Displacement of the cube in the hand over the time of the shake");
  const results = h("div", { id: "lab-results" });
  const shared = h("div", { id: "lab-shared" });
  const hint = h("p", {}, "Press Run, or change the settings first. The engine is then loaded once, and no data leave your browser.");
  const set = h("div", {}, h("div", { class: "lab-cases", role: "group", "aria-label": "Named settings" }, ...cases), form.element);
  const said = h("p", { class: "lab-actions" }, run, cancel, link, slip);
  const drawn = h("div", { class: "lab-shown" }, view.element, h("figure", {}, svg, h("figcaption", {}, legend())));
  place.append(hint, h("div", { class: "lab-bench" }, set, h("div", { class: "lab-found" }, said, status, drawn, results, shared)));
  form.set(read(location.hash.slice(1)));
  form.element.addEventListener("submit", (/** @type {Event} */ event) => (event.preventDefault(), start()));
  sweepInto(pool, form);
  turntableInto(pool);

  function start() {
    guarded(measure, status).finally(() => {
      run.disabled = false;
      cancel.disabled = true;
      if (slip.textContent === SHAKING) slip.textContent = NOT_RUN; // the run was cancelled or failed
    });
  }

  async function measure() {
    const settings = read(form.query);
    form.set(settings);
    history.replaceState(null, "", `#${write(settings)}`);
    run.disabled = true;
    slip.textContent = SHAKING;
    delete slip.dataset.slipMm;
    delete slip.dataset.class;
    for (const element of [results, shared]) element.replaceChildren();
    status.textContent = "";
    const tracked = await readTracked();
    const behind = await Promise.all(Object.entries(BEHIND).map(async ([name, colour]) => ({ name, colour, points: await curveOf(tracked, name), isFaint: true })));
    /** @type {[number, number][]} */
    const points = [];
    const draw = () => plot(svg, [...behind, { name: "this run", colour: "--series-3", points }], { x: "time of the shake [s]", y: "displacement [mm]" });
    draw();
    view.begin(settings.edge_mm / 1e3);
    cancel.disabled = false; // there is nothing to cancel before
    const how = { shakeFrames: SHAKE_FRAMES, floor_mm_s: tracked.rows[0].creep_floor_mm_s };
    const row = await pool.run({ kind: "shake", mjcf: tracked.mjcf, settings, how }, ({ frames, shaken }) => {
      for (const moved of view.add(frames, shaken)) points.push([points.length * FRAME_S, moved]);
      if (!isStill()) draw();
    });
    view.end();
    draw();
    slip.dataset.slipMm = row.slip_mm;
    slip.dataset.class = row.class;
    slip.textContent = verdict(row);
    results.replaceChildren(table(row, runOf(tracked, settings)));
    shared.replaceChildren(...sharing(row, settings));
  }
}

const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** @param {any} row */
function verdict(row) {
  if (row.class === "dropped") return "The cube falls out of the hand.";
  if (row.class === "creeping" || row.class === "holding") return `The cube slips ${written(row.slip_mm, "mm")}.`;
  return `Not valid: ${row.reason}.`;
}

function legend() {
  const key = (/** @type {string} */ colour, /** @type {string} */ text) => h("span", { class: "key" }, h("i", { style: `background: var(${colour})` }), text);
  return h("span", {}, key("--series-3", "this run"), key("--series-2", "tracked, as shipped"), key("--series-1", "tracked, stiff pads"));
}

/** @param {string} label */
function curveElement(label) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", label);
  svg.setAttribute("class", "lab-plot");
  return svg;
}

/** @param {any} row @param {any} tracked */
function table(row, tracked) {
  const head = h("tr", {}, h("th", { scope: "col" }, "number"), h("th", { scope: "col" }, "here"), h("th", { scope: "col" }, "tracked, through C"));
  const lines = SHOWN.map(([label, name, unit]) => h("tr", {}, h("th", { scope: "row" }, label), h("td", {}, written(row[name], unit)), h("td", {}, tracked ? written(tracked[name], unit) : "–")));
  lines.push(h("tr", {}, h("th", { scope: "row" }, "class"), h("td", {}, row.class), h("td", {}, tracked?.class ?? "–")));
  return h("div", { class: "wide" }, h("table", {}, h("thead", {}, head), h("tbody", {}, ...lines)));
}

/** @param {any} row @param {import("./settings.js").Settings} settings */
function sharing(row, settings) {
  const json = JSON.stringify(row, null, 1);
  const python = newtonLines(settings);
  const block = (/** @type {string} */ title, /** @type {string} */ text) => {
    const button = h("button", { type: "button", click: () => copy(button, text) }, "Copy");
    return h("details", {}, h("summary", {}, title), button, h("pre", { tabindex: 0 }, h("code", {}, text)));
  };
  return [block("The row, as JSON with the records' columns", json), block("The same in Newton", python)];
}

/** Return the code that makes the same settings in Newton. @param {import("./settings.js").Settings} settings */
function newtonLines({ ke, kd, mu, impratio, cone, integrator, substeps }) {
  return [
    "for shape in pads:  # shapes of the two fingers",
    `    builder.shape_material_ke[shape] = ${ke}`,
    `    builder.shape_material_kd[shape] = ${kd}`,
    `    builder.shape_material_mu[shape] = ${mu}`,
    `solver = SolverMuJoCo(model, cone="${cone}", impratio=${impratio}, integrator="${integrator.toLowerCase()}")`,
    `substep_dt = 1 / 60 / ${substeps}`,
  ].join("\n");
}

/** @param {HTMLButtonElement} button @param {string} text */
async function copy(button, text) {
  const label = button.textContent;
  await navigator.clipboard.writeText(text).then(
    () => (button.textContent = "Copied"),
    () => (button.textContent = "Not allowed here"),
  );
  setTimeout(() => (button.textContent = label), 1500);
}

/** @param {Pool} pool @param {Form} form */
function sweepInto(pool, form) {
  const sweep = find("#lab-sweep");
  const controls = Object.values(GROUPS).flat().filter(({ name }) => name in RANGES);
  const which = h("select", { id: "sweep-control" }, ...controls.map(({ name, label }) => h("option", { value: name, selected: name === "kd" }, label)));
  const count = h("input", { id: "sweep-count", type: "number", min: 8, max: 16, value: 12 });
  const run = h("button", { id: "sweep-run", type: "button" }, "Run the sweep");
  const status = h("p", { id: "sweep-status", role: "status" });
  const svg = curveElement("Slip over the control that is swept");
  sweep.append(h("p", { class: "lab-actions" }, h("label", { for: "sweep-control" }, "Sweep"), which, h("label", { for: "sweep-count" }, "runs"), count, run), status, h("figure", {}, svg));
  sweep.hidden = false;
  run.addEventListener("click", () =>
    guarded(async () => {
      run.disabled = true;
      const name = which.value;
      const [least, most, isLog] = RANGES[name];
      const size = Math.round(Math.min(Math.max(Number(count.value), 8), 16));
      const values = Array.from({ length: size }, (_, index) => (isLog ? least * (most / least) ** (index / (size - 1)) : least + ((most - least) * index) / (size - 1)));
      const { mjcf, rows } = await readTracked();
      const how = { shakeFrames: SHAKE_FRAMES, floor_mm_s: rows[0].creep_floor_mm_s };
      const chosen = values.map((value) => read(`${form.query}&${name}=${value}`.replace(new RegExp(`(^|&)${name}=[^&]*(?=.*&${name}=)`), "")));
      /** @type {any[]} */
      const found = [];
      await pool.runAll(
        chosen.map((settings) => ({ kind: "shake", mjcf, settings, how })),
        (index, row) => {
          found[index] = row;
          status.textContent = `${found.filter(Boolean).length} of ${size} done`;
          showSweep(svg, { name, isLog, chosen, found });
        },
      );
      const kept = found.filter((row) => row.class === "creeping" || row.class === "holding");
      status.textContent = `${kept.length} of ${size} runs keep the cube${kept.length < size ? "; the others have no point" : ""}.`;
    }, status).finally(() => (run.disabled = false)),
  );
}

/** @param {SVGElement} svg @param {any} sweep */
function showSweep(svg, { name, isLog, chosen, found }) {
  const at = (/** @type {(row: any) => number} */ value) => found.flatMap((/** @type {any} */ row, /** @type {number} */ index) => (row && (row.class === "creeping" || row.class === "holding") ? [[chosen[index][name], value(row)]] : []));
  const law = at((row) => Math.abs(row.predicted_drift_mm_s) * row.shake_duration_s);
  const series = [
    { name: "predicted by the law", colour: "--series-6", points: law },
    { name: "slip", colour: "--series-3", points: at((row) => row.slip_mm), isLine: false },
  ];
  plot(svg, series, { x: name, y: "slip [mm]; line: predicted by the law", isLog });
}

/** @param {Pool} pool */
function turntableInto(pool) {
  const table = find("#lab-turntable");
  const form = new Form("turn-form", TURN_GROUPS, TURN_RANGES, CHOICES, PLAIN);
  const run = h("button", { id: "turn-run", type: "submit", form: "turn-form" }, "Turn the table");
  const growth = h("output", { id: "turn-growth", "aria-live": "polite" }, NOT_RUN);
  table.append(form.element, h("p", { class: "lab-actions" }, run, growth));
  table.hidden = false;
  form.element.addEventListener("submit", (/** @type {Event} */ event) => {
    event.preventDefault();
    guarded(async () => {
      const said = new URLSearchParams(form.query);
      const numbers = Object.entries(TURN_RANGES).map(([name, [least, most]]) => [name, Math.min(Math.max(Number(said.get(name)) || least, least), most)]);
      const names = ["cone", "integrator", "term"].map((name) => [name, said.get(name)]);
      const row = await pool.run({ kind: "turntable", settings: Object.fromEntries([...numbers, ...names]) });
      growth.dataset.growthPerS = row.growth_per_s;
      growth.textContent = row.reason ? `Not valid: ${row.reason}.` : `The radius grows by ${written(100 * row.growth_per_s, "% per second")}; the law predicts ${written(100 * row.predicted_growth_per_s, "%")}.`;
    }, growth);
  });
}
