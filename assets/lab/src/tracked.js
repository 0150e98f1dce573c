// Read the page's record: the scene, the tracked runs, and the tracked run of some settings.

import { caseOf, SHIPPED } from "./settings.js";

/**
 * @typedef {Object} Tracked
 * @property {string} mjcf
 * @property {Record<string, any>[]} rows
 * @property {URL} source
 */

/** Read the record that the page's head names. @returns {Promise<Tracked>} */
export async function readTracked() {
  const named = document.querySelector('meta[name="lab"]')?.getAttribute("content") ?? "";
  const source = new URL(named, location.href);
  const answer = await fetch(source);
  if (!answer.ok) throw new Error(`the scene can't be loaded: ${answer.status}`);
  const { rows } = await answer.json();
  const mjcf = rows.map((/** @type {any} */ row) => row.mjcf ?? "").join("");
  return { mjcf, rows: rows.filter((/** @type {any} */ row) => !row.mjcf), source };
}

/**
 * Return the tracked run of some settings, if there is one.
 * @param {Tracked} tracked @param {import("./settings.js").Settings} settings
 */
export function runOf({ rows }, settings) {
  /** @type {Record<string, any>} */
  const shipped = caseOf(SHIPPED);
  /** @type {Record<string, any>} */
  const asked = caseOf(settings);
  const same = (/** @type {any} */ a, /** @type {any} */ b) => (typeof a === "number" ? Math.abs(a - b) <= 1e-9 * Math.abs(b) : String(a).toLowerCase() === String(b).toLowerCase());
  return rows.find((row) => !row.has_midphase && !row.cube_offset_m && Object.keys(asked).every((name) => same(asked[name], row[name] ?? shipped[name])));
}

/**
 * Return the displacement of a tracked run along the shake [s, mm].
 * @param {Tracked} tracked @param {string} name of its case
 * @returns {Promise<[number, number][]>}
 */
export async function curveOf({ source }, name) {
  const answer = await fetch(new URL(source.pathname.replace(/\.json$/, `.${name}.csv.gz`), source));
  if (!answer.ok || !answer.body) return [];
  const bytes = await answer.arrayBuffer();
  const isPacked = new Uint8Array(bytes, 0, 1)[0] === 0x1f;
  const text = await new Response(isPacked ? new Response(bytes).body?.pipeThrough(new DecompressionStream("gzip")) : bytes).text();
  const [head, ...lines] = text.trim().split("\n");
  const columns = head.split(",");
  const at = ["time_s", "x_mm", "y_mm", "z_mm"].map((column) => columns.indexOf(column));
  return lines.map((line) => {
    const cells = line.split(",").map(Number);
    return [cells[at[0]], Math.hypot(cells[at[1]], cells[at[2]], cells[at[3]])];
  });
}
