// Create shapes of SVG.

const NAMESPACE = "http://www.w3.org/2000/svg";

export function shape(parent, tag, attributes = {}, text = "") {
  const element = document.createElementNS(NAMESPACE, tag);
  change(element, attributes);
  element.textContent = text;
  parent.append(element);
  return element;
}

export function change(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
}
