// Plot lines and points as SVG in the colours of the page.

const HEIGHT = 260;
const [LEFT, RIGHT, TOP, BOTTOM] = [58, 14, 14, 40];
const NAMESPACE = "http://www.w3.org/2000/svg";

/**
 * @typedef {Object} Series
 * @property {string} name
 * @property {string} colour of the stylesheet
 * @property {[number, number][]} points
 * @property {boolean} [isLine]
 * @property {boolean} [isFaint]
 */

/** @param {string} tag @param {Record<string, string | number>} attributes @param {string} [text] */
function shape(tag, attributes, text) {
  const element = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Return about this many round numbers between two numbers. @param {number} low @param {number} high @param {number} most */
function ticks(low, high, most) {
  const rough = (high - low) / most || 1;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough) ?? rough;
  const found = [];
  for (let value = Math.ceil(low / step - 1e-9) * step; value <= high + 1e-9 * step; value += step) found.push(Number(value.toPrecision(12)));
  return found;
}

/** Return powers of ten and, if there are few of them, also twice and five times each. @param {number} low @param {number} high */
function logTicks(low, high) {
  const factors = Math.log10(high / low) > 2.5 ? [1] : [1, 2, 5];
  const found = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++) found.push(...factors.map((factor) => factor * 10 ** power));
  return found.filter((value) => value >= low * 0.999 && value <= high * 1.001);
}

/**
 * Draw series into an SVG element.
 * @param {SVGElement} svg
 * @param {Series[]} series
 * @param {{x: string, y: string, isLog?: boolean, least?: number}} axes labels; whether x is logarithmic; the least upper end of y
 */
export function plot(svg, series, { x: xLabel, y: yLabel, isLog = false, least = 0 }) {
  const width = Math.max(svg.clientWidth, 260);
  const all = series.flatMap(({ points }) => points).filter((point) => point.every(Number.isFinite));
  svg.replaceChildren();
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
  if (!all.length) return;
  const scale = (/** @type {number} */ value) => (isLog ? Math.log10(value) : value);
  const xs = all.map(([value]) => value);
  const [low, high] = [Math.min(...xs), Math.max(...xs)];
  const span = scale(high) - scale(low) || 1;
  const ys = all.map(([, value]) => value);
  const bottom = Math.min(0, ...ys);
  const top = Math.max(least, ...ys) * 1.06 || 1;
  const place = (/** @type {number} */ value) => LEFT + ((width - LEFT - RIGHT) * (scale(value) - scale(low))) / span;
  const height = (/** @type {number} */ value) => HEIGHT - BOTTOM - ((HEIGHT - TOP - BOTTOM) * (value - bottom)) / (top - bottom);
  for (const value of ticks(bottom, top, 4)) {
    svg.append(shape("path", { d: `M${LEFT} ${height(value)}H${width - RIGHT}`, class: value ? "grid" : "axis" }));
    svg.append(shape("text", { x: LEFT - 7, y: height(value) + 4, "text-anchor": "end" }, String(value)));
  }
  for (const value of isLog ? logTicks(low, high) : ticks(low, high, width / 90)) {
    svg.append(shape("path", { d: `M${place(value)} ${TOP}V${HEIGHT - BOTTOM}`, class: "grid" }));
    svg.append(shape("text", { x: place(value), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, value >= 1e4 ? value.toExponential(0).replace("+", "") : String(Number(value.toPrecision(3)))));
  }
  svg.append(shape("text", { x: (LEFT + width - RIGHT) / 2, y: HEIGHT - 5, "text-anchor": "middle", class: "label" }, xLabel));
  svg.append(shape("text", { x: 12, y: HEIGHT / 2, "text-anchor": "middle", class: "label", transform: `rotate(-90 12 ${HEIGHT / 2})` }, yLabel));
  for (const { name, colour, points, isLine = true, isFaint = false } of series) {
    const there = points.filter((point) => point.every(Number.isFinite));
    const group = shape("g", { style: `color: var(${colour})`, class: isFaint ? "faint" : "" });
    group.append(shape("title", {}, name));
    if (isLine) group.append(shape("path", { d: there.map(([px, py], index) => `${index ? "L" : "M"}${place(px).toFixed(1)} ${height(py).toFixed(1)}`).join(""), class: "line" }));
    else for (const [px, py] of there) group.append(shape("circle", { cx: place(px), cy: height(py), r: 4.5 }));
    svg.append(group);
  }
}
