/* Interactive features of the pages, which can also be read without this script. It has no dependencies. It fetches the
   other pages when the reader searches. */
"use strict";

const root = document.documentElement;

/* Colour scheme: the system's own, light, or dark. */

const SCHEMES = ["auto", "light", "dark"];

function storedScheme() {
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
  } catch {} // without storage, the choice applies to this page only
}

function addSchemeSwitch() {
  const button = document.querySelector(".scheme");
  const label = () => (button.textContent = `Colours: ${root.dataset.scheme}`);
  button.addEventListener("click", () => {
    setScheme(SCHEMES[(SCHEMES.indexOf(root.dataset.scheme) + 1) % SCHEMES.length]);
    label();
  });
  label();
  button.hidden = false;
}

/* In the past, all sections were on the front page: old links to a section, or to a part of it, lead to its new page. */

function decoded(hash) {
  try {
    return decodeURIComponent(hash.slice(1));
  } catch {
    return ""; // the link is incomplete
  }
}

// A link to a folded section, or to a heading within it, opens the section.
function openNamedSection() {
  const section = document.getElementById(decoded(location.hash))?.closest("main > section");
  section?.querySelector(":scope > details.fold")?.setAttribute("open", "");
}

// A link to the section in the address does not change the address, so the browser reports no change.
function openAgain(event) {
  const link = event.target.closest?.("a");
  if (link?.hash && link.href === location.href) openNamedSection();
}

function followOldLink() {
  const name = decoded(location.hash);
  if (!name) return;
  const moved = [...document.querySelectorAll(".index a[id]")].find((link) => name === link.id || name.startsWith(`${link.id}-`));
  if (moved) location.replace(`${moved.href.split("#")[0]}#${name}`);
}

/* Contents: mark the link to the section on the screen. */

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
    // The section in the address may be so short that the next one begins in the upper third, too.
    const named = passed.find((target) => target.id === decoded(location.hash) && topOf(target) >= -1);
    const section = named ?? passed.at(-1) ?? null;
    if (section === current) return;
    for (const link of links.get(current) ?? []) link.removeAttribute("aria-current");
    for (const link of links.get(section) ?? []) link.setAttribute("aria-current", "location");
    current = section;
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

/* Roving tab index: a group of elements, such as all numbers, has one stop of the Tab key, and the arrow keys move
   between its elements. */

function rove(elements) {
  elements.forEach((element, index) => (element.tabIndex = index ? -1 : 0));
  const select = (selected) => {
    for (const element of elements) element.tabIndex = element === selected ? 0 : -1;
  };
  elements.forEach((element, index) => {
    element.addEventListener("focus", () => select(element));
    element.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      const next = step && elements[index + step];
      if (!next) return;
      event.preventDefault();
      next.focus();
    });
  });
}

/* Tables: a click on a column's head sorts it in ascending order, then in descending order, then in the original order.
   Each table can be copied as CSV. */

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
  table.parentElement.removeAttribute("tabindex"); // its buttons take the focus, which lets the keyboard scroll
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
  // Spreadsheets treat a text that begins with one of these characters as a formula.
  const inert = (text) => (/^[=+\-@\t\r\n＝＋－＠]/.test(text) && Number.isNaN(Number(text)) ? `'${text}` : text);
  const quote = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const line = (row) => [...row.cells].map((cell) => quote(inert(plainText(cell)))).join(",");
  return [...table.rows].map(line).join("\n") + "\n";
}

