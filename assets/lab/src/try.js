// The trial on the front page: one number to change, the slip that the law predicts, a button, and the measured slip.

import { find, h, HERE, isServed, written } from "./dom.js";
import { Pool } from "./pool.js";
import { RANGES, read, SHIPPED } from "./settings.js";
import { readTracked } from "./tracked.js";

const SHAKE_FRAMES = 688;

const place = find("#try");
if (place && isServed) begin();

function begin() {
  const [least, most] = RANGES.kd;
  const kd = h("input", { id: "try-kd", type: "range", min: 0, max: 1, step: 0.001, value: position(SHIPPED.kd), "aria-label": "kd of the pads" });
  const said = h("output", { for: "try-kd" });
  const slip = h("output", { id: "try-slip", "aria-live": "polite" });
  const run = h("button", { id: "try-run", type: "button" }, "Run");
  const value = () => Number((least * (most / least) ** Number(kd.value)).toPrecision(2));
  const law = lawOf(place);
  const tell = () => {
    said.textContent = `kd = ${value()}${law ? `: the law predicts ${written(law(value()), "mm")}` : ""}`;
    slip.textContent = ""; // the measured slip belongs to another kd
  };
  kd.addEventListener("input", tell);
  tell();
  const pool = new Pool(new URL("worker.js", HERE), 1);
  run.addEventListener("click", async () => {
    const wanted = value();
    run.disabled = true;
    slip.textContent = "shaking …";
    try {
      const { mjcf, rows } = await readTracked();
      const how = { shakeFrames: SHAKE_FRAMES, floor_mm_s: rows[0].creep_floor_mm_s };
      const row = await pool.run({ kind: "shake", mjcf, settings: read(`kd=${wanted}`), how });
      slip.dataset.slipMm = row.slip_mm;
      slip.dataset.class = row.class;
      const found = row.class === "dropped" ? "it falls out" : row.slip_mm === null ? row.reason : `slips ${written(row.slip_mm, "mm")}`;
      slip.textContent = wanted === value() ? found : `kd = ${wanted}: ${found}`;
    } catch (error) {
      slip.textContent = error instanceof Error ? error.message : String(error);
    }
    run.disabled = false;
  });
  place.append(h("span", { class: "try" }, kd, said, run, slip));
  place.hidden = false;

  /** @param {number} wanted */
  function position(wanted) {
    return Math.log(wanted / least) / Math.log(most / least);
  }
}

/**
 * Return the slip by kd that the law of the drift predicts. It is proportional to dmax · timeconst − h, with a timeconst of at
 * least two steps. The page contains the numbers of the law.
 * @param {HTMLElement} place @returns {((kd: number) => number) | null}
 */
function lawOf(place) {
  const numbers = [...place.querySelectorAll("data")].map((number) => Number(number.value));
  if (numbers.length !== 3) return null;
  const [slip_mm, dmax, step_s] = numbers;
  const yielding = (/** @type {number} */ kd) => dmax * Math.max(2 / kd, 2 * step_s) - step_s;
  return (kd) => (slip_mm * yielding(kd)) / yielding(SHIPPED.kd);
}
