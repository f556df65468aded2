// ---- view.js: the state, the panels, the address.

/** The polygon at the beginning: a bracket with corners, straight edges and a notch. */
const BRACKET = [[0, 0], [4, 0], [5, 5], [4, 10], [0, 10], [0, 8], [1, 8], [2, 5], [1, 2], [0, 2]];
const GRIDS = [16, 32, 64, 100, 128, 256, 512, 1000, 1024, 2048, 4096, 16384, 65536, 1048576, 16777216];
const MOST_LEVELS = 8;
/** Combs and limits need points close together, whatever level is shown. */
const COMB_LEVEL = 6;
const MOST_VERTICES = 200;

const interpolating = data.interpolating.values?.map(parseRational);
const start = data.start.map(parseRational);

/** A grid on which the point moves by less than a two-hundredth of what is seen. */
function fittingGrid(chart) {
  if (!chart) return GRIDS[0];
  const fine = 200 / Math.min(...chart.widths());
  return GRIDS.find((count) => count >= fine) ?? GRIDS[GRIDS.length - 1];
}

const state = {
  point: start,
  grid: 0,
  points: BRACKET,
  tags: BRACKET.map(() => 0),
  closed: true,
  levels: 5,
  comb: false,
  selected: 0,
  theme: null,
};

// ---- The address: all of the state, so that a view can be shared.

function toHash() {
  const tags = state.tags.flatMap((tag, i) => (tag === 1 ? [i] : []));
  const entries = {
    at: state.point.map(toText).join(","),
    grid: state.grid,
    view: (chart?.view() ?? []).map((span) => span.join(",")).join(";"),
    points: state.points.map((p) => p.join(",")).join(";"),
    interpolate: tags.join(","),
    closed: state.closed ? 1 : 0,
    levels: state.levels,
    comb: state.comb ? 1 : 0,
    theme: state.theme ?? "",
  };
  const filled = Object.entries(entries).filter(([, value]) => value !== "");
  return `#${filled.map(([name, value]) => `${name}=${value}`).join("&")}`;
}

/** Some programs write `%3B` for `;` when they pass an address on. */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Takes from an address what can be read, and leaves the rest as it is. */
function fromHash(hash) {
  const entries = new Map(decoded(hash.slice(1)).split("&").map((entry) => entry.split("=", 2)));
  const text = (name) => entries.get(name) ?? "";
  const at = text("at").split(",").map(parseRational);
  if (at.length === parameters.length && at.every((x) => x)) state.point = at;
  if (GRIDS.includes(Number(text("grid")))) state.grid = Number(text("grid"));
  const view = text("view").split(";").map((span) => span.split(",").map(Number));
  chart?.look(view.length === parameters.length ? view : null);
  const points = text("points").split(";").map((p) => p.split(",").map(Number));
  const isPolygon = points.every((p) => p.length === 2 && p.every((x) => Math.abs(x) <= 1e6));
  if (isPolygon && points.length >= 2 && points.length <= MOST_VERTICES) {
    state.points = points.map((p) => p.map(rounded));
    state.selected = 0;
  }
  const tagged = interpolating ? text("interpolate").split(",") : [];
  state.tags = state.points.map((_, i) => (tagged.includes(`${i}`) ? 1 : 0));
  if (entries.has("closed")) state.closed = text("closed") === "1";
  const levels = Number(text("levels"));
  if (entries.has("levels") && Number.isInteger(levels) && levels >= 0 && levels <= MOST_LEVELS) {
    state.levels = levels;
  }
  if (entries.has("comb")) state.comb = text("comb") === "1";
  if (["dark", "light"].includes(text("theme"))) state.theme = text("theme");
}

// ---- Command lines.

const quoted = (word) =>
  /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
const command = (...words) => ["refinable", ...words].map(quoted).join(" ");
const assigned = (values) => parameters.map((name, k) => `${name}=${toText(values[k])}`);
const spelled = (values) => parameters.map((name, k) => `${letter(name)} = ${typeset(toText(values[k]))}`).join(", ");
const settings = () => assigned(state.point).flatMap((setting) => ["--set", setting]);

