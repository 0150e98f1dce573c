// Writes dist/: the engine, packed, with what runs in it; the page's script and the front page's. The same sources and
// packages give the same bytes.

import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

import { build } from "esbuild";

import { robot } from "../replay/robot.mjs";

const here = (path) => new URL(path, import.meta.url).pathname;

for (const name of ["engine", "worker", "lab", "stage", "try"]) {
  await build({
    entryPoints: [here(`src/${name}.js`)],
    outfile: here(`dist/${name}.js`),
    bundle: true,
    minify: true,
    format: name === "lab" || name === "try" ? "iife" : "esm", // a page from a file may not load a module
    target: "es2022",
    charset: "ascii",
    legalComments: name === "engine" || name === "stage" ? "inline" : "none",
    external: ["./engine.js", "./stage.js", "module"],
    plugins: [robot],
  });
}
writeFileSync(here("dist/engine.bin"), gzipSync(readFileSync(here("node_modules/@mujoco/mujoco/mujoco.wasm")), { level: 9 }));
