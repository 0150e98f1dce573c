// Show the pads, the slip and the run time for the reader's own time step on the front page.
"use strict";

const choice = document.querySelector("#step-choice");
const steps = stepTable();
if (choice && steps) begin(choice, steps);

/**
 * The table of steps: a list of columns, each with its name, and a number or null and the text of each cell. The first column
 * holds the steps [ms].
 */
function stepTable() {
  const table = [...document.querySelectorAll("main table")].find((each) => each.querySelector("th").textContent.trim() === "step");
  if (!table) return null;
  const names = [...table.querySelectorAll("thead th")].map((cell) => cell.firstChild.textContent.trim());
  const rows = [...table.querySelectorAll("tbody tr")].map((row) => [...row.children]);
  const number = (cell) => (cell.querySelector("data") ? Number(cell.querySelector("data").value) : null);
  return names.map((name, index) => ({
    name,
    cells: rows.map((row) => number(row[index])),
    texts: rows.map((row) => row[index].textContent.trim()),
  }));
}

/** Return the two neighbours of a step in a column, as pairs of a logarithm and a value, or null outside of the measured range. */
function neighbours(steps, cells, step) {
  const points = steps.map((x, index) => [Math.log(x), cells[index]]).filter(([, y]) => y !== null);
  points.sort((a, b) => a[0] - b[0]);
  const x = Math.log(step);
  for (let index = 1; index < points.length; index++) {
    const [left, right] = [points[index - 1], points[index]];
    if (left[0] - 1e-3 <= x && x <= right[0] + 1e-3) return [left, right];
  }
  return null;
}

/** Return the value of a column at a step, interpolated between the logarithms of its neighbours, or null. */
function at(steps, cells, step) {
  const pair = neighbours(steps, cells, step);
  if (!pair) return null;
  const [left, right] = pair;
  const share = (Math.log(step) - left[0]) / (right[0] - left[0]);
  return Math.exp((1 - share) * Math.log(left[1]) + share * Math.log(right[1]));
}

/**
 * Return the slip in words. Neighbours have steps that differ by a factor of two. If their slips differ by much more, the slip is
 * no longer proportional to the step, and an interpolated one can be wrong by a quarter.
 */
function slipText(slip, pair, isMeasured) {
  const [low, high] = pair.map(([, y]) => y).sort((a, b) => a - b);
  if (isMeasured || high / low < 2.2) return `about ${written(slip)} mm`;
  return `between ${written(low)} and ${written(high)} mm`;
}

function written(number) {
  return Number(number.toPrecision(2)).toString();
}

/** The row whose step is within one percent, or -1. */
function nearest(steps, step) {
  return steps.findIndex((each) => Math.abs(step / each - 1) < 0.01);
}

/**
 * Return a function that marks a point on the line of the rule in a figure: after so many of its runs, with fractions between two
 * runs, or nowhere if the number is null. The axes are logarithmic, so a straight line between two runs is the interpolation of
 * the table. `count` is the number of runs.
 */
function markOn(figure, count) {
  const picture = figure.querySelector("img");
  const mark = document.createElement("span");
  mark.id = "step-mark";
  mark.hidden = true;
  Object.assign(mark.style, {
    position: "absolute",
    width: "1.1rem",
    height: "1.1rem",
    margin: "-0.55rem",
    border: "2px solid currentColor",
    borderRadius: "50%",
    pointerEvents: "none",
  });
  const frame = picture.closest("a");
  frame.style.position = "relative";
  frame.append(mark);
  let places = [];
  let position = null;
  const move = () => {
    mark.hidden = position === null || places.length !== count;
    if (mark.hidden) return;
    const index = Math.min(Math.floor(position), count - 2);
    const share = position - index;
    const [x, y] = [0, 1].map((axis) => (1 - share) * places[index][axis] + share * places[index + 1][axis]);
    mark.style.left = `${picture.offsetLeft + x * picture.offsetWidth}px`;
    mark.style.top = `${picture.offsetTop + y * picture.offsetHeight}px`;
  };
  const read = async () => {
    const answer = await fetch(picture.currentSrc || picture.src).catch(() => null);
    if (!answer?.ok) return;
    // The policy of the page forbids inline styles, and each of them would be reported.
    const text = (await answer.text()).replace(/<style[^]*?<\/style>| style="[^"]*"/g, "");
    const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
    const [, , width, height] = drawing.documentElement.getAttribute("viewBox").split(" ").map(Number);
    const runs = [...drawing.querySelectorAll("#line-by-rule use")];
    places = runs.map((run) => [run.getAttribute("x") / width, run.getAttribute("y") / height]);
    move();
  };
  // A page that is opened as a file must not read other files.
  if (location.protocol !== "file:") {
    picture.addEventListener("load", read);
    addEventListener("resize", move);
    read();
  }
  return (to) => {
    position = to;
    move();
  };
}