function curveCommand(hasComb) {
  const points = `printf '%s\\n' ${state.points.map((p) => p.join(",")).join(" ")}`;
  const levels = ["-l", `${state.levels}`, "-o", "curve.svg"];
  const closed = state.closed ? ["--closed"] : [];
  const tagged = state.tags.flatMap((tag, i) => (tag === 1 ? [i] : []));
  if (tagged.length > 0) {
    const members = ["--interpolating", assigned(interpolating).join(",")];
    members.push("--approximating", assigned(state.point).join(","));
    const interpolate = ["--interpolate", tagged.join(",")];
    return `${points} | ${command("interproximate", ...data.words, ...closed, ...interpolate, ...members, ...levels)}`;
  }
  const ends = state.closed ? closed : ["--ends", "reflect"];
  const comb = hasComb ? ["--comb"] : [];
  return `${points} | ${command("curve", ...data.words, ...settings(), ...ends, ...comb, ...levels)}`;
}

/** Makes the certificate of an order again, the same as was used here. */
function certifyCommand(n, isAlone) {
  const file = `C${n}.json`;
  if (isAlone) return command("certify", ...data.words, ...settings(), "-n", `${n}`, "-o", file);
  return smoothness.kind === "plane"
    ? command("map", ...data.words, ...smoothness.words, "-n", `${n}`, "--certificate", file)
    : command("certify", ...data.words, "-n", `${n}`, "-o", file);
}

// ---- Mask and rules.

function latexOf(member) {
  const { common, tops } = cleared(member.mask);
  const front = common === 1n ? "" : `\\frac{1}{${common}}`;
  return `${front}\\left[${tops.join(", ")}\\right]`;
}

/** A list with a shift behind it where it does not stand as a centred one would. */
function maskText(member) {
  const { common, tops } = cleared(member.mask);
  const list = `[${tops.join(", ")}]`;
  const centred = -Math.floor(member.mask.length / 2);
  const shift = member.first === centred ? "" : ` @ ${member.first}`;
  return typeset(`${common === 1n ? "" : `1/${common}*`}${list}${shift}`);
}

function ruleElement({ first, weights }, e) {
  const place = (k) => (k === 0 ? "i" : typeset(`i${k > 0 ? "+" : ""}${k}`));
  const index = (text) => html("sub", {}, ...[...text].map((c) => (c === "i" ? html("i", {}, c) : c)));
  const row = html("p", { class: "rule" }, html("i", {}, "f"), "′", index(`${arity}i${e > 0 ? `+${e}` : ""}`), " =");
  const used = weights.map((w, k) => [w, first + k]).filter(([w]) => !isZero(w));
  used.forEach(([w, k], nth) => {
    const size = w.n < 0n ? minus(ZERO, w) : w;
    const sign = w.n < 0n ? "\u2212" : nth > 0 ? "+" : "";
    const number = equal(size, ONE) ? "" : `${toText(size)}\u202f`;
    const space = nth > 0 ? "\u00a0" : "";
    const factor = `${sign}${space}${number}`;
    row.append(" ", html("span", { class: "term" }, factor, html("i", {}, "f"), index(place(k))));
  });
  return row;
}

// ---- Panels.

const chart = smoothness.kind === "scheme" ? null : createChart(byId("chart"), {
  move: (floats) => setPoint(floats.map((x) => nearest(x, state.grid))),
  step: (direction) => {
    const unit = ratio(1n, BigInt(state.grid));
    setPoint(state.point.map((x, k) => plus(x, times(unit, ratio(BigInt(direction[k]))))));
  },
  zoom,
});

/** Looks nearer, or from further away, around the point, and fits the grid. */
function zoom(factor) {
  chart.look(chart.around(factor));
  state.grid = fittingGrid(chart);
  update();
}

