// ---- chart.js: the map of two parameters, or the ranges of one, with a point that can be moved.

const MARGIN = { left: 64, right: 12, top: 12, bottom: 40 };
const SHADES = 8;
const ROW = 34;
/** Pixels between the bends of an edge that is a curve in the parameters, and how many bends at most. */
const EDGE = 16;
const MOST_BENDS = 16;
/** Cells of the net on which curves of degrees are traced. */
const NET = 140;

const shadeOf = (k, count) => Math.min(Math.floor((k * SHADES) / Math.max(count, 3)), SHADES - 1);

/** Both parts of a convex polygon in floats. */
function cutFloat(polygon, [a, b, c]) {
  const sides = polygon.map(([x, y]) => a * x + b * y - c);
  const part = (sign) =>
    polygon.flatMap((p, i) => {
      const k = (i + 1) % polygon.length;
      const [q, s, t] = [polygon[k], sides[i] * sign, sides[k] * sign];
      const kept = s >= 0 ? [p] : [];
      if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
        const f = s / (s - t);
        kept.push([p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])]);
      }
      return kept;
    });
  return [part(-1), part(1)];
}

/** The pieces of a map with their reasons, in floats. */
function floatPieces(map) {
  const pieces = [];
  const open = map.trees.map((tree, k) => [tree, map.parts[k].map((p) => p.map(toFloat))]);
  while (open.length > 0) {
    const [node, polygon] = open.pop();
    if (polygon.length < 3) continue;
    if (typeof node === "number") {
      pieces.push({ verdict: map.reasons[node].verdict, polygon });
      continue;
    }
    const [below, above] = cutFloat(polygon, node.line.map(Number));
    open.push([node.below, below], [node.above, above]);
  }
  return pieces;
}

function areaOf(polygon) {
  const cross = polygon.map(([x, y], i) => {
    const [p, q] = polygon[(i + 1) % polygon.length];
    return x * q - p * y;
  });
  return Math.abs(cross.reduce((sum, c) => sum + c, 0)) / 2;
}

/** Round numbers between two ends. */
function ticks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((step) => step >= rough);
  const from = Math.ceil(low / step - 1e-9);
  const to = Math.floor(high / step + 1e-9);
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return Array.from({ length: to - from + 1 }, (_, k) => {
    const value = (from + k) * step;
    return { value, text: typeset(value.toFixed(digits)) };
  });
}

/** The curve on which a polynomial vanishes, where it changes its sign between the nodes of a net. */
function traced(terms, [[u0, u1], [v0, v1]]) {
  const u = (i) => u0 + ((u1 - u0) * i) / NET;
  const v = (j) => v0 + ((v1 - v0) * j) / NET;
  const values = Array.from({ length: NET + 1 }, (_, i) =>
    Array.from({ length: NET + 1 }, (_, j) => evaluateFloat(terms, [u(i), v(j)])),
  );
  const segments = [];
  for (let i = 0; i < NET; i++) {
    for (let j = 0; j < NET; j++) {
      const corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const crossings = corners.flatMap(([a, b], k) => {
        const [c, d] = corners[(k + 1) % 4];
        const [s, t] = [values[a][b], values[c][d]];
        if (s < 0 === t < 0) return [];
        const f = s / (s - t);
        return [[u(a + f * (c - a)), v(b + f * (d - b))]];
      });
      if (crossings.length === 2) segments.push(crossings);
    }
  }
  return segments;
}

/** How far a view may be from the whole. */
const DEEPEST = 1e-5;

/** The chart in an element; `move(floats)` is called while the point is dragged, `step(direction)` and
    `zoom(factor)` for keys. */
