// Run settings in Node with the page's own engine: node run.mjs RECORD FRAMES < a JSON array of queries, as an address has
// them; writes a row for each, a line each.

import { readFileSync } from "node:fs";

import { open, read } from "./dist/engine.js";

const [record, shakeFrames] = process.argv.slice(2);
const { rows } = JSON.parse(readFileSync(record, "utf8"));
const mjcf = rows.map((row) => row.mjcf ?? "").join("");
const floor_mm_s = rows.find((row) => row.creep_floor_mm_s !== undefined).creep_floor_mm_s;
const packed = readFileSync(new URL("dist/engine.bin", import.meta.url));
const laboratory = await open(packed.buffer.slice(packed.byteOffset, packed.byteOffset + packed.length));
for (const query of JSON.parse(readFileSync(0, "utf8"))) {
  const targets = [];
  const watch = (run) => void targets.push(Array.from(run.data.ctrl));
  const row = await laboratory.shake(mjcf, read(query), { shakeFrames: Number(shakeFrames), floor_mm_s }, process.env.TARGETS && watch);
  console.log(JSON.stringify(process.env.TARGETS ? { ...row, targets } : row));
}
