/* What the pages do beyond being read: all is there without it. No dependencies, and nothing is fetched but the other
   pages, when somebody searches. */
"use strict";

const root = document.documentElement;

/* Colour scheme: as the system has it, light, or dark. */

const SCHEMES = ["auto", "light", "dark"];

function keptScheme() {
  try {
    return SCHEMES.find((scheme) => scheme === localStorage.getItem("scheme")) ?? "auto";
  } catch {
    return "auto"; // storage is forbidden
  }
}

function setScheme(scheme) {
  root.dataset.scheme = scheme;
  try {
    localStorage.setItem("scheme", scheme);
  } catch {} // then it holds for this page alone
}

function addSchemeSwitch() {
  const button = document.querySelector(".scheme");
  const say = () => (button.textContent = `Colours: ${root.dataset.scheme}`);
  button.addEventListener("click", () => {
    setScheme(SCHEMES[(SCHEMES.indexOf(root.dataset.scheme) + 1) % SCHEMES.length]);
    say();
  });
  say();
  button.hidden = false;
}

/* Sections were on the front page once: what leads to one there, or to something in it, goes on to where it is now. */

function decoded(hash) {
  try {
    return decodeURIComponent(hash.slice(1));
  } catch {
    return ""; // a link that somebody cut off
  }
}

function followOldLink() {
  const name = decoded(location.hash);
  if (!name) return;
  const moved = [...document.querySelectorAll(".index a[id]")].find((link) => name === link.id || name.startsWith(`${link.id}-`));
  if (moved) location.replace(`${moved.href.split("#")[0]}#${name}`);
}

/* Contents: the link of the section that is being read is marked. */

function markPlace() {
  const links = new Map();
  for (const link of document.querySelectorAll('.beside a[href^="#"], .folded a[href^="#"]')) {
    const target = document.getElementById(decoded(link.hash));
    if (target) links.set(target, [...(links.get(target) ?? []), link]);
  }
  const targets = [...links.keys()];
  let current = null;
  const mark = () => {
    const topOf = (target) => target.getBoundingClientRect().top;
    const passed = targets.filter((target) => topOf(target) < innerHeight / 3);
    // A short section that the address names ends in the upper third, and is the one that is read.
    const named = passed.find((target) => target.id === decoded(location.hash) && topOf(target) >= -1);
    const found = named ?? passed.at(-1) ?? null;
    if (found === current) return;
    for (const link of links.get(current) ?? []) link.removeAttribute("aria-current");
    for (const link of links.get(found) ?? []) link.setAttribute("aria-current", "location");
    current = found;
  };
  let isDue = false;
  addEventListener(
    "scroll",
    () => {
      if (isDue) return;
      isDue = true;
      requestAnimationFrame(() => {
        isDue = false;
        mark();
      });
    },
    { passive: true },
  );
  mark();
}

/* One stop of the Tab key for many things, between which the arrow keys go: a table's buttons, numbers, references. */

function rove(things) {
  things.forEach((thing, index) => (thing.tabIndex = index ? -1 : 0));
  const select = (thing) => {
    for (const each of things) each.tabIndex = each === thing ? 0 : -1;
  };
  things.forEach((thing, index) => {
    thing.addEventListener("focus", () => select(thing));
    thing.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      const next = step && things[index + step];
      if (!next) return;
      event.preventDefault();
      next.focus();
    });
  });
}

/* Tables: a click on a head sorts, first up, then down, then as it was; and each can be copied as CSV. */

function plainText(cell) {
  const number = cell.querySelector("data");
  if (!number) return cell.textContent.replace(/ #$/, "").trim();
  return cell.querySelectorAll("data").length > 1 ? cell.textContent.trim() : number.value;
}

function compareCells(a, b) {
  const numbers = [a, b].map(Number);
  if (numbers.every((number) => !Number.isNaN(number))) return numbers[0] - numbers[1];
  return a.localeCompare(b, "en", { numeric: true });
}

function sortRows(table, column, direction) {
  const body = table.tBodies[0];
  const text = (row) => plainText(row.cells[column]);
  const isEmpty = (row) => ["", "n/a", "–"].includes(text(row));
  const order = (a, b) => isEmpty(a) - isEmpty(b) || (isEmpty(a) ? 0 : direction * compareCells(text(a), text(b)));
  const rows = [...table.originalRows];
  body.append(...(direction ? rows.sort(order) : rows));
}

function addSorting(table) {
  table.originalRows = [...table.tBodies[0].rows];
  const heads = [...table.tHead.rows[0].cells];
  const buttons = heads.map((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...(head.textContent ? head.childNodes : ["case"]));
    head.replaceChildren(button);
    button.addEventListener("click", () => {
      const next = { ascending: "descending", descending: "none" }[head.ariaSort] ?? "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      if (next !== "none") head.ariaSort = next;
      sortRows(table, column, { ascending: 1, descending: -1, none: 0 }[next]);
    });
    return button;
  });
  return buttons;
}

