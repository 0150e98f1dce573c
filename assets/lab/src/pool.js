// Run engines in workers: the first worker runs watched runs, and all workers run a sweep.

/**
 * @typedef {Object} Asked
 * @property {string} kind shake or turntable
 * @property {any} settings
 * @property {string} [mjcf]
 * @property {{shakeFrames: number, floor_mm_s: number}} [how]
 */

/** One worker and its open requests. */
class Bench {
  /** @param {URL} script */
  constructor(script) {
    this.worker = new Worker(script, { type: "module" });
    /** @type {Map<number, {resolve: (row: any) => void, reject: (error: Error) => void, watch?: (message: any) => void}>} */
    this.waiting = new Map();
    this.worker.addEventListener("message", ({ data }) => this.#heard(data));
    this.worker.addEventListener("error", (event) => {
      event.preventDefault();
      for (const { reject } of this.waiting.values()) reject(new Error(event.message || "the engine cannot be started"));
      this.waiting.clear();
    });
  }

  /** @param {any} message */
  #heard({ id, row, error, ...news }) {
    const asked = this.waiting.get(id);
    if (row || error) this.waiting.delete(id);
    if (row) asked?.resolve(row);
    else if (error) asked?.reject(new Error(error));
    else asked?.watch?.(news);
  }

  /** @param {Asked & {id: number}} task @param {(message: any) => void} [watch] */
  ask(task, watch) {
    return new Promise((resolve, reject) => {
      this.waiting.set(task.id, { resolve, reject, watch });
      this.worker.postMessage({ ...task, isWatched: Boolean(watch) });
    });
  }
}

export class Pool {
  /** @param {URL} script @param {number} size most workers */
  constructor(script, size) {
    this.script = script;
    this.size = size;
    /** @type {Bench[]} */
    this.benches = [];
    this.count = 0;
  }

  /** @param {number} index */
  #bench(index) {
    while (this.benches.length <= index) this.benches.push(new Bench(this.script));
    return this.benches[index];
  }

  /** Run one request; ``watch`` is called with its frames. @param {Asked} asked @param {(message: any) => void} [watch] @returns {Promise<any>} */
  run(asked, watch) {
    return this.#bench(0).ask({ ...asked, id: ++this.count }, watch);
  }

  /**
   * Run many requests in parallel; ``tell`` is called after each of them.
   * @param {Asked[]} list @param {(index: number, row: any) => void} tell
   */
  async runAll(list, tell) {
    let next = 0;
    const begun = this.count;
    this.count += list.length;
    const last = this.count;
    const work = async (/** @type {Bench} */ bench) => {
      while (next < list.length && this.cancelled !== last) {
        const index = next++;
        tell(index, await bench.ask({ ...list[index], id: begun + index + 1 }));
      }
    };
    await Promise.all(Array.from({ length: Math.min(this.size, list.length) }, (_, index) => work(this.#bench(index))));
  }

  /** End the running requests; they reject with "cancelled". */
  cancel() {
    this.cancelled = this.count;
    for (const { worker } of this.benches) worker.postMessage({ kind: "cancel", id: this.count });
  }
}

/** Return the number of workers that are useful on this machine. */
export const coreCount = () => Math.max(1, Math.min(navigator.hardwareConcurrency || 2, 4));
