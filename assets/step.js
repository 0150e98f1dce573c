// The front page: the pads, the slip and the run time for the reader's own time step.
"use strict";

const choice = document.querySelector("#step-choice");
const steps = stepTable();
if (choice && steps) begin(choice, steps);

/**
 * The numbers of the table of steps: a list of columns, each with its name and a number or null for each row. The first column
 * holds the steps [ms].
 */
function stepTable() {
  const table = [...document.querySelectorAll("main table")].find((each) => each.querySelector("th").textContent.trim() === "step");
  if (!table) return null;
  const names = [...table.querySelectorAll("thead th")].map((cell) => cell.firstChild.textContent.trim());
  const rows = [...table.querySelectorAll("tbody tr")].map((row) =>
    [...row.children].map((cell) => {
      const number = cell.querySelector("data");
      return number ? Number(number.value) : null;
    }),
  );
  return names.map((name, index) => ({ name, cells: rows.map((row) => row[index]) }));
}

/** The value of a column at a step, interpolated between the logarithms of its neighbours, or null outside of what was measured. */
function at(steps, cells, step) {
  const points = steps.map((x, index) => [Math.log(x), cells[index]]).filter(([, y]) => y !== null);
  points.sort((a, b) => a[0] - b[0]);
  const x = Math.log(step);
  for (let index = 1; index < points.length; index++) {
    const [left, right] = [points[index - 1], points[index]];
    if (left[0] - 1e-3 <= x && x <= right[0] + 1e-3) {
      const share = (x - left[0]) / (right[0] - left[0]);
      return Math.exp((1 - share) * Math.log(left[1]) + share * Math.log(right[1]));
    }
  }
  return null;
}

function written(number) {
  return Number(number.toPrecision(2)).toString();
}

function begin(place, columns) {
  const [steps, , , , ...others] = columns;
  const time = others.pop();
  const input = document.querySelector("#step-ms");
  const contacts = document.querySelector("#step-contacts");
  const output = document.querySelector("#step-slip");
  for (const { name } of others) contacts.append(new Option(name.replace(" [mm]", "")));
  const code = [...document.querySelectorAll("main pre code")].find((block) => block.textContent.includes("shape_material_kd"));
  const original = code?.textContent;

  const show = () => {
    const step = Number(input.value.replace(",", "."));
    if (!(step > 0)) {
      output.textContent = "type the length of a step in ms.";
      return;
    }
    const kd = Number((1000 / step).toPrecision(3));
    const { name, cells } = others[contacts.selectedIndex];
    const ke = Number((kd ** 2 / (name.includes("pyramidal") ? 64 : 4)).toPrecision(3));
    if (code) {
      code.textContent = original
        .replace(/(shape_material_ke\[shape\] = )\S+/, `$1${ke}`)
        .replace(/(shape_material_kd\[shape\] = )\S+/, `$1${kd}`);
    }
    const slip = at(steps.cells, cells, step);
    const ratio = at(steps.cells, time.cells, step);
    const cost = ratio === null ? "" : `; a frame takes ${written(ratio)} times as long as with the scene's step`;
    output.textContent =
      slip === null
        ? `kd ${kd}, ke ${ke}; the cube is lost, or this was not measured.`
        : `kd ${kd}, ke ${ke}; the cube slips about ${written(slip)} mm${cost}.`;
  };
  input.addEventListener("input", show);
  contacts.addEventListener("change", show);
  document.querySelector("#step-note").hidden = true;
  place.hidden = false;
  show();
}