const canvas = createCanvas(byId("canvas"), {
  move(i, place) {
    state.points = state.points.with(i, place);
    update();
  },
  insert: insertVertex,
  remove: removeVertex,
  select(i) {
    state.selected = i;
    update();
  },
  toggle: toggleTag,
});

function setPoint(point) {
  state.point = point;
  byId("entry-error").textContent = "";
  update();
}

function insertVertex(after, place) {
  if (state.points.length >= MOST_VERTICES) return;
  state.points = state.points.toSpliced(after + 1, 0, place);
  state.tags = state.tags.toSpliced(after + 1, 0, 0);
  state.selected = after + 1;
  update();
  canvas.focus(state.selected);
}

function removeVertex(i) {
  if (state.points.length <= 2) return;
  state.points = state.points.toSpliced(i, 1);
  state.tags = state.tags.toSpliced(i, 1);
  state.selected = Math.min(i, state.points.length - 1);
  update();
  canvas.focus(state.selected);
}

function toggleTag(i) {
  if (!interpolating) return;
  state.tags = state.tags.with(i, 1 - state.tags[i]);
  update();
}

function showVerdicts(verdicts) {
  const proved = verdicts.filter(({ verdict }) => verdict === "proved").map((v) => v.continuity);
  const highest = proved.length > 0 ? Math.max(...proved) : null;
  const next = verdicts.find(({ continuity }) => continuity === (highest ?? -1) + 1);
  const parts = [highest === null ? "No continuity is proved" : `${order(highest)} is proved`];
  if (next) parts.push(`${order(next.continuity)} is ${next.verdict}`);
  // Set only when it changes: changes are read out.
  const headline = next?.verdict === "undefined" ? "The family has a pole here" : parts.join(", ");
  if (byId("headline").textContent !== headline) byId("headline").textContent = headline;
  byId("certificate").hidden = highest === null;
  byId("certify").textContent = certifyCommand(highest ?? 0, verdicts[highest ?? 0].isAlone);
  byId("verdicts").replaceChildren(...verdicts.map(({ continuity, verdict, because }) => {
    const name = html("span", { class: "order" }, order(continuity));
    const word = html("span", { class: `verdict ${verdict}` }, verdict);
    const reason = html("span", { class: "reason" }, typeset(because));
    return html("li", { "data-order": continuity, "data-verdict": verdict }, name, word, reason);
  }));
}

function showFacts(member) {
  const facts = [];
  if (member) {
    const here = degreesAt(state.point);
    const more = data.degrees.complete ? "" : "at least ";
    const end = last(member);
    const width = ratio(BigInt(end - member.first), BigInt(arity - 1));
    facts.push(["generation", `${more}${here.generation}`], ["reproduction", `${more}${here.reproduction}`]);
    facts.push(["type", typeOf(member).join(", ")]);
    facts.push(["support", typeset(`[${member.first}, ${end}], width ${toText(width)}`)]);
    const holder = smoothness.holder ?? knownMember(state.point)?.holder;
    if (holder) facts.push(["Hölder exponent", typeset(holder)]);
    const where = here.condition === "generic" ? "those of almost all members" : `special here: ${here.condition}`;
    byId("stratum").textContent = parameters.length > 0 ? typeset(where) : "";
  }
  const rows = facts.map(([name, value]) =>
    html("div", { "data-fact": name }, html("dt", {}, name), html("dd", {}, value)));
  byId("facts").replaceChildren(...rows);
  byId("facts").closest("section").hidden = !member;
}

function showMask(member) {
  byId("mask").textContent = member ? maskText(member) : "The family has a pole here: there is no mask.";
  byId("rules").replaceChildren(...(member ? stencils(member).map(ruleElement) : []));
}

