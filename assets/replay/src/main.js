// Run replay.html: the time, the controls and their effects.

import { Curve } from "./curve.js";
import { readShakes } from "./runs.js";
import { Section } from "./section.js";
import { Stage } from "./stage.js";

const KEY_STEP_S = 1 / 30;
const LEAD_S = 1; // time before the shake at which the replay begins [s]

const find = (selector) => document.querySelector(selector);
const all = (selector) => [...document.querySelectorAll(selector)];
const { scene, shakes } = readShakes(find("#runs").content.textContent);
const chosen = (name) => find(`input[name="${name}"]:checked`).value;

let shake = shakes[0];
let time = shake.runs[0].end_s;
let playing = false;
let before = 0;
let due = false;

const stage = begun();
const curve = new Curve(find("#curve"), (seconds) => seek(seconds));
const sections = all(".run svg").map((svg, number) => new Section(svg, scene.edge_m, `var(--run-${number})`));

// Replace the still picture by the stage. Without WebGL the picture remains.
function begun() {
  const { classList } = document.documentElement;
  classList.add("moving"); // this comes first, because hidden elements have no size
  try {
    return new Stage(find("#stage canvas"), scene, () => draw());
  } catch (error) {
    classList.remove("moving");
    throw error;
  }
}

function draw() {
  if (!due) requestAnimationFrame(show);
  due = true;
}

function show(now) {
  due = false;
  const frame_ms = playing ? now - before : 0;
  if (playing) {
    time += Math.min(frame_ms / 1000, 0.2) * Number(find("#speed").value);
    before = now;
    if (time >= shake.runs[0].end_s) play(false);
  }
  time = Math.min(Math.max(time, shake.runs[0].start_s), shake.runs[0].end_s);
  const states = shake.runs.map((run) => run.at(time));
  const magnified = Number(chosen("magnified"));
  stage.draw(shake.runs, states, magnified, time, playing && frame_ms);
  curve.point(shake.runs, states, time);
  shake.runs.forEach((run, number) => {
    const out = !run.inGrasp(time);
    const { slip_mm, normal_n, tangential_n, penetration_mm } = states[number];
    const said = slip_mm === null ? "–" : out ? "out of the grasp" : `${slip_mm.toFixed(2)} mm`;
    for (const place of all(`[data-slip="${number}"]`)) place.textContent = said;
    find(`[data-force="${number}"]`).textContent = out ? "nothing holds it" : `${penetration_mm.toFixed(2)} mm deep, normal force ${normal_n.toFixed(1)} N, friction ${tangential_n.toFixed(2)} N`;
    sections[number].draw(states[number]);
  });
  find("#magnified").hidden = magnified === 1;
  find("#magnified").textContent = `displacement drawn ${magnified} times as large`;
  find("#time").value = time;
  find("#time").setAttribute("aria-valuetext", clock(time));
  find("#clock").textContent = `${time.toFixed(2).replace("-", "−")} s`;
  if (playing) draw();
}

const clock = (seconds) => (seconds < 0 ? `${(-seconds).toFixed(2)} s before the shake` : `${seconds.toFixed(2)} s of the shake`);

function play(on) {
  if (on && time >= shake.runs[0].end_s - 1e-6) time = Math.max(-LEAD_S, shake.runs[0].start_s);
  playing = on;
  before = performance.now();
  find("#play").textContent = on ? "Pause" : "Play";
  draw();
}

function seek(seconds) {
  play(false);
  time = seconds;
  draw();
}

function choose(number) {
  shake = shakes[number];
  time = shake.runs[0].end_s;
  find("#time").min = shake.runs[0].start_s;
  find("#time").max = shake.runs[0].end_s;
  for (const element of all("[data-run]")) element.hidden = Number(element.dataset.run) >= shake.runs.length;
  for (const element of all("[data-name]")) element.textContent = shake.runs[Number(element.dataset.name)]?.name ?? "";
  curve.show(shake.runs);
  draw();
}

function colour() {
  const style = getComputedStyle(document.documentElement);
  const named = (name) => style.getPropertyValue(name).trim();
  stage.colour({ back: named("--backdrop"), lines: named("--lines"), edges: named("--edges") });
  draw();
}

find("#play").addEventListener("click", () => play(!playing));
find("#time").addEventListener("input", (event) => seek(Number(event.target.value)));
for (const input of all('input[name="shake"]')) input.addEventListener("change", () => (play(false), choose(Number(input.value))));
for (const input of all('input[name="view"]')) input.addEventListener("change", () => stage.look(input.value));
for (const input of all('input[name="magnified"]')) input.addEventListener("change", draw);
document.addEventListener("keydown", (event) => {
  const typed = event.target.closest("input, select, textarea, button, a, summary");
  const keys = {
    " ": () => play(!playing),
    ArrowLeft: () => seek(time - KEY_STEP_S),
    ArrowRight: () => seek(time + KEY_STEP_S),
    Home: () => seek(shake.runs[0].start_s),
    End: () => seek(shake.runs[0].end_s),
  };
  if (typed || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", colour);

colour();
choose(0);
new ResizeObserver(() => (curve.show(shake.runs), draw())).observe(find("#curve").parentElement);
