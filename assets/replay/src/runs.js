// Unpack the runs of the page. report/media/packed.py packs each column as whole numbers between its smallest and largest value.

const WIDEST = 65535;

class Run {
  constructor(packed, columns) {
    Object.assign(this, packed);
    this.columns = columns;
    const bytes = Uint8Array.from(atob(packed.samples), (letter) => letter.charCodeAt(0));
    const whole = new Uint16Array(bytes.buffer);
    this.values = columns.map((_, column) => {
      const low = packed.low[column];
      const range = packed.high[column] - low;
      return Float64Array.from({ length: packed.count }, (_, index) => low + (range * whole[column * packed.count + index]) / WIDEST);
    });
    this.end_s = packed.start_s + (packed.count - 1) * packed.step_s;
    this.moved_mm = Array.from({ length: packed.count }, (_, index) => this.#slip(this.columnsAt(index, index, 0)));
  }

  time(index) {
    return this.start_s + index * this.step_s;
  }

  inGrasp(time) {
    return this.left_grasp_s === null || time < this.left_grasp_s;
  }

  // Return the state at a time, interpolated linearly between two kept frames.
  at(time) {
    const place = Math.min(Math.max((time - this.start_s) / this.step_s, 0), this.count - 1);
    const index = Math.min(Math.floor(place), this.count - 2);
    const values = this.columnsAt(index, index + 1, place - index);
    return {
      joints: values.slice(0, 9),
      position: values.slice(9, 12),
      quaternion: values.slice(12, 16),
      normal_n: values[16],
      tangential_n: values[17],
      penetration_mm: values[18],
      slip_mm: time >= 0 ? this.#slip(values) : null,
    };
  }

  columnsAt(first, second, share) {
    return this.values.map((column) => (1 - share) * column[first] + share * column[second]);
  }

  #slip(values) {
    return 1e3 * Math.hypot(...this.begin.position.map((start, axis) => values[9 + axis] - start));
  }
}

export function readShakes(text) {
  const { columns, shakes, ...scene } = JSON.parse(text);
  return { scene, shakes: shakes.map(({ name, runs }) => ({ name, runs: runs.map((run) => new Run(run, columns)) })) };
}