/** Shows the curve; tells whether with its comb. */
function showCurve(member, verdicts) {
  const { points, tags, closed, selected } = state;
  const isSmooth = verdicts.some((v) => v.continuity === 2 && v.verdict === "proved");
  const isTagged = tags.includes(1);
  const canComb = member !== null && isSmooth && !isTagged;
  let [curve, comb] = [[], null];
  if (member) {
    const rules = [member, ...(interpolating ? [memberAt(interpolating)] : [])].map(floatRule);
    curve = refine(points, tags, rules, closed, state.levels);
    if (canComb && state.comb) {
      const level = Math.max(state.levels, COMB_LEVEL);
      const bases = level === state.levels ? curve : refine(points, tags, rules, closed, level);
      comb = { bases, tips: combTips(bases, closed, canvas.toothLength(points)) };
    }
  }
  canvas.show({ points, tags, closed, curve, comb, selected });
  byId("comb").disabled = !canComb;
  const ends = closed ? "" : "; the ends are reflected";
  const why = isTagged ? "for curves without interpolated vertices" : `where ${order(2)} is proved`;
  const combs = canComb ? "" : ` Curvature combs are drawn ${why}.`;
  const diverges = verdicts[0]?.verdict === "refuted" ? ` No continuous limit: ${order(0)} is refuted here.` : "";
  const note = `${curve.length} points in floats${ends}.${diverges}${combs}`;
  byId("curve-note").textContent = member ? note : "There is no curve: the family has a pole here.";
  byId("tag").setAttribute("aria-pressed", tags[selected] === 1);
  byId("remove").disabled = points.length <= 2;
  byId("selected").textContent = `Vertex ${selected} at (${typeset(points[selected].join(", "))})`;
  return comb !== null;
}

const copyable = new Map();
function showCommands(member, hasComb) {
  const texts = {
    "Hölder exponent": command("regularity", ...data.words, ...settings()),
    "this curve": curveCommand(hasComb),
    "mask in LaTeX": member ? latexOf(member) : "",
    "this view": location.href.split("#")[0] + toHash(),
  };
  for (const [name, text] of Object.entries(texts)) {
    const code = copyable.get(name);
    code.textContent = text;
    code.closest("li").hidden = !member && name !== "this view";
  }
}

async function copy(name) {
  const code = copyable.get(name);
  try {
    await navigator.clipboard.writeText(code.textContent);
    byId("copied").textContent = `Copied: ${name}.`;
  } catch {
    // Without leave to write there, the text is at least selected.
    getSelection().selectAllChildren(code);
    byId("copied").textContent = "Selected: copy it with the keyboard.";
  }
}

function showControls() {
  for (const name of ["closed", "comb"]) byId(name).checked = state[name];
  byId("levels").value = state.levels;
  byId("levels-value").textContent = state.levels;
  byId("grid").value = state.grid;
  parameters.forEach((_, k) => {
    const field = byId(`parameter-${k}`);
    // What is being typed is left alone.
    if (document.activeElement !== field) field.value = toText(state.point[k]);
  });
  const isDark = state.theme ? state.theme === "dark" : prefersDark.matches;
  document.documentElement.dataset.theme = isDark ? "dark" : "light";
  byId("theme").setAttribute("aria-pressed", isDark);
}

// ---- One update for all that changed, once for each frame.

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
let isPending = false;
function update() {
  if (isPending) return;
  isPending = true;
  requestAnimationFrame(() => {
    isPending = false;
    show();
  });
}

function show() {
  const member = memberAt(state.point);
  const verdicts = verdictsAt(state.point);
  showControls();
  chart?.show(state.point);
  showVerdicts(verdicts);
  showFacts(member);
  showMask(member);
  showCommands(member, showCurve(member, verdicts));
  history.replaceState(null, "", toHash());
}

// ---- What is built once.

function buildEntry() {
  byId("entry").append(...parameters.map((name, k) => {
    const change = (event) => {
      const value = parseRational(event.target.value);
      event.target.setAttribute("aria-invalid", value === null);
      if (value !== null) return setPoint(state.point.with(k, value));
      byId("entry-error").textContent = `${letter(name)}: enter a number such as 1/16, -0.05 or 3/128.`;
    };
    const field = html("input", {
      id: `parameter-${k}`, type: "text", inputmode: "text", spellcheck: "false", "aria-label": name, change,
      "aria-describedby": "entry-error",
    });
    return html("label", { for: `parameter-${k}` }, `${letter(name)} = `, field);
  }));
  byId("entry").addEventListener("submit", (event) => event.preventDefault());
  byId("entry").addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    event.target.dispatchEvent(new Event("change"));
  });
}

