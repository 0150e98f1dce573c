// Elements of the page, made and found.

/**
 * @param {string} tag @param {Record<string, any>} [attributes] @param {...(Node | string)} children
 * @returns {any}
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** Where the page's script lies, and beside it what it loads. */
export const HERE = /** @type {HTMLScriptElement} */ (document.currentScript).src;

/** Whether the page came from a server: a browser lets one that was opened from a file load nothing. */
export const isServed = location.protocol.startsWith("http");

/** @param {string} selector @returns {any} */
export const find = (selector) => document.querySelector(selector);

/** A number with its unit, as people read it. @param {number | null} value @param {string} unit */
export function written(value, unit) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const digits = Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
  return `${value.toFixed(digits).replace("-", "−")} ${unit}`.trim();
}
