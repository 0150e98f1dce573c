// Create and find elements of the page.

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

/** The folder of the page's script and of the files that it loads. */
export const HERE = /** @type {HTMLScriptElement} */ (document.currentScript).src;

/** Whether the page came from a server. Browsers do not let a page that was opened from a file load other files. */
export const isServed = location.protocol.startsWith("http");

/** @param {string} selector @returns {any} */
export const find = (selector) => document.querySelector(selector);

/** Return a number with its unit as text. @param {number | null} value @param {string} unit */
export function written(value, unit) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const digits = Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : Math.abs(value) >= 1 ? 2 : 3;
  return `${value.toFixed(digits).replace("-", "−")} ${unit}`.trim();
}