function createChart(element, { move, step, zoom }) {
  const isPlane = smoothness.kind === "plane";
  const whole = smoothness.window.map((span) => span.map(parseRational).map(toFloat));
  let spans = whole;
  const pieces = maps.map(floatPieces);
  const curves = strata.filter((s) => isPlane && s.vanishes).map((s) => s.vanishes);
  const lines = factor?.map(toFloat);
  let size = { width: 0, height: 0 };
  let shown = null;

  const inner = () => [
    size.width - MARGIN.left - MARGIN.right,
    size.height - MARGIN.top - MARGIN.bottom,
  ];
  const across = (u) => MARGIN.left + ((u - spans[0][0]) / (spans[0][1] - spans[0][0])) * inner()[0];
  const down = (v) =>
    MARGIN.top + ((spans[1][1] - v) / (spans[1][1] - spans[1][0])) * inner()[1];
  const fixed = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

  /** Points of the plane of (x, y) in pixels, with bends where a straight edge is a curve in the parameters. */
  function bent(points, closed) {
    if (!lines) return points.map(([x, y]) => [across(x), down(y)]);
    const l = (x) => lines[0] + lines[1] * x;
    const place = ([x, y]) => [across(x), down(y / l(x))];
    const isSingular = ([x]) => Math.abs(l(x)) < 1e-12;
    const count = closed ? points.length : points.length - 1;
    const all = [];
    for (let i = 0; i < count; i++) {
      const [p, q] = [points[i], points[(i + 1) % points.length]];
      // A corner at which the factor vanishes is a whole edge there; on edges towards it v is constant.
      if (isSingular(p) && isSingular(q)) continue;
      if (isSingular(p)) {
        all.push([across(p[0]), place(q)[1]]);
        continue;
      }
      if (isSingular(q)) {
        all.push(place(p), [across(q[0]), place(p)[1]]);
        continue;
      }
      const [[px, py], [qx, qy]] = [place(p), place(q)];
      const bends = Math.floor(Math.min(Math.max(Math.hypot(qx - px, qy - py) / EDGE, 1), MOST_BENDS));
      for (let k = 0; k < bends; k++) {
        const f = k / bends;
        const [x, y] = [p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1])];
        all.push(place([x, y]));
      }
    }
    const last = points[points.length - 1];
    if (!closed && !isSingular(last)) all.push(place(last));
    return all;
  }

  const isInSight = (places) =>
    [[0, size.width], [1, size.height]].every(
      ([k, end]) => places.some((p) => p[k] >= 0) && places.some((p) => p[k] <= end),
    );
  const pathOf = (pieces, verdict) =>
    pieces
      .filter((piece) => piece.verdict === verdict)
      .map((piece) => bent(piece.polygon, true))
      .filter(isInSight)
      .map((places) => `M${places.map(fixed).join("L")}Z`)
      .join("");

  function sectionPaths(map, verdict) {
    return map.sections.flatMap(({ origin, direction, intervals }) => {
      const at = (t) => [0, 1].map((k) => toFloat(origin[k]) + toFloat(direction[k]) * t);
      const those = intervals.filter((interval) => interval.verdict === verdict);
      return those.filter(({ lower, upper }) => lower && upper).map(({ lower, upper }) => {
        const ends = [at(numberToFloat(lower)), at(numberToFloat(upper))];
        const isPoint = direction.every(isZero);
        return isPoint ? { point: bent([ends[0]], false)[0] } : { path: `M${bent(ends, false).map(fixed).join("L")}` };
      });
    });
  }

  /** The name of an order in its largest piece that has no higher order in its middle. */
  function labels() {
    return maps.flatMap((_, k) => {
      const proved = pieces[k].filter((piece) => piece.verdict === "proved");
      const sorted = proved.map((piece) => [areaOf(piece.polygon), piece.polygon]).sort((a, b) => b[0] - a[0]);
      for (const [, polygon] of sorted) {
        const middle = [0, 1].map((i) => polygon.reduce((sum, p) => sum + p[i], 0) / polygon.length);
        const exact = middle.map((x) => nearest(x, 2 ** 40));
        const covered = maps[k + 1] && reasonsAt(maps[k + 1], exact).some((r) => r.verdict === "proved");
        if (covered) continue;
        const [x, y] = bent([middle], false)[0];
        if (!isInSight([[x - 20, y - 20], [x + 20, y + 20]])) continue;
        return [svg("text", { class: "label", x, y: y + 5, "text-anchor": "middle" }, order(maps[k].continuity))];
      }
      return [];
    });
  }

  function planeLayers() {
    const clip = svg("clipPath", { id: "box" }, svg("rect", box()));
    const layers = maps.map((_, k) =>
      svg("path", { class: `shade shade-${shadeOf(k, maps.length)}`, d: pathOf(pieces[k], "proved") }),
    );
    layers.push(
      ...maps.map((_, k) => svg("path", { class: "undecided", d: pathOf(pieces[k], "undecided") })),
      ...curves.map((terms) => {
        const segments = traced(terms, spans);
        const place = ([u, v]) => fixed([across(u), down(v)]);
        const d = segments.map(([p, q]) => `M${place(p)}L${place(q)}`).join("");
        return svg("path", { class: "stratum", d });
      }),
      ...maps.flatMap((map, k) => sectionPaths(map, "proved").flatMap(({ path, point }) => {
        const shade = shadeOf(k, maps.length);
        if (point) return [svg("circle", { class: `dot shade-${shade}`, cx: point[0], cy: point[1], r: 4.5 })];
        return [
          svg("path", { class: "section-rim", d: path }),
          svg("path", { class: `section stroke-${shade}`, d: path }),
        ];
      })),
      ...labels(),
    );
    return [clip, svg("g", { "clip-path": "url(#box)" }, ...layers)];
  }

  function lineLayers() {
    return ranges.flatMap((range, k) => {
      const y = MARGIN.top + k * ROW;
      const clamp = (u) => Math.min(Math.max(across(u), MARGIN.left), size.width - MARGIN.right);
      const parts = range.intervals.filter(({ verdict }) => verdict !== "refuted").map((interval) => {
        const left = interval.lower ? clamp(numberToFloat(interval.lower)) : MARGIN.left;
        const right = interval.upper ? clamp(numberToFloat(interval.upper)) : size.width - MARGIN.right;
        const shade = `shade shade-${shadeOf(k, ranges.length)}`;
        const kind = { proved: shade, undecided: "undecided", undefined: "pole" }[interval.verdict];
        if (right - left < 0.5) return svg("circle", { class: kind, cx: left, cy: y + ROW / 2, r: 4 });
        return svg("rect", { class: kind, x: left, width: right - left, y: y + 5, height: ROW - 10 });
      });
      const name = svg(
        "text",
        { class: "tick", x: MARGIN.left - 10, y: y + ROW / 2 + 5, "text-anchor": "end" },
        order(range.continuity),
      );
      return [...parts, name];
    });
  }

  const box = () => ({ x: MARGIN.left, y: MARGIN.top, width: inner()[0], height: inner()[1] });

  function axes() {
    const base = size.height - MARGIN.bottom;
    const marks = [svg("rect", { class: "frame", ...box() })];
    for (const { value, text } of ticks(...spans[0], Math.max(2, inner()[0] / 90))) {
      const x = across(value);
      marks.push(svg("path", { class: "axis", d: `M${x} ${base}v5` }));
      marks.push(svg("text", { class: "tick", x, y: base + 18, "text-anchor": "middle" }, text));
    }
    const name = { class: "axis-name", "text-anchor": "middle" };
    marks.push(svg("text", { ...name, x: MARGIN.left + inner()[0] / 2, y: size.height - 4 }, letter(parameters[0])));
    if (!isPlane) return marks;
    for (const { value, text } of ticks(...spans[1], Math.max(2, inner()[1] / 60))) {
      const y = down(value);
      marks.push(svg("path", { class: "axis", d: `M${MARGIN.left} ${y}h-5` }));
      marks.push(svg("text", { class: "tick", x: MARGIN.left - 8, y: y + 4, "text-anchor": "end" }, text));
    }
    marks.push(svg("text", { ...name, x: 8, y: MARGIN.top + inner()[1] / 2 }, letter(parameters[1])));
    return marks;
  }

  const handle = svg(
    "g",
    { id: "handle", role: "slider", tabindex: 0, "aria-label": `Point ${parameters.join(", ")}` },
    svg("path", { class: "cross" }),
    svg("circle", { class: "reach", r: 22 }),
    svg("circle", { class: "ring", r: 10 }),
    svg("circle", { class: "knob", r: 6.5 }),
  );
  const still = svg("svg", { "aria-hidden": "true" });
  const moving = svg("svg", { class: "moving", role: "group", "aria-label": "Map of smoothness" }, handle);
  element.append(still, moving);

  function placeHandle() {
    if (!shown) return;
    const [x, y] = [across(shown[0]), isPlane ? down(shown[1]) : MARGIN.top + inner()[1] / 2];
    const cx = Math.min(Math.max(x, MARGIN.left), size.width - MARGIN.right);
    const cy = Math.min(Math.max(y, MARGIN.top), size.height - MARGIN.bottom);
    handle.classList.toggle("outside", cx !== x || cy !== y);
    for (const circle of handle.querySelectorAll("circle")) fill(circle, { cx, cy }, []);
    const { left, right, top, bottom } = MARGIN;
    const level = isPlane ? `M${left} ${cy}H${size.width - right}` : "";
    handle.firstChild.setAttribute("d", `${level}M${cx} ${top}V${size.height - bottom}`);
  }

  function draw(width) {
    const tall = isPlane ? Math.min(Math.max(width * 0.72, 260), 540) : 0;
    size = { width, height: isPlane ? tall : MARGIN.top + MARGIN.bottom + ROW * ranges.length };
    for (const layer of [still, moving]) {
      fill(layer, { width, height: size.height, viewBox: `0 0 ${width} ${size.height}` }, []);
    }
    still.replaceChildren(...(isPlane ? planeLayers() : lineLayers()), ...axes());
    element.style.height = `${size.height}px`;
    placeHandle();
  }

  const floatsAt = (event) => {
    const bounds = moving.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left - MARGIN.left, event.clientY - bounds.top - MARGIN.top];
    const fractions = [x / inner()[0], 1 - y / inner()[1]].map((f) => Math.min(Math.max(f, 0), 1));
    return spans.map(([low, high], k) => low + (high - low) * fractions[k]);
  };
  onDrag(moving, {
    // A finger scrolls the page unless it is on the handle; a tap is a click.
    accepts: (event) => event.pointerType === "mouse" || handle.contains(event.target),
    start: (event) => {
      event.preventDefault();
      handle.focus({ preventScroll: true });
      move(floatsAt(event));
    },
    move: (event) => move(floatsAt(event)),
  });
  moving.addEventListener("click", (event) => {
    if (event.pointerType === "touch") move(floatsAt(event));
  });
  handle.addEventListener("keydown", (event) => {
    const direction = arrowStep(event);
    const factor = { "+": 0.5, "-": 2 }[event.key];
    if (direction) step(direction);
    else if (factor) zoom(factor);
    else return;
    event.preventDefault();
  });

  drawToWidth(element, draw);
  return {
    /** The part of the box that is seen; null if that is all of it. */
    view: () => (spans === whole ? null : spans),
    widths: () => spans.map(([low, high]) => high - low),
    /** Shows another part, all of the box for null. */
    look(view) {
      const isGood = view?.every(([a, b], k) => {
        const width = whole[k][1] - whole[k][0];
        return a >= whole[k][0] && b <= whole[k][1] && b - a > DEEPEST * width && b - a < 0.99 * width;
      });
      spans = isGood ? view : whole;
      if (size.width > 0) draw(size.width);
    },
    /** The spans around the point that are so many times as wide, within the box. */
    around: (factor) =>
      spans.map(([low, high], k) => {
        const [least, most] = whole[k];
        const half = Math.max(Math.min(high - low, (most - least) / factor) * factor, DEEPEST * 2 * (most - least)) / 2;
        const middle = Math.min(Math.max(shown[k], least + half), most - half);
        return [middle - half, middle + half];
      }),
    /** Shows a point. */
    show(point) {
      shown = point.map(toFloat);
      const text = parameters.map((name, k) => `${name} = ${toText(point[k])}`).join(", ");
      fill(handle, { "aria-valuetext": text, "aria-valuenow": shown[0] }, []);
      fill(handle, { "aria-valuemin": spans[0][0], "aria-valuemax": spans[0][1] }, []);
      placeHandle();
    },
  };
}

/** The entries of the legend: class of the sample, text. */
function legendEntries() {
  const orders = smoothness.kind === "plane" ? maps : ranges;
  const entries = orders.flatMap((one, k) => {
    const list = one.sections?.flatMap((section) => section.intervals) ?? one.intervals ?? [];
    const onLine = list.some((interval) => interval.verdict === "proved");
    const onPieces = one.reasons?.some((reason) => reason.verdict === "proved");
    if (!onLine && !onPieces) return [];
    const where = smoothness.kind === "plane" && !onPieces ? ", only on a line or point" : "";
    return [[`shade-${shadeOf(k, orders.length)}`, `${order(one.continuity)} proved${where}`]];
  });
  entries.push(["undecided", "undecided"], ["refuted", "refuted"]);
  const hasPoles = ranges.some((range) => range.intervals.some(({ verdict }) => verdict === "undefined"));
  if (hasPoles) entries.push(["pole", "a pole: no mask"]);
  if (smoothness.kind === "plane" && strata.some((s) => s.vanishes)) entries.push(["stratum", "a degree rises"]);
  return entries;
}
