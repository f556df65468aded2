// ---- region.js: what the certificates say at a point. Pieces are closed; a point on a cut is in both.

/** The list of cuts as a tree: a line with what is below and above, or the number of a reason. */
function readTree(walk) {
  let next = 0;
  const root = {};
  const open = [[root, "only"]];
  while (open.length > 0) {
    const [parent, side] = open.pop();
    const entry = walk[next++];
    if (typeof entry === "number") {
      parent[side] = entry;
    } else {
      const node = { line: entry.split(" ").map(BigInt) };
      parent[side] = node;
      open.push([node, "above"], [node, "below"]);
    }
  }
  return root.only;
}

const smoothness = data.smoothness;

const maps = (smoothness.maps ?? []).map((map) => ({
  ...map,
  parts: map.parts.map((part) => part.map((corner) => corner.map(parseRational))),
  trees: map.trees.map(readTree),
  divisible: map.divisible?.map(readTerms),
  sections: (map.sections ?? []).map((section) => ({
    ...section,
    origin: section.origin.map(parseRational),
    direction: section.direction.map(parseRational),
    intervals: section.intervals.map(readInterval),
  })),
}));

/** Members of which more is known than of their surroundings. */
const members = data.members.map((member) => ({ ...member, point: member.point.map(parseRational) }));
const knownMember = (parameters) =>
  members.find(({ point }) => point.every((x, k) => equal(x, parameters[k])));

const ranges = (smoothness.ranges ?? []).map((range) => ({
  ...range,
  intervals: range.intervals.map(readInterval),
}));

const factor = smoothness.factor?.map(parseRational);
const difference = smoothness.difference?.map(readTerms);

/** The point (x, y) of the parameters, in which the pieces are polygons: x = u, y = v l(u). */
function toPlane([u, v]) {
  return [u, factor ? times(v, plus(factor[0], times(factor[1], u))) : v];
}

/** Whether a convex polygon, its corners counterclockwise, has the point to the left of all edges. */
function isInPolygon(corners, [x, y]) {
  return corners.every(([ax, ay], i) => {
    const [bx, by] = corners[(i + 1) % corners.length];
    const left = times(minus(bx, ax), minus(y, ay));
    return compare(left, times(minus(by, ay), minus(x, ax))) >= 0;
  });
}

/** The sign of a x + b y - c. */
function sideOfLine([a, b, c], [x, y]) {
  return signOf(a * x.n * y.d + b * y.n * x.d - c * x.d * y.d);
}

/** The numbers of the reasons of all pieces that hold a point of the plane. */
function reasonsAt(map, point) {
  const open = map.trees.filter((_, k) => isInPolygon(map.parts[k], point));
  const found = new Set();
  while (open.length > 0) {
    const node = open.pop();
    if (typeof node === "number") {
      found.add(node);
      continue;
    }
    const side = sideOfLine(node.line, point);
    if (side <= 0) open.push(node.below);
    if (side >= 0) open.push(node.above);
  }
  return [...found].map((k) => map.reasons[k]);
}

/** The coefficients of a polynomial without its zeros at 1. */
function withoutOnes(values) {
  const sums = [];
  let sum = 0n;
  for (const value of values) sums.push((sum += value));
  return values.length > 1 && sum === 0n ? withoutOnes(sums.slice(0, -1)) : values;
}

/** Whether the shifts are shown to be stable at a point: the halves of the difference symbol c have no common zero,
    and c(-z) but at z = 1 none with the polynomial of its squared zeros; for other arities two contrasts of neighbouring
    submasks have none but 1. */
function hasStableShifts(point) {
  const values = cleared(difference.map((c) => evaluate(c, point))).tops;
  const trimmed = (indices, sign) => {
    const occurs = (i) => sign(i) !== 0n && difference[i].length > 0;
    const inner = indices.slice(indices.findIndex(occurs), indices.findLastIndex(occurs) + 1);
    return inner.map((i) => sign(i) * values[i]);
  };
  const indices = values.map((_, i) => i);
  const contrast = (j) =>
    withoutOnes(trimmed(indices, (i) => BigInt(i % arity === j) - BigInt(i % arity === j + 1)));
  if (arity > 2) {
    const all = Array.from({ length: arity - 1 }, (_, j) => contrast(j));
    const [first, second] = all.filter((c) => c.length > 0);
    return second !== undefined && areCoprime(first, second);
  }
  const half = (k) => trimmed(indices.filter((i) => i % 2 === k), () => 1n);
  return areCoprime(half(0), half(1)) && areCoprime(contrast(0), ofSquares(contrast(0)));
}

/** The parameters of a point (x, y); null where the factor vanishes. */
function fromPlane([x, y]) {
  const l = factor ? plus(factor[0], times(factor[1], x)) : ONE;
  return isZero(l) ? null : [x, over(y, l)];
}

/** Whether the mask at two points of the plane is the same. */
function haveSameMask(a, b) {
  const places = [a, b].map(fromPlane);
  if (places.includes(null)) return a.every((x, k) => equal(x, b[k]));
  const [one, other] = places.map(memberAt);
  return one.first === other.first && one.mask.length === other.mask.length
    && one.mask.every((c, i) => equal(c, other.mask[i]));
}

/** The value of t at which the line of a section passes through a point; null if it does not. A section at a
    point is about its mask. */
function parameterOnSection({ origin, direction }, point) {
  const moving = direction.findIndex((d) => !isZero(d));
  if (moving < 0) return haveSameMask(origin, point) ? ZERO : null;
  const t = over(minus(point[moving], origin[moving]), direction[moving]);
  const there = point.every((x, k) => equal(x, plus(origin[k], times(direction[k], t))));
  return there ? t : null;
}

