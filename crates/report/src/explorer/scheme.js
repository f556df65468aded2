// ---- scheme.js: the member of the family at a point: mask, rules, type, degrees.

const data = JSON.parse(document.getElementById("data").textContent);
const parameters = data.parameters;
const arity = data.arity;

const family = {
  first: data.mask.first,
  coefficients: data.mask.coefficients.map(readTerms),
  denominator: readTerms(data.mask.denominator),
};

/** The mask at a point, exactly; null at a pole. Zeros at its ends are left out. */
function memberAt(point) {
  const denominator = evaluate(family.denominator, point);
  if (isZero(denominator)) return null;
  const all = family.coefficients.map((c) => over(evaluate(c, point), denominator));
  const from = all.findIndex((a) => !isZero(a));
  const to = all.findLastIndex((a) => !isZero(a)) + 1;
  return { first: family.first + from, mask: all.slice(from, to) };
}

const coefficient = (member, i) => member.mask[i - member.first] ?? ZERO;
const last = (member) => member.first + member.mask.length - 1;
const modulo = (i, m) => ((i % m) + m) % m;

/** f'_{mi+e} = Σ_k weights[k] f_{i+first+k}, for each e. */
function stencils(member) {
  return Array.from({ length: arity }, (_, e) => {
    // a_{e-mk} is the weight of f_{i+k}.
    const from = Math.ceil((e - last(member)) / arity);
    const to = Math.floor((e - member.first) / arity);
    const weights = Array.from({ length: Math.max(0, to - from + 1) }, (_, k) =>
      coefficient(member, e - arity * (from + k)),
    );
    return { first: from, weights };
  });
}

/** Whether the rule of class 0 keeps the old points. */
function keepsPoints(member) {
  const indices = member.mask.map((_, k) => member.first + k).filter((i) => modulo(i, arity) === 0);
  return [0, ...indices].every((i) => equal(coefficient(member, i), i === 0 ? ONE : ZERO));
}

/** The adjectives of the member. */
function typeOf(member) {
  const symmetric = (sum) =>
    member.mask.every((a, k) => equal(a, coefficient(member, sum - (member.first + k))));
  const words = [];
  if (symmetric(0)) words.push("primal");
  if (symmetric(-1)) words.push("dual");
  words.push(keepsPoints(member) ? "interpolatory" : "approximating");
  return words;
}

const strata = data.degrees.strata.map((stratum) => ({
  ...stratum,
  vanishes: stratum.vanishes && readTerms(stratum.vanishes),
  point: stratum.point && stratum.point.map(parseRational),
}));

function holdsPoint(stratum, point) {
  if (stratum.vanishes) return isZero(evaluate(stratum.vanishes, point));
  if (stratum.point) return stratum.point.every((x, k) => equal(x, point[k]));
  // A point with an irrational coordinate is never met; the generic stratum is everywhere.
  return stratum.point === undefined;
}

/** Degrees only rise on smaller strata, so that of all strata through the point the highest tells. */
function degreesAt(point) {
  const here = strata.filter((stratum) => holdsPoint(stratum, point));
  return here.reduce((best, stratum) => {
    const rises = stratum.generation - best.generation || stratum.reproduction - best.reproduction;
    return rises > 0 ? stratum : best;
  });
}
