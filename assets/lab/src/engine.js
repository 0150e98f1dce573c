// Run the shake and the turntable in MuJoCo's C engine, compiled to WebAssembly.

import load from "@mujoco/mujoco";

import { Shake } from "./shake.js";
import { turntable } from "./turntable.js";

/** @typedef {import("@mujoco/mujoco").MainModule} Engine */
/** @typedef {import("@mujoco/mujoco").MjModel} Model */
/** @typedef {import("@mujoco/mujoco").MjData} Data */

export { CASES, CHOICES, RANGES, read, SHIPPED, write } from "./settings.js";

/**
 * Load the engine from its compressed file.
 * @param {ArrayBuffer} packed WebAssembly, compressed with gzip or not
 */
export async function open(packed) {
  const isPacked = new Uint8Array(packed, 0, 1)[0] === 0x1f;
  const unpacked = isPacked && new Response(packed).body?.pipeThrough(new DecompressionStream("gzip"));
  const wasmBinary = unpacked ? await new Response(unpacked).arrayBuffer() : packed;
  return new Laboratory(await load({ wasmBinary, printErr: () => undefined }));
}

/** The measurements that the engine can make. */
export class Laboratory {
  /** @param {Engine} mujoco */
  constructor(mujoco) {
    this.mujoco = mujoco;
    this.version = mujoco.mj_versionString();
  }

  /**
   * Shake the cube. ``watch`` is called with the run after each frame, and its promise is awaited.
   * @param {string} mjcf
   * @param {import("./settings.js").Settings} settings
   * @param {{shakeFrames: number, floor_mm_s: number}} how
   * @param {(run: Shake) => Promise<void> | void} watch
   */
  async shake(mjcf, settings, { shakeFrames, floor_mm_s }, watch = () => undefined) {
    const run = new Shake(this.mujoco, mjcf, settings, shakeFrames);
    try {
      while (!run.isDone) {
        run.frame();
        await watch(run);
      }
      return { ...run.row(floor_mm_s), engine: `mujoco ${this.version}` };
    } finally {
      run.delete();
    }
  }

  /** @param {import("./turntable.js").Turning} turning */
  turntable(turning) {
    return turntable(this.mujoco, turning);
  }
}
