// ---- refine.js: refinement in floats, for drawing only.

/** The rule of a member in floats, and where new points stand: the new point i at (i - shift)/m. */
function floatRule(member) {
  const moment = member.mask.reduce((sum, a, k) => sum + (member.first + k) * toFloat(a), 0);
  return {
    stencils: stencils(member).map(({ first, weights }) => ({ first, weights: weights.map(toFloat) })),
    shift: moment / arity,
    keeps: keepsPoints(member),
  };
}

/** i reflected at 0 and at end, until it lies between them. */
function folded(i, end) {
  if (end <= 0) return 0;
  const k = modulo(i, 2 * end);
  return k > end ? 2 * end - k : k;
}

/** The control point of any index: periodic, or reflected at the ends, f_{-j} = 2 f_0 - f_j. */
function controlPoint(points, closed, i) {
  const n = points.length;
  if (closed) return points[modulo(i, n)];
  if (i >= 0 && i < n) return points[i];
  if (n === 1) return points[0];
  const [end, mirrored] = i < 0 ? [points[0], -i] : [points[n - 1], 2 * (n - 1) - i];
  const [x, y] = controlPoint(points, false, mirrored);
  return [2 * end[0] - x, 2 * end[1] - y];
}

/** Which member a vertex and the edge after it take, beyond the ends mirrored like the points. */
function controlTag(tags, closed, i) {
  const n = tags.length;
  if (closed) return { vertex: tags[modulo(i, n)], edge: tags[modulo(i, n)] };
  // Twice the middle of an edge is odd, and mirrored like twice a point.
  const edge = (folded(2 * i + 1, 2 * (n - 1)) - 1) / 2;
  return { vertex: tags[folded(i, n - 1)], edge: tags[Math.min(Math.max(edge, 0), n - 1)] };
}

const hull = (rules, e) => ({
  first: Math.min(...rules.map(({ stencils }) => stencils[e].first)),
  end: Math.max(...rules.map(({ stencils }) => stencils[e].first + stencils[e].weights.length)),
});

/** The old points of which the new ones of a range are made. */
function needed(rules, [from, to]) {
  const range = [Infinity, -Infinity];
  for (let e = 0; e < arity; e++) {
    const { first, end } = hull(rules, e);
    // The first and the last new point of the class e.
    const low = Math.ceil((from - e) / arity);
    const high = Math.floor((to - 1 - e) / arity);
    if (low > high) continue;
    range[0] = Math.min(range[0], low + first);
    range[1] = Math.max(range[1], high + end);
  }
  return range;
}

/** The points of the last level: one period of a closed polygon, or those between the ends. */
function lastRange({ shift }, count, closed, levels) {
  if (closed) return [0, count * arity ** levels];
  let ends = [0, count - 1];
  for (let k = 0; k < levels; k++) ends = ends.map((t) => t * arity + shift);
  // Room for the rounding of what is exactly at an end.
  return [Math.ceil(ends[0] - 1e-6), Math.floor(ends[1] + 1e-6) + 1];
}

/** The refined polygon. `tags[i]` chooses the rule of vertex i and of the edge after it: 0 approximates, 1
    interpolates. A vertex that its rule keeps, and the edge after it, keep their rule on the next
    level; all others take rule 0. */
function refine(points, tags, rules, closed, levels) {
  let range = lastRange(rules[0], points.length, closed, levels);
  const wanted = [range];
  for (let k = 0; k < levels; k++) wanted.unshift((range = needed(rules, range)));
  const start = wanted.shift();
  const indices = Array.from({ length: start[1] - start[0] }, (_, k) => start[0] + k);
  let old = {
    first: start[0],
    points: indices.map((i) => controlPoint(points, closed, i)),
    tags: indices.map((i) => controlTag(tags, closed, i)),
  };
  for (const [from, to] of wanted) {
    const fresh = { first: from, points: [], tags: [] };
    for (let i = from; i < to; i++) {
      const e = modulo(i, arity);
      const parent = (i - e) / arity;
      const tag = old.tags[parent - old.first];
      const rule = rules[e === 0 ? tag.vertex : tag.edge];
      const { first, weights } = rule.stencils[e];
      const point = [0, 0];
      weights.forEach((w, k) => {
        const [x, y] = old.points[parent + first + k - old.first];
        point[0] += w * x;
        point[1] += w * y;
      });
      fresh.points.push(point);
      fresh.tags.push(e === 0 && rule.keeps ? tag : { vertex: 0, edge: 0 });
    }
    old = fresh;
  }
  return old.points;
}

/** At each point the tip of a tooth along the normal, as long as the curvature, the longest of a given
    length: curvature from central differences, which tend to derivatives where the limit is C². */
function combTips(points, closed, longest) {
  const n = points.length;
  const at = (i) => points[modulo(i, n)];
  const teeth = points.map((_, k) => {
    const i = closed ? k : Math.min(Math.max(k, 1), n - 2);
    const [p, q, r] = [at(i - 1), at(i), at(i + 1)];
    const d = [(r[0] - p[0]) / 2, (r[1] - p[1]) / 2];
    const dd = [r[0] - 2 * q[0] + p[0], r[1] - 2 * q[1] + p[1]];
    const speed = d[0] ** 2 + d[1] ** 2;
    const scale = (d[0] * dd[1] - d[1] * dd[0]) / speed ** 2;
    return Number.isFinite(scale) ? [d[1] * scale, -d[0] * scale] : [0, 0];
  });
  const most = Math.max(...teeth.map(([x, y]) => Math.hypot(x, y)));
  const factor = most > 0 ? longest / most : 0;
  return points.map(([x, y], k) => [x + factor * teeth[k][0], y + factor * teeth[k][1]]);
}
