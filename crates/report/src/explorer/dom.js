// ---- dom.js: elements.

const byId = (id) => document.getElementById(id);
// Taken from the page, which so names no address at all.
const SVG = byId("defs").namespaceURI;

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== null) element.setAttribute(name, value);
  }
  // Text becomes text nodes: no name or number can turn into markup.
  element.append(...children);
  return element;
}

const html = (name, attributes = {}, ...children) =>
  fill(document.createElement(name), attributes, children);

const svg = (name, attributes = {}, ...children) =>
  fill(document.createElementNS(SVG, name), attributes, children);

const GREEK = "alpha α beta β gamma γ delta δ epsilon ε theta θ lambda λ mu μ nu ν rho ρ sigma σ tau τ omega ω";
const LETTERS = new Map(GREEK.split(" ").flatMap((word, k, all) => (k % 2 ? [] : [[word, all[k + 1]]])));
/** A parameter as it is printed. */
const letter = (parameter) => LETTERS.get(parameter) ?? parameter;
const raised = (n) => [...`${n}`].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join("");
const order = (n) => `C${raised(n)}`;
/** A proper minus sign. */
const typeset = (text) => text.replaceAll("-", "\u2212");

/** Calls `draw(width)` now and whenever the width of the element changes. */
function drawToWidth(element, draw) {
  let known = 0;
  const update = () => {
    const width = Math.floor(element.clientWidth);
    if (width > 0 && width !== known) draw((known = width));
  };
  new ResizeObserver(update).observe(element);
  update();
}

/** Drags: `move(event)` for every place of the pointer from the press on, `end()` after the last. */
function onDrag(element, { accepts = () => true, start = () => {}, move, end = () => {} }) {
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !accepts(event)) return;
    element.setPointerCapture(event.pointerId);
    start(event);
    const follow = (event) => move(event);
    const stop = () => {
      element.removeEventListener("pointermove", follow);
      element.removeEventListener("pointerup", stop);
      element.removeEventListener("pointercancel", stop);
      end();
    };
    element.addEventListener("pointermove", follow);
    element.addEventListener("pointerup", stop);
    element.addEventListener("pointercancel", stop);
  });
}

const STEPS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
/** The direction of an arrow key, ten times as far with Shift; null for other keys. */
function arrowStep(event) {
  const step = STEPS[event.key];
  return step ? step.map((s) => s * (event.shiftKey ? 10 : 1)) : null;
}