/** The power of 1 + z that C^n needs, or of its counterpart for another arity. */
const neededPower = (n) => {
  const rest = { 2: "", 3: " + z²" }[arity] ?? ` + … + z${raised(arity - 1)}`;
  return `(1 + z${rest})${raised(n + 1)}`;
};

/** The coordinates of the plane in which the pieces are polygons, in the parameters: `(α, β (1 - α))`. */
const coordinates = smoothness.coordinates?.replaceAll(/[A-Za-z_]\w*/g, letter).replaceAll("*", " ");

function sectionText(n, { origin, direction }, interval) {
  const [start, way] = [origin, direction].map((p) => `(${p.map(toText).join(", ")})`);
  const divides = `where ${neededPower(n)} divides the symbol`;
  if (direction.every(isZero)) return `the mask is that at ${coordinates} = ${start}, ${divides}`;
  const part = interval ? `, t in ${interval.text}` : "";
  return `on the line ${divides}, ${coordinates} = ${start} + t ${way}${part}`;
}

/** What is proved on the lines beyond the order. */
function verdictOnSections(map, point) {
  for (const section of map.sections) {
    const t = parameterOnSection(section, point);
    if (t === null) continue;
    const interval = section.intervals.find((interval) => isInside(t, interval));
    const verdict = interval?.verdict ?? "undecided";
    return { verdict, because: sectionText(map.continuity, section, interval) };
  }
  return { verdict: "undecided", because: `${neededPower(map.continuity)} divides the symbol here; nothing is proved` };
}

const REASONS = {
  norm: () => "in a piece where a norm is below 1",
  division: (n) => `in a piece where ${neededPower(n)} does not divide the symbol`,
  "": () => "in a piece for which no proof was found",
};
const reasonText = (n, because) => REASONS[because]?.(n) ?? `in a piece decided by ${because}`;

function verdictOnMap(map, point, isStable) {
  const reasons = reasonsAt(map, point);
  const proved = reasons.find((reason) => reason.verdict === "proved");
  if (proved) return { verdict: "proved", because: reasonText(map.continuity, proved.because) };
  if (map.divisible?.every((c) => isZero(evaluate(c, point)))) return verdictOnSections(map, point);
  const refuting = reasons.filter((reason) => reason.verdict === "refuted");
  const refuted = refuting.find((reason) => !reason.if_stable || isStable());
  if (refuted) {
    const stable = refuted.if_stable ? "; the shifts are stable here" : "";
    return { verdict: "refuted", because: reasonText(map.continuity, refuted.because) + stable };
  }
  if (refuting.length > 0) {
    return { verdict: "undecided", because: "refuted around here, but the shifts may be unstable" };
  }
  const because = reasons.length > 0 ? reasonText(map.continuity, "") : "outside of the box that was mapped";
  return { verdict: "undecided", because };
}

function verdictOnLine(range, x) {
  const interval = range.intervals.find((interval) => isInside(x, interval));
  if (!interval) return { verdict: "undecided", because: "" };
  const because = range.because[interval.verdict];
  return { verdict: interval.verdict, because: interval.text + (because ? `; ${because}` : "") };
}

/** What to do where a point is left open. */
const ASK = "the command for the Hölder exponent, below, looks at this member alone";
const alone = (because) => ["this member alone", because].filter((text) => text !== "").join(": ");

/** The verdicts with those on the member alone where they leave something undecided, or end. */
function withMember(verdicts, parameters) {
  const known = knownMember(parameters)?.verdicts ?? [];
  const both = Array.from({ length: Math.max(verdicts.length, known.length) }, (_, n) => {
    const isOpen = !verdicts[n] || verdicts[n].verdict === "undecided";
    return isOpen && known[n] ? { ...known[n], isAlone: true, because: alone(known[n].because) } : verdicts[n];
  });
  const rough = known.find(({ verdict }) => verdict === "refuted");
  return both.map((found) => {
    if (found.verdict !== "undecided") return found;
    if (rough && found.continuity > rough.continuity) {
      return { ...found, verdict: "refuted", because: `${order(rough.continuity)} is refuted` };
    }
    return { ...found, because: [found.because, ASK].filter((text) => text !== "").join("; ") };
  });
}

/** For each order, ascending, the verdict at the parameters and its reason. */
function verdictsAt(parameters) {
  if (smoothness.kind === "scheme") return smoothness.verdicts;
  if (smoothness.kind === "line") {
    const found = ranges.map((range) => ({
      continuity: range.continuity,
      ...verdictOnLine(range, parameters[0]),
    }));
    return withMember(found, parameters);
  }
  if (isZero(evaluate(family.denominator, parameters))) {
    const because = "the denominator of the mask vanishes here";
    return maps.map(({ continuity }) => ({ continuity, verdict: "undefined", because }));
  }
  return withMember(verdictsOnPlane(parameters), parameters);
}

function verdictsOnPlane(parameters) {
  const point = toPlane(parameters);
  let stable;
  const isStable = () => (stable ??= hasStableShifts(parameters));
  // What is not C^n is not smoother.
  let rough;
  return maps.map((map) => {
    const { continuity } = map;
    const found = verdictOnMap(map, point, isStable);
    if (found.verdict === "refuted") rough ??= continuity;
    const known = found.verdict === "undecided" && rough !== undefined;
    return known
      ? { continuity, verdict: "refuted", because: `${order(rough)} is refuted` }
      : { continuity, ...found };
  });
}
