// Draw the displacement over the time of the shake, with a cursor that can be dragged.

import { change, shape } from "./drawing.js";

const HEIGHT = 210;
const LEFT = 62;
const RIGHT = 14;
const TOP = 12;
const BOTTOM = 30;

const step = (span, most) => {
  const rough = span / most;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough);
};

export class Curve {
  constructor(svg, seek) {
    this.svg = svg;
    const to = (event) => seek(((event.clientX - svg.getBoundingClientRect().left - LEFT) / (this.width - LEFT - RIGHT)) * this.end_s);
    svg.addEventListener("pointerdown", (event) => {
      svg.setPointerCapture(event.pointerId);
      to(event);
    });
    svg.addEventListener("pointermove", (event) => event.buttons && to(event));
  }

  // Draw the axes and curves of some runs; colours are classes of the stylesheet.
  show(runs) {
    const { svg } = this;
    svg.replaceChildren();
    this.width = svg.clientWidth;
    change(svg, { viewBox: `0 0 ${this.width} ${HEIGHT}` });
    this.end_s = runs[0].end_s;
    const kept = runs.map((run) => run.moved_mm.map((moved, index) => [run.time(index), moved]).filter(([time]) => time >= 0 && run.inGrasp(time)));
    this.top_mm = 1.08 * Math.max(...kept.flat().map(([, moved]) => moved), 0.01);
    const every_mm = step(this.top_mm, 4);
    for (let value = 0; value < this.top_mm; value += every_mm) {
      const y = this.#y(value);
      shape(svg, "path", { d: `M${LEFT} ${y}H${this.width - RIGHT}`, class: value ? "grid" : "axis" });
      shape(svg, "text", { x: LEFT - 8, y: y + 5, class: "tick left" }, value ? `${Number(value.toFixed(3))} mm` : "0");
    }
    const every_s = step(this.end_s, this.width / 80);
    for (let time = every_s; time <= this.end_s; time += every_s) {
      shape(svg, "path", { d: `M${this.#x(time)} ${TOP}V${HEIGHT - BOTTOM}`, class: "grid" });
      shape(svg, "text", { x: this.#x(time), y: HEIGHT - 8, class: "tick" }, `${time} s`);
    }
    kept.forEach((points, number) => {
      const d = points.map(([time, moved], index) => `${index ? "L" : "M"}${this.#x(time).toFixed(1)} ${this.#y(moved).toFixed(1)}`).join("");
      shape(svg, "path", { d, class: `curve run-${number}` });
    });
    this.cursor = shape(svg, "path", { class: "cursor" });
    this.dots = runs.map((_, number) => shape(svg, "circle", { r: 5, class: `dot run-${number}` }));
  }

  point(runs, states, time) {
    const x = this.#x(Math.max(time, 0));
    change(this.cursor, { d: time >= 0 ? `M${x} ${TOP}V${HEIGHT - BOTTOM}` : "" });
    this.dots.forEach((dot, number) => {
      const there = time >= 0 && runs[number].inGrasp(time);
      change(dot, { cx: x, cy: this.#y(states[number].slip_mm ?? 0), visibility: there ? "visible" : "hidden" });
    });
  }

  #x(time) {
    return LEFT + (time / this.end_s) * (this.width - LEFT - RIGHT);
  }

  #y(value) {
    return HEIGHT - BOTTOM - (value / this.top_mm) * (HEIGHT - BOTTOM - TOP);
  }
}