async function copyText(text) {
  if (navigator.clipboard) return navigator.clipboard.writeText(text);
  const area = document.createElement("textarea"); // browsers offer no clipboard to pages without HTTPS
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
      button.textContent = "Copying failed";
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

/* Comparison: the reader chooses the two releases that are shown. */

function addChoice() {
  const pairs = [...document.querySelectorAll(".pairs > section")];
  if (!pairs.length) return;
  const labels = new Map();
  for (const pair of pairs) {
    rove([...pair.querySelectorAll("tbody a")]);
    const heads = [...pair.querySelectorAll("thead .number")];
    pair.id.split("..").forEach((release, side) => labels.set(release, heads[side].textContent));
  }
  const releases = [...labels.keys()].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  const selects = ["First release", "Second release"].map((label) => {
    const select = document.createElement("select");
    select.ariaLabel = label;
    select.append(...releases.map((release) => new Option(labels.get(release), release)));
    return select;
  });
  const show = () => {
    const [a, b] = selects.map((select) => select.value);
    for (const pair of pairs) pair.hidden = ![`${a}..${b}`, `${b}..${a}`].includes(pair.id);
  };
  // While a page loads, a new fragment of its address would scroll it.
  const choose = () => {
    show();
    const shown = pairs.find((pair) => !pair.hidden);
    if (shown) history.replaceState(null, "", `#${shown.id}`);
  };
  const showNamed = () => {
    const named = pairs.find((pair) => pair.id === decoded(location.hash));
    (named ?? pairs[0]).id.split("..").forEach((release, side) => (selects[side].value = release));
    show();
  };
  for (const select of selects) select.addEventListener("change", choose);
  addEventListener("hashchange", showNamed);
  const line = lineOf("Compare ", selects[0], " with ", selects[1]);
  line.className = "choice";
  pairs[0].parentElement.prepend(line);
  showNamed();
}

/* Code: each block has a button that copies it. */

function addCodeCopying(block) {
  const frame = document.createElement("div");
  frame.className = "code";
  block.replaceWith(frame);
  frame.append(block, copyButton("Copy", () => `${block.textContent.trimEnd()}\n`));
}

/* Numbers: a box shows the origin of the number that has the mouse pointer or the focus, or that was touched. */

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

function exactly(number) {
  const exact = document.createElement("b");
  exact.textContent = number.value === "" ? "This number is missing" : `${number.value} ${unitOf(number)}`.trim();
  return exact;
}

/* A pointer leads to a cell of a row, to the mean of its measurements, or to a derived number, which has several rows. */

function rowsOf(number, { derived, rows }) {
  const [file, path] = number.dataset.src.split("#");
  const all = Object.keys(rows);
  if (!file.endsWith("values.json")) return { rows: [`${file}#${path.replace(/\/\w+$/, "")}`].filter((row) => row in rows), more: 0 };
  const [count, ...places] = derived[number.dataset.src] ?? [0];
  if (count) return { rows: places.map((place) => all[place]), more: count - places.length };
  const folder = file.includes("/") ? file.split("/")[0] : metaOf("folder");
  const [, section, index] = path.match(/^\/(\w+)\/rows\.(\d+)\./) ?? [];
  return { rows: [`${folder}/${section}.json#/rows/${index}`].filter((row) => row in rows), more: 0 };
}

function explain(number, evidence) {
  const { rows } = rowsOf(number, evidence);
  const record = evidence.records[rows[0]?.split("#")[0]];
  const open = document.createElement("button");
  open.type = "button";
  open.tabIndex = -1; // by keyboard, the key Enter opens it
  open.textContent = "Evidence";
  open.addEventListener("click", () => showEvidence(number, evidence));
  return [
    lineOf(exactly(number)),
    ...(rows.length === 1 ? [lineOf(`Case ${evidence.rows[rows[0]].join(": ")}`)] : []),
    ...(number.dataset.hint ? [lineOf(number.dataset.hint)] : []),
    lineOf(record ? `${record.Release}, ${record.Machine}, ${record.Measured}` : ""),
    lineOf(open),
  ];
}

/* Evidence: a panel with the rows of a number, its measurements, and the command and the code that measure it. */

function showEvidence(number, evidence) {
  const { rows, more } = rowsOf(number, evidence);
  const panel = document.querySelector("dialog") ?? document.createElement("dialog");
  const [title, list, close] = ["h2", "dl", "button"].map((tag) => document.createElement(tag));
  const add = (label, ...content) => {
    const [term, detail] = ["dt", "dd"].map((tag) => document.createElement(tag));
    term.textContent = label;
    detail.append(...content);
    list.append(term, detail);
  };
  const linkTo = (address, text) => {
    const link = document.createElement("a");
    link.href = `${metaOf("data")}${address}`;
    link.textContent = text;
    return link;
  };
  title.append(exactly(number));
  if (number.dataset.hint) add(number.dataset.src.includes("/rows") ? "Measurements" : "Computation", number.dataset.hint);
  let shown = "";
  for (const name of rows) {
    const [file, path] = name.split("#");
    const [row, parameters] = evidence.rows[name];
    if (file !== shown) add("Data", linkTo(file, file));
    add("Case", row);
    add("Parameters", parameters);
    add("Row", linkTo(name, path));
    if (file !== shown) Object.entries(evidence.records[file]).forEach((entry) => add(...entry));
    shown = file;
  }
  if (more) add("Rows", `and ${more} more`);
  add("Pointer", linkTo(number.dataset.src, number.dataset.src));
  close.textContent = "Close";
  close.addEventListener("click", () => panel.close());
  panel.ariaLabel = "Evidence";
  panel.replaceChildren(title, list, close);
  document.body.append(panel);
  panel.showModal();
}

function addOrigins() {
  const evidence = JSON.parse(document.getElementById("evidence").content.textContent);
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
    box.replaceChildren(...explain(number, evidence));
    box.hidden = false;
    number.setAttribute("aria-describedby", box.id);
    const place = number.getBoundingClientRect();
    const left = Math.min(place.left, root.clientWidth - box.offsetWidth - 8);
    const isAbove = place.bottom + box.offsetHeight + 8 > innerHeight && place.top > box.offsetHeight;
    box.style.left = `${Math.max(8, left) + scrollX}px`;
    box.style.top = `${(isAbove ? place.top - box.offsetHeight - 4 : place.bottom + 4) + scrollY}px`;
  };
  const leave = () => {
    clearTimeout(leaving);
    leaving = setTimeout(hide, 300); // the delay lets the pointer reach the link in the box
  };

  for (const number of numbers) {
    if (number.title) {
      number.dataset.hint = number.title; // otherwise the browser shows a second box
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
  document.addEventListener("focusin", (event) => {
    if (numberAt(event)) show(event.target);
    else if (!box.contains(event.target)) hide();
  });
  document.addEventListener("click", (event) => {
    if (numberAt(event)) show(numberAt(event));
    else if (!box.contains(event.target)) hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
    if (event.key === "Enter" && numberAt(event)) showEvidence(event.target, evidence);
  });
  rove(numbers);
}

/* Search: find words in the texts below all headings of this release. Its pages are fetched at the first search. */

const RESULT_LIMIT = 12;

/* Words of readers, and the words of these pages. report.toml adds the words of its field. */
const SYNONYMS = { license: "licence", citation: "cite", repository: "licence", rerun: "measures it again" };

/* A number is one word, however its thousands are separated, and so is a release such as 1.2.3. */
function plainWords(text) {
  const joined = text.replace(/(?<=\d)[\u202f\u00a0\u2009,](?=\d{3}(?!\d))/g, "");
  return ` ${joined.toLowerCase().replace(/((?!(?<=\d)\.\d)[^\p{L}\p{M}\p{N}])+/gu, " ").trim()} `;
}

function entriesOf(page, address) {
  const entries = [];
  for (const block of page.querySelectorAll("main :is(h1, h2, h3, summary, p, li, figcaption, th, td, pre, dt, dd), .foot p")) {
    if (block.closest(".provenance, .source, .pairs, nav") || block.matches(".fold > summary") || block.parentElement.closest("li, figcaption")) continue;
    const text = block.textContent.replace(/ #$/, "").replace(/[ \n]+/g, " ").trim();
    if (block.closest(".foot")) {
      // All pages end with the same lines, so only the lines of the front page are listed.
      if (page.getElementById("cite")) entries.push({ title: block.id === "cite" ? "Cite it" : "Sources, licence and data", text, address: `${address}#${block.id}` });
    }
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

function findEntries(entries, query) {
  const synonyms = { ...SYNONYMS, ...JSON.parse(metaOf("synonyms") || "{}") };
  const words = plainWords(query.replace(/(?<=\d) (?=\d{3}(?!\d))/g, "")).trim().split(" ");
  const terms = words.map((word) => [word, synonyms[word]].filter(Boolean).map((term) => ` ${term}`));
  const count = (text, term) => term.reduce((sum, word) => sum + text.split(word).length - 1, 0);
  // A word in the heading counts most. In the text its density counts, so that long sections are not preferred.
  const rank = (entry) => terms.reduce((sum, term) => sum + 2 * Math.min(1, count(entry.head, term)) + density(entry, term), 0);
  const density = ({ words }, term) => count(words, term) / (count(words, term) + words.length / 2000);
  const results = entries.filter((entry) => terms.every((term) => count(entry.words, term)));
  return results.sort((a, b) => rank(b) - rank(a)).slice(0, RESULT_LIMIT);
}

function excerpt(text, query) {
  const start = Math.max(0, text.toLowerCase().indexOf(query.trim().toLowerCase().split(/\s+/)[0]) - 40);
  return start ? `…${text.slice(start, start + 110).replace(/^\S*\s/, "").trim()}…` : `${text.slice(0, 110).trim()}…`;
}

function addSearch() {
  if (!location.protocol.startsWith("http")) return; // a page that was opened from a file cannot fetch the others
  const [form, field, list] = ["search", "input", "ol"].map((tag) => document.createElement(tag));
  form.className = "search";
  Object.assign(field, { type: "search", placeholder: "Search", ariaLabel: "Search these pages" });
  list.ariaLive = "polite";
  list.hidden = true;
  form.append(field, list);
  document.querySelector(".bar .scheme").before(form);
  let pages = null;
  const show = async () => {
    const query = field.value;
    if (!plainWords(query).trim()) return (list.hidden = true);
    const entries = await (pages ??= readPages().catch(() => []));
    if (query !== field.value) return; // the reader typed on in the meantime
    const results = findEntries(entries, query).map((entry) => {
      const [line, link] = ["li", "a"].map((tag) => document.createElement(tag));
      link.href = entry.address;
      link.textContent = entry.title;
      line.append(link, ` ${excerpt(entry.text, query)}`);
      return line;
    });
    if (!results.length) results.push(Object.assign(document.createElement("li"), { textContent: "No results." }));
    list.replaceChildren(...results);
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

setScheme(storedScheme());

document.addEventListener("DOMContentLoaded", () => {
  followOldLink();
  openNamedSection();
  addSchemeSwitch();
  addSearch();
  markPlace();
  addChoice();
  for (const table of document.querySelectorAll("main .wide table")) rove([...addSorting(table), addCopying(table)]);
  rove([...document.querySelectorAll(".sources a")]);
  document.querySelectorAll("pre").forEach(addCodeCopying);
  addOrigins();
});
addEventListener("hashchange", followOldLink);
addEventListener("hashchange", openNamedSection);
addEventListener("click", openAgain);
