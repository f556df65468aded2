// ---- curve.js: the control polygon, which can be edited, and its limit curve.

/** Control points stand at multiples of 1/100, so that the commands say exactly what is seen. */
const rounded = (x) => Math.round(x * 100) / 100;

/** The distance of a point from a segment. */
function distanceTo([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / square, 0), 1) : 0;
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

/** The edge of a polygon next to a point, by the number of its first vertex. */
function nearestEdge(points, closed, place) {
  const count = closed ? points.length : points.length - 1;
  const distances = Array.from({ length: count }, (_, i) =>
    distanceTo(place, points[i], points[(i + 1) % points.length]),
  );
  return Math.max(distances.indexOf(Math.min(...distances)), 0);
}

const fixedPlace = ([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`;
/** Further away, in pixels, pictures have no place. */
const FARTHEST = 1e7;
/** A path, or none where a point is too far away. */
const pathThrough = (places, closed) =>
  places.length > 0 && places.flat().every((x) => Math.abs(x) < FARTHEST)
    ? `M${places.map(fixedPlace).join("L")}${closed ? "Z" : ""}`
    : "";

/** The canvas in an element. `edit` has the functions `move(i, place)`, `insert(after, place)`, `remove(i)`,
    `select(i)` and `toggle(i)`. */
function createCanvas(element, edit) {
  const teeth = svg("path", { class: "teeth" });
  const tips = svg("path", { class: "tips" });
  const control = svg("path", { class: "control" });
  const limit = svg("path", { class: "limit" });
  const vertices = svg("g");
  const sheet = svg("svg", { class: "sheet", role: "group", "aria-label": "Control polygon and limit curve" });
  sheet.append(teeth, tips, control, limit, vertices);
  element.append(sheet);
  let size = { width: 0, height: 0 };
  let frame = null;
  let shown = null;
  let isDragging = false;

  const scale = () => Math.min(size.width / frame.width, size.height / frame.height);
  const toScreen = ([x, y]) => [
    size.width / 2 + (x - frame.x) * scale(),
    size.height / 2 - (y - frame.y) * scale(),
  ];
  const fromScreen = (event) => {
    const bounds = sheet.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left, event.clientY - bounds.top];
    return [frame.x + (x - size.width / 2) / scale(), frame.y - (y - size.height / 2) / scale()].map(rounded);
  };

  /** A frame around the control points, kept as long as it fits them. */
  function fit(points) {
    const [xs, ys] = [0, 1].map((k) => points.map((p) => p[k]));
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const extent = Math.max(right - left, high - low, 0.5);
    const isWithin = frame && points.every(toVisible);
    if (isWithin && extent > Math.max(frame.width, frame.height) / 3) return;
    const margin = 0.14 * extent;
    frame = {
      x: (left + right) / 2,
      y: (low + high) / 2,
      width: Math.max(right - left, 0.1 * extent) + 2 * margin,
      height: Math.max(high - low, 0.1 * extent) + 2 * margin,
    };
  }
  function toVisible(point) {
    const [x, y] = toScreen(point);
    return x >= 8 && y >= 8 && x <= size.width - 8 && y <= size.height - 8;
  }

  function vertex(i) {
    const mark = svg("g", {
      class: "vertex", tabindex: 0, role: "button",
      focus: () => edit.select(i),
      keydown: (event) => {
        const direction = arrowStep(event);
        const point = shown.points[i];
        const unit = Math.max(0.01, rounded(frame.width / 100));
        if (direction) edit.move(i, point.map((x, k) => rounded(x + unit * direction[k])));
        else if (event.key === "Delete" || event.key === "Backspace") edit.remove(i);
        else if (event.key === "i" || event.key === "Enter" || event.key === " ") edit.toggle(i);
        else return;
        event.preventDefault();
      },
    });
    mark.append(svg("circle", { class: "reach", r: 18 }), svg("circle", { class: "ring", r: 11 }));
    mark.append(svg("circle", { class: "dot", r: 5.5 }), svg("rect", { class: "square", width: 11, height: 11 }));
    onDrag(mark, {
      start: (event) => {
        event.preventDefault();
        event.stopPropagation();
        mark.focus({ preventScroll: true });
        isDragging = true;
      },
      move: (event) => edit.move(i, fromScreen(event)),
      end: () => {
        isDragging = false;
        draw();
      },
    });
    return mark;
  }

  function draw() {
    if (!shown || size.width === 0) return;
    const { points, tags, closed, curve, comb, selected } = shown;
    if (!isDragging) fit(points);
    const places = points.map(toScreen);
    control.setAttribute("d", pathThrough(places, closed));
    const onScreen = curve.map(toScreen);
    limit.setAttribute("d", pathThrough(onScreen, closed));
    const ends = (comb?.tips ?? []).map(toScreen);
    const bases = (comb?.bases ?? []).map(toScreen);
    tips.setAttribute("d", pathThrough(ends, closed));
    teeth.setAttribute("d", ends.map((tip, k) => pathThrough([bases[k], tip], false)).join(""));
    // Elements stay as long as they can: the focus is on one of them.
    while (vertices.childElementCount > points.length) vertices.lastChild.remove();
    while (vertices.childElementCount < points.length) vertices.append(vertex(vertices.childElementCount));
    [...vertices.children].forEach((mark, i) => {
      const [x, y] = places[i];
      for (const circle of mark.querySelectorAll("circle")) fill(circle, { cx: x, cy: y }, []);
      fill(mark.querySelector("rect"), { x: x - 5.5, y: y - 5.5 }, []);
      mark.classList.toggle("interpolated", tags[i] === 1);
      mark.classList.toggle("selected", i === selected);
      const kind = tags[i] === 1 ? ", interpolated" : "";
      mark.setAttribute("aria-label", `Vertex ${i} at ${points[i].join(", ")}${kind}`);
    });
  }

  sheet.addEventListener("dblclick", (event) => {
    if (event.target.closest(".vertex")) return;
    const place = fromScreen(event);
    edit.insert(nearestEdge(shown.points, shown.closed, place), place);
  });

  drawToWidth(element, (width) => {
    size = { width, height: Math.min(Math.max(width * 0.72, 260), 520) };
    fill(sheet, { ...size, viewBox: `0 0 ${size.width} ${size.height}` }, []);
    draw();
  });
  return {
    /** Shows a polygon with its curve. */
    show(next) {
      shown = next;
      draw();
    },
    /** Puts the focus on a vertex. */
    focus: (i) => vertices.children[i]?.focus({ preventScroll: true }),
    /** How long the longest tooth of a comb is. */
    toothLength: (points) => {
      const spans = [0, 1].map((k) => points.map((p) => p[k]));
      return Math.max(...spans.map((s) => Math.max(...s) - Math.min(...s))) / 5;
    },
  };
}
