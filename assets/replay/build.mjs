// Writes replay.js, the one script of replay.html: three.js, the robot with its meshes, and what is in src/.
// The same sources and packages give the same bytes.

import { writeFileSync } from "node:fs";

import { build } from "esbuild";

import { robot } from "./robot.mjs";

const result = await build({
  entryPoints: [new URL("src/main.js", import.meta.url).pathname],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  legalComments: "inline",
  write: false,
  plugins: [robot],
});
writeFileSync(new URL("replay.js", import.meta.url), result.outputFiles[0].text);
console.log(`replay.js: ${result.outputFiles[0].contents.length} bytes`);