/** Return the position of a step among descending steps, with fractions by the logarithm, or null outside of them. */
function positionOf(steps, step) {
  for (let index = 1; index < steps.length; index++) {
    const share = Math.log(steps[index - 1] / step) / Math.log(steps[index - 1] / steps[index]);
    if (share >= -1e-3 && share <= 1 + 1e-3) return index - 1 + share;
  }
  return null;
}

function begin(place, columns) {
  const [steps, kds, , , ...others] = columns;
  const time = others.pop();
  const input = document.querySelector("#step-ms");
  const contacts = document.querySelector("#step-contacts");
  const output = document.querySelector("#step-slip");
  for (const { name } of others) contacts.append(new Option(name.replace("slip, ", "").replace(" [mm]", "")));
  contacts.selectedIndex = Number(contacts.dataset.default);
  const code = [...document.querySelectorAll("main pre code")].find((block) => block.textContent.includes("shape_material_kd"));
  const original = code?.textContent;

  const figure = document.querySelector("#story-frontier");
  const drawn = steps.cells.filter((_, row) => others[0].cells[row] !== null && time.cells[row] !== null);
  const mark = figure ? markOn(figure, drawn.length) : () => {};

  // The code of the page suits the step of its scene, and was measured. It changes only if the reader chooses another step.
  let isChosen = false;
  const describe = () => {
    if (code) code.textContent = original;
    mark(null);
    const step = Number(input.value.replace(",", "."));
    if (!(step > 0)) return "type the length of a step in ms.";
    const { name, cells, texts } = others[contacts.selectedIndex];
    const row = nearest(steps.cells, step);
    const measured = row < 0 ? step : steps.cells[row];
    const slip = at(steps.cells, cells, measured);
    if (slip === null) return row >= 0 && texts[row] === "lost" ? "the cube is lost." : "this was not measured.";
    const kd = row < 0 ? Number((1000 / step).toPrecision(3)) : kds.cells[row];
    const ke = Number((kd ** 2 / (name.includes("pyramidal") ? 64 : 4)).toPrecision(4));
    if (code && isChosen) {
      code.textContent = original
        .replace(/(shape_material_ke\[shape\] = )\S+/, `$1${ke}`)
        .replace(/(shape_material_kd\[shape\] = )\S+/, `$1${kd}`);
    }
    if (contacts.selectedIndex === 0) mark(positionOf(drawn, measured));
    const ratio = at(steps.cells, time.cells, measured);
    const cost = ratio === null ? "" : `; a frame takes about ${written(ratio)} times as long as with the scene's step`;
    const slips = slipText(slip, neighbours(steps.cells, cells, measured), row >= 0);
    return `kd ${kd}, ke ${ke}; the cube slips ${slips}${cost}.`;
  };
  const show = () => (output.textContent = describe());
  const choose = () => {
    isChosen = true;
    show();
  };
  input.addEventListener("input", choose);
  contacts.addEventListener("change", choose);
  document.querySelector("#step-note").hidden = true;
  place.hidden = false;
  show();
}