function tableAsCsv(table) {
  // A spreadsheet takes what begins so for a formula.
  const inert = (text) => (/^[=+\-@\t\r\n＝＋－＠]/.test(text) && Number.isNaN(Number(text)) ? `'${text}` : text);
  const quote = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const line = (row) => [...row.cells].map((cell) => quote(inert(plainText(cell)))).join(",");
  return [...table.rows].map(line).join("\n") + "\n";
}

async function copyText(text) {
  if (navigator.clipboard) return navigator.clipboard.writeText(text);
  const area = document.createElement("textarea"); // where the page is not served safely there is no other way
  area.value = text;
  document.body.append(area);
  area.select();
  document.execCommand("copy");
  area.remove();
}

function copyButton(label, textOf) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "copy";
  button.textContent = label;
  button.addEventListener("click", async () => {
    try {
      await copyText(textOf());
      button.textContent = "Copied";
    } catch {
      button.textContent = "Could not be copied";
    }
    setTimeout(() => (button.textContent = label), 2000);
  });
  return button;
}

function addCopying(table) {
  const button = copyButton("Copy as CSV", () => tableAsCsv(table));
  (table.closest("figure")?.querySelector("figcaption") ?? table.parentElement).append(" ", button);
  return button;
}

/* Code: each block has a button that copies it as it is. */

function addCodeCopying(block) {
  const frame = document.createElement("div");
  frame.className = "code";
  block.replaceWith(frame);
  frame.append(block, copyButton("Copy", () => `${block.textContent.trimEnd()}\n`));
}

/* Numbers: where each comes from is shown under the pointer, with the focus, and at a touch. */

function metaOf(name) {
  return document.querySelector(`meta[name="${name}"]`)?.content ?? "";
}

function unitOf(number) {
  const cell = number.closest("td");
  const head = cell && number.closest("table").tHead.rows[0].cells[cell.cellIndex];
  const bracketed = head?.textContent.match(/\[(.+)\]/);
  if (bracketed) return bracketed[1];
  const behind = number.nextSibling?.nodeType === Node.TEXT_NODE ? number.nextSibling.data : "";
  return behind.match(/^\u00a0([^\s,.;:)]+)/)?.[1] ?? "";
}

function lineOf(...content) {
  const line = document.createElement("p");
  line.append(...content);
  return line;
}

function explain(number, origins) {
  const [file, pointer] = number.dataset.src.split("#");
  const parts = pointer.split("/");
  const isDerived = file.endsWith("values.json");
  const folder = file.includes("/") ? file.split("/")[0] : metaOf("folder");
  const record = isDerived ? `${folder}/${parts[1]}.json` : file;
  const exact = document.createElement("b");
  exact.textContent = number.value === "" ? "There is no number" : `${number.value} ${unitOf(number)}`.trim();
  const link = document.createElement("a");
  link.href = `${metaOf("data")}${file}#${pointer}`;
  link.textContent = isDerived ? `${file}#${pointer}` : `${parts.at(-1)}, row ${parts.at(-2)} of ${file}`;
  link.tabIndex = -1;
  return [
    lineOf(exact),
    ...(number.dataset.hint ? [lineOf(isDerived ? "Derived: " : "", number.dataset.hint)] : []),
    lineOf(origins[record] ?? ""),
    lineOf("Data: ", link),
  ];
}

