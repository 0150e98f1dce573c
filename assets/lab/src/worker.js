// A worker with one engine, which runs its requests one after the other.

import { open } from "./engine.js";

/** Time between two checks for new requests [ms]. */
const PATIENCE_MS = 40;

/** @type {Promise<import("./engine.js").Laboratory> | undefined} */
let laboratory;
let cancelled = 0;

const pause = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = resolve;
    port2.postMessage(0);
  });

async function engine() {
  laboratory ??= fetch(new URL("engine.bin", import.meta.url)).then(async (answer) => {
    if (!answer.ok) throw new Error(`the engine can't be loaded: ${answer.status}`);
    return open(await answer.arrayBuffer());
  });
  return laboratory;
}

/** @param {any} task */
async function done({ id, kind, mjcf, settings, how, isWatched }) {
  const found = await engine();
  if (kind === "turntable") return found.turntable(settings);
  let begun = performance.now();
  let sent = 0;
  return found.shake(mjcf, settings, how, async (run) => {
    if (performance.now() - begun < PATIENCE_MS && !run.isDone) return;
    if (isWatched) {
      postMessage({ id, frames: run.frames.slice(sent), shaken: run.shaken });
      sent = run.frames.length;
    }
    await pause();
    if (id <= cancelled) throw new Error("cancelled");
    begun = performance.now();
  });
}

addEventListener("message", async ({ data: task }) => {
  if (task.kind === "cancel") {
    cancelled = task.id;
    return;
  }
  try {
    postMessage({ id: task.id, row: await done(task) });
  } catch (error) {
    postMessage({ id: task.id, error: error instanceof Error ? error.message : String(error) });
  }
});
