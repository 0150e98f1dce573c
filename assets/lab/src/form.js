// Controls of the settings: a box and a slider for each number, and a choice for each name.

import { h } from "./dom.js";

/**
 * @typedef {Object} Control
 * @property {string} name
 * @property {string} label
 * @property {string} [unit]
 */

const SLIDER_STEPS = 200;

/** A form of controls that returns and accepts settings. */
export class Form {
  /**
   * @param {string} id @param {Record<string, Control[]>} groups by legend
   * @param {Record<string, [number, number, boolean]>} ranges @param {Record<string, string[]>} choices
   * @param {Record<string, any>} shipped
   */
  constructor(id, groups, ranges, choices, shipped) {
    this.ranges = ranges;
    this.choices = choices;
    this.shipped = shipped;
    /** @type {Record<string, HTMLInputElement | HTMLSelectElement>} */
    this.inputs = {};
    /** @type {Record<string, HTMLInputElement>} */
    this.sliders = {};
    const sets = Object.entries(groups).map(([legend, controls]) => h("fieldset", {}, h("legend", {}, legend), ...controls.map((control) => this.#control(id, control))));
    this.element = h("form", { id, class: "lab-form" }, ...sets);
    this.set(shipped);
  }

  /** @param {string} id @param {Control} control */
  #control(id, { name, label, unit = "" }) {
    const field = `${id}-${name}`;
    const said = h("label", { for: field }, label);
    if (name in this.choices) {
      this.inputs[name] = h("select", { id: field }, ...this.choices[name].map((choice) => h("option", { value: choice }, choice)));
      return h("div", { class: "lab-control" }, said, this.inputs[name]);
    }
    const [least, most] = this.ranges[name];
    const input = h("input", { id: field, type: "number", min: least, max: most, step: "any", inputmode: "decimal", required: true });
    const slider = h("input", { type: "range", min: 0, max: SLIDER_STEPS, "aria-label": `${label}, slider` });
    slider.addEventListener("input", () => {
      input.value = String(this.#fromSlider(name, Number(slider.value)));
    });
    input.addEventListener("input", () => this.#moveSlider(name));
    this.inputs[name] = input;
    this.sliders[name] = slider;
    return h("div", { class: "lab-control" }, said, h("span", { class: "lab-number" }, input, unit && h("span", { class: "unit" }, unit)), slider);
  }

  /** @param {string} name @param {number} place */
  #fromSlider(name, place) {
    const [least, most, isLog] = this.ranges[name];
    const part = place / SLIDER_STEPS;
    const value = isLog ? least * (most / least) ** part : least + (most - least) * part;
    return name === "substeps" ? Math.round(value) : Number(value.toPrecision(3));
  }

  /** @param {string} name */
  #moveSlider(name) {
    const [least, most, isLog] = this.ranges[name];
    const value = Math.min(Math.max(Number(this.inputs[name].value), least), most);
    const part = isLog ? Math.log(value / least) / Math.log(most / least) : (value - least) / (most - least);
    this.sliders[name].value = String(Math.round(SLIDER_STEPS * part));
  }

  /** @param {Record<string, any>} settings those without a control are ignored */
  set(settings) {
    for (const name of Object.keys(this.inputs)) {
      if (!(name in settings)) continue;
      this.inputs[name].value = String(settings[name]);
      if (name in this.sliders) this.#moveSlider(name);
    }
  }

  /** Return the settings as text, by name. */
  get query() {
    return new URLSearchParams(Object.entries(this.inputs).map(([name, input]) => [name, input.value])).toString();
  }
}