function addOrigins() {
  const origins = JSON.parse(metaOf("origins") || "{}");
  const numbers = [...document.querySelectorAll("main data")];
  const box = document.createElement("div");
  box.className = "origin";
  box.id = "origin";
  box.setAttribute("role", "tooltip");
  box.hidden = true;
  document.body.append(box);
  let shown = null;
  let leaving = 0;

  const hide = () => {
    shown?.removeAttribute("aria-describedby");
    shown = null;
    box.hidden = true;
  };
  const show = (number) => {
    clearTimeout(leaving);
    if (number === shown) return;
    hide();
    shown = number;
    box.replaceChildren(...explain(number, origins));
    box.hidden = false;
    number.setAttribute("aria-describedby", box.id);
    const at = number.getBoundingClientRect();
    const left = Math.min(at.left, root.clientWidth - box.offsetWidth - 8);
    const above = at.bottom + box.offsetHeight + 8 > innerHeight && at.top > box.offsetHeight;
    box.style.left = `${Math.max(8, left) + scrollX}px`;
    box.style.top = `${(above ? at.top - box.offsetHeight - 4 : at.bottom + 4) + scrollY}px`;
  };
  const leave = () => {
    clearTimeout(leaving);
    leaving = setTimeout(hide, 300); // so that the pointer can get to the link
  };

  for (const number of numbers) {
    if (number.title) {
      number.dataset.hint = number.title; // or the browser shows a second box
      number.removeAttribute("title");
    }
  }
  const numberAt = (event) => event.target.closest?.("main data");
  document.addEventListener("pointerover", (event) => {
    const number = numberAt(event);
    if (number) show(number);
    else if (box.contains(event.target)) clearTimeout(leaving);
    else if (shown && shown !== document.activeElement) leave();
  });
  document.addEventListener("focusin", (event) => (numberAt(event) ? show(event.target) : hide()));
  document.addEventListener("click", (event) => {
    if (numberAt(event)) show(numberAt(event));
    else if (!box.contains(event.target)) hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  rove(numbers);
}

/* Search: over what stands below each heading of this release's pages, which are fetched when somebody begins to. */

const MOST_FOUND = 12;

function plainWords(text) {
  return ` ${text.toLowerCase().replace(/[^\p{L}\p{M}\p{N}]+/gu, " ").trim()} `;
}

function entriesOf(page, address) {
  const entries = [];
  for (const block of page.querySelectorAll("main :is(h1, h2, h3, p, li, figcaption, th, td, pre, dt, dd), #cite")) {
    if (block.closest(".provenance, .source, nav") || block.parentElement.closest("li, figcaption")) continue;
    const text = block.textContent.replace(/ #$/, "").replace(/\s+/g, " ").trim();
    if (block.id === "cite") entries.push({ title: "Cite it", text, address: `${address}#cite` });
    else if (/^H/.test(block.tagName)) {
      const id = block.id || block.closest("section")?.id || "";
      entries.push({ title: text, text: "", address: id ? `${address}#${id}` : address });
    } else if (entries.length) entries.at(-1).text += ` ${text}`;
  }
  return entries.map((entry) => ({ ...entry, head: plainWords(entry.title), words: plainWords(entry.title + entry.text) }));
}

async function readPages() {
  const addresses = new Set([...document.querySelectorAll(".beside > ol > li > a")].map((link) => link.getAttribute("href")));
  const pages = await Promise.all(
    [...addresses].map(async (address) => {
      const page = new DOMParser().parseFromString(await (await fetch(address)).text(), "text/html");
      return entriesOf(page, address);
    }),
  );
  return pages.flat();
}

function findEntries(entries, asked) {
  const words = plainWords(asked).trim().split(" ").map((word) => ` ${word}`);
  const rank = (entry) => words.reduce((sum, word) => sum + 20 * entry.head.includes(word) + entry.words.split(word).length - 1, 0);
  const found = entries.filter((entry) => words.every((word) => entry.words.includes(word)));
  return found.sort((a, b) => rank(b) - rank(a)).slice(0, MOST_FOUND);
}

function excerpt(text, asked) {
  const at = Math.max(0, text.toLowerCase().indexOf(asked.trim().toLowerCase().split(/\s+/)[0]) - 40);
  return at ? `…${text.slice(at, at + 110).replace(/^\S*\s/, "").trim()}…` : `${text.slice(0, 110).trim()}…`;
}

function addSearch() {
  if (!location.protocol.startsWith("http")) return; // a page from a file may fetch nothing
  const [form, field, list] = ["search", "input", "ol"].map((tag) => document.createElement(tag));
  form.className = "search";
  Object.assign(field, { type: "search", placeholder: "Search", ariaLabel: "Search these pages" });
  list.ariaLive = "polite";
  list.hidden = true;
  form.append(field, list);
  document.querySelector(".bar .scheme").before(form);
  let pages = null;
  const show = async () => {
    const asked = field.value;
    if (!plainWords(asked).trim()) return (list.hidden = true);
    const entries = await (pages ??= readPages().catch(() => []));
    if (asked !== field.value) return;
    const found = findEntries(entries, asked).map((entry) => {
      const [line, link] = ["li", "a"].map((tag) => document.createElement(tag));
      link.href = entry.address;
      link.textContent = entry.title;
      line.append(link, ` ${excerpt(entry.text, asked)}`);
      return line;
    });
    if (!found.length) found.push(Object.assign(document.createElement("li"), { textContent: "Nothing is found." }));
    list.replaceChildren(...found);
    list.hidden = false;
  };
  field.addEventListener("input", show);
  field.addEventListener("focus", show);
  form.addEventListener("keydown", (event) => {
    if (event.key === "Escape") list.hidden = true;
  });
  document.addEventListener("click", (event) => {
    if (!form.contains(event.target) || event.target.closest("a")) list.hidden = true;
  });
}

setScheme(keptScheme());

document.addEventListener("DOMContentLoaded", () => {
  followOldLink();
  addSchemeSwitch();
  addSearch();
  markPlace();
  for (const table of document.querySelectorAll("main figure table")) rove([...addSorting(table), addCopying(table)]);
  rove([...document.querySelectorAll(".sources a")]);
  document.querySelectorAll("pre").forEach(addCodeCopying);
  addOrigins();
});
addEventListener("hashchange", followOldLink);
