// Define the settings that a reader can change: their ranges, their shipped values, and their form in an address.

/**
 * @typedef {Object} Settings
 * @property {number} ke stiffness of the pads [N/m per kg, as Newton's ke]
 * @property {number} kd damping of the pads
 * @property {number} mu friction of the pads
 * @property {number} impratio
 * @property {string} cone
 * @property {number} substeps steps of the engine in a frame of 1/60 s
 * @property {string} integrator
 * @property {string} term the term in the friction rows: off, on, centred
 * @property {number} grip_n force of each finger [N]
 * @property {number} mass_g of the cube [g]
 * @property {number} edge_mm of the cube [mm]
 * @property {number} amplitude_mm of the shake [mm]
 * @property {number} frequency_hz of the shake [Hz]
 * @property {number} gravity_m_s2 downward [m/s²]
 */

/** Smallest and largest value, and whether the steps of the control are ratios. @type {Record<string, [number, number, boolean]>} */
export const RANGES = {
  ke: [100, 1e7, true],
  kd: [5, 1e5, true],
  mu: [0.05, 5, true],
  impratio: [1, 1000, true],
  substeps: [2, 64, true],
  grip_n: [1, 60, true],
  mass_g: [5, 1000, true],
  edge_mm: [15, 60, false],
  amplitude_mm: [0, 150, false],
  frequency_hz: [0.2, 3, false],
  gravity_m_s2: [0, 20, false],
};
/** @type {Record<string, string[]>} */
export const CHOICES = {
  cone: ["elliptic", "pyramidal"],
  integrator: ["implicitfast", "Euler", "implicit", "RK4", "discrete"],
  term: ["off", "on", "centred"],
};
/** @type {Settings} */
export const SHIPPED = {
  ke: 2500,
  kd: 100,
  mu: 1,
  impratio: 50,
  cone: "elliptic",
  substeps: 16,
  integrator: "implicitfast",
  term: "off",
  grip_n: 12,
  mass_g: 32,
  edge_mm: 40,
  amplitude_mm: 30,
  frequency_hz: 1,
  gravity_m_s2: 9.81,
};

/** Named settings, as differences from the shipped ones. @type {Record<string, Partial<Settings>>} */
export const CASES = {
  "as shipped": {},
  "stiff pads": { ke: 2.5e5, kd: 1e3 },
  "the term": { term: "on" },
  "the root cure": { term: "centred", integrator: "Euler", impratio: 1000 },
  "as shipped, 100 mm": { amplitude_mm: 100 },
  "stiff pads, 100 mm": { ke: 2.5e5, kd: 1e3, amplitude_mm: 100 },
};

/**
 * Read settings from an address, each within its range. Missing and invalid ones are as shipped.
 * @param {string} query such as kd=400&cone=pyramidal
 * @returns {Settings}
 */
export function read(query) {
  const said = new URLSearchParams(query);
  const found = Object.entries(SHIPPED).map(([name, shipped]) => [name, taken(name, said.get(name)) ?? shipped]);
  return Object.fromEntries(found);
}

/** @param {string} name @param {string | null} text */
function taken(name, text) {
  if (text === null) return undefined;
  if (name in CHOICES) return CHOICES[name].includes(text) ? text : undefined;
  const value = Number(text);
  if (text.trim() === "" || !Number.isFinite(value)) return undefined;
  const [least, most] = RANGES[name];
  const within = Math.min(Math.max(value, least), most);
  return name === "substeps" ? Math.round(within) : within;
}

/** Return the part of an address with the settings that are not as shipped. @param {Settings} settings */
export function write(settings) {
  return Object.entries(settings)
    .filter(([name, value]) => value !== SHIPPED[/** @type {keyof Settings} */ (name)])
    .map(([name, value]) => `${name}=${encodeURIComponent(value)}`)
    .join("&");
}

/**
 * Return settings as the parameters of a case, with the names and units of the records' columns.
 * @param {Settings} settings
 */
export function caseOf(settings) {
  const edge_m = settings.edge_mm / 1e3;
  return {
    pad_ke: settings.ke,
    pad_kd: settings.kd,
    pad_mu: settings.mu,
    impratio: settings.impratio,
    cone: settings.cone,
    substeps: settings.substeps,
    integrator: settings.integrator,
    contact_bias: settings.term !== "off",
    bias_centred: settings.term === "centred",
    finger_closed_m: edge_m / 2 - settings.grip_n / FINGER_STIFFNESS_N_M,
    cube_density_kg_m3: settings.mass_g / 1e3 / edge_m ** 3,
    cube_edge_m: edge_m,
    shake_amplitude_m: settings.amplitude_mm / 1e3,
    shake_frequency_hz: settings.frequency_hz,
    gravity_m_s2: settings.gravity_m_s2,
  };
}

const FINGER_STIFFNESS_N_M = 400;