function buildNotable() {
  const marks = new Map();
  const mark = (point, text) => {
    const list = point.map(toText).join(", ");
    const place = typeset(parameters.length > 1 ? `(${list}) ` : `${letter(parameters[0])} = ${list} `);
    marks.set(place, { point, texts: [...(marks.get(place)?.texts ?? []), text] });
  };
  if (data.smoothest) mark(data.smoothest.map(parseRational), "smoothest found");
  if (interpolating) mark(interpolating, "interpolates");
  for (const { point, generation, reproduction } of strata.filter((s) => s.point)) {
    mark(point, `degrees ${generation}, ${reproduction}`);
  }
  for (const { point, holder } of members.filter((m) => m.holder)) mark(point, `exponent ${holder}`);
  byId("notable").append(...[...marks].map(([place, { point, texts }]) =>
    html("button", { type: "button", class: "mark", click: () => setPoint(point) }, place, html("small", {}, texts.join("; "))),
  ));
}

function buildCommands() {
  for (const name of ["Hölder exponent", "this curve", "mask in LaTeX", "this view"]) {
    const code = html("code", {});
    copyable.set(name, code);
    const button = html("button", { type: "button", click: () => copy(name), "aria-label": `Copy: ${name}` }, "Copy");
    byId("commands").append(html("li", {}, html("div", { class: "row" }, html("span", {}, name), button), code));
  }
}

function build() {
  byId("name").textContent = data.scheme;
  const list = parameters.map(letter).join(", ");
  byId("subtitle").textContent = {
    plane: `Certified smoothness over (${list}), and limit curves`,
    line: `Certified smoothness over ${list}, and limit curves`,
    scheme: "Certified smoothness, and limit curves",
  }[smoothness.kind];
  byId("grid").append(...GRIDS.map((count) => html("option", { value: count }, `1/${count}`)));
  byId("place").hidden = !chart;
  if (chart) {
    buildEntry();
    buildNotable();
    byId("legend").append(...legendEntries().map(([sample, text]) =>
      html("li", {}, html("span", { class: `sample ${sample}` }), text)));
  }
  buildCommands();
  byId("tag").hidden = !interpolating;
  byId("tag-note").textContent = interpolating
    ? `An interpolated vertex, and the edge after it, takes ${spelled(interpolating)}; all others take the point above.`
    : `Vertices cannot be tagged as interpolated: ${data.interpolating.missing}.`;
  const on = (id, event, action) => byId(id).addEventListener(event, (e) => { action(e.target); update(); });
  on("grid", "change", (field) => { state.grid = Number(field.value); });
  on("levels", "input", (field) => { state.levels = Number(field.value); });
  on("zoom-in", "click", () => zoom(0.5));
  on("zoom-out", "click", () => zoom(2));
  on("closed", "change", (field) => { state.closed = field.checked; });
  on("comb", "change", (field) => { state.comb = field.checked; });
  on("theme", "click", () => {
    state.theme = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  });
  on("add", "click", () => {
    const [here, next] = [0, 1].map((k) => state.points[(state.selected + k) % state.points.length]);
    insertVertex(state.selected, here.map((x, k) => rounded((x + next[k]) / 2)));
  });
  on("remove", "click", () => removeVertex(state.selected));
  on("tag", "click", () => toggleTag(state.selected));
  on("reset", "click", () => {
    Object.assign(state, { points: BRACKET, tags: BRACKET.map(() => 0), closed: true, selected: 0 });
  });
  prefersDark.addEventListener("change", update);
  addEventListener("hashchange", () => { fromHash(location.hash); update(); });
  state.grid = fittingGrid(chart);
  fromHash(location.hash);
  show();
}

build();
