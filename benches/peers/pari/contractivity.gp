\\ contractivity.gp: exact contractivity ranges of one-parameter subdivision schemes, in PARI/GP (written for 2.15).
\\
\\   echo 'contractivity("a4", 0, 6)' | gp -fq -s 256M benches/peers/contractivity.gp
\\
\\ prints, as one JSON object, for each level l = 1..L the exact set of parameters with ||c_n^l|| < 1, and under
\\ "proved" the union of these sets. Here
\\
\\   c_n(z) = 2^n a(z)/(1+z)^(n+1),  c_n^l(z) = prod_{k<l} c_n(z^(2^k)),  ||c_n^l|| = max_j sum_i |c_(j-2^l i)|,
\\
\\ and a is one of these symbols, affine in its parameter (D = z^-2 - 2 + z^2, e_N the Deslauriers-Dubuc edge rule):
\\
\\   a2, a4, ...  = a_{2N+2}:  1 - alpha (-D)^(N+1) + e_N
\\   i4, i6, ...  = i_{2N+4}:  1 + e_N + beta D^(N+1) (z^-1 + z)
\\   a3, a5, ...  = a_{2N+3}:  1 - alpha (-D)^(N+1) + e_N + b D^(N+1) (z^-1 + z), on the line b = b(alpha) on which the
\\                  generation degree rises to 2N+3 (b stands for beta (1-alpha)).
\\
\\ Method. Denominators are cleared once: T c^l has coefficients in Z[t]. A residue class mod 2^l, a "row", asks
\\ R(t) = sum |p_i(t)| < T; mirrored rows are equal and taken once. The end coefficient of c^l is c_0^l, so only the
\\ interval |c_0(t)| <= 1 matters. It is bisected; every node carries the rows not yet settled on it, their polynomials
\\ in the Bernstein basis of the node, in integers. With W = sum |b_i|, column by column, and S = sum s_i b_i, s_i the
\\ dominant sign of p_i:
\\   max W <= T (not all equal)   the row is < T inside the node, and is dropped;
\\   min S >= T                   the row is >= T, and the node is infeasible;
\\   S = W                        every p_i has constant sign there, so R is the polynomial S; if S - T has one sign
\\                                variation it has one root in the node (Descartes), which is an end of the range.
\\ What bisection cannot settle (an end at a kink of R, two rows with the same end, R touching T) goes to `exactnode`,
\\ the textbook algorithm: the roots of all p_i cut the node, and R is a polynomial on each piece, with isolated roots.
\\ Every decision is exact: integers and rationals, factor, and polrootsreal on exact input, whose floating-point
\\ output is only taken as an enclosure once an exact sign change confirms it.
\\
\\ A point is [P, lo, hi]: the only root in [lo, hi] of P, irreducible in Z[t], leading coefficient positive; lo == hi if
\\ it is rational. Two points are equal iff their P are and P changes sign on the common part of their intervals.

\\ ---- the symbols -------------------------------------------------------------------------------------------------

\\ [u, v, parameter]: a = u + t v up to a power of z, u and v polynomials in z.
scheme(name) =
{
  my(kind = Vec(name)[1], m = eval(concat(Vec(name)[2..-1])), N, D, E, v, w, K);
  if (kind == "i" && m >= 4 && m % 2 == 0, N = m/2 - 2,
      kind == "a" && m >= 2, N = if (m % 2, (m - 3)/2, m/2 - 1),
      error("no such scheme"));
  D = (z^2 - 1)^2;                                                                            \\ z^2 D
  E = z^(2*N+1) + sum(k = 0, N, binomial(2*k, k)/16^k * (-D)^k * z^(2*(N-k)) * (1 + z^2)/2);  \\ z^(2N+1) (1 + e_N)
  v = -(-D)^(N+1); w = D^(N+1) * (1 + z^2);                     \\ z^(2N+2), z^(2N+3) times the two displacements
  if (kind == "i", return([z^2*E, w, "beta"]));
  if (m % 2 == 0, return([z*E, v, "alpha"]));
  \\ all three parts have (1+z)^(2N+2); b(alpha) makes the sum of their next Taylor coefficients at -1 vanish
  K = apply(p -> subst(p / (1+z)^(2*N+2), z, -1), [z^2*E, z*v, w]);
  [z^2*E - K[1]/K[3]*w, z*v - K[2]/K[3]*w, "alpha"];
}

\\ [u, v, T, parameter]: T c_n = u + t v up to a power of z, u and v in Z[z].
difference(name, n) =
{
  my([u, v, par] = scheme(name), q = (1+z)^(n+1), k = valuation(gcd(u, v), z), T);
  if (u % q || v % q, error(Str(name, " is not divisible by (1+z)^", n+1, " for every ", par)));
  u = 2^n * u / q / z^k; v = 2^n * v / q / z^k;
  T = lcm(denominator(content(u)), denominator(content(v)));
  [T*u, T*v, T, par];
}

\\ ---- points ------------------------------------------------------------------------------------------------------

rational(x) = [denominator(x)*'t - numerator(x), x, x];
changes(P, a, b) = sign(subst(P, 't, a)) * sign(subst(P, 't, b)) < 0;

\\ The real roots of p in the closed interval [a, b].
roots(p, a, b) =
{
  my(X = List(), x, l, h);
  if (p == 0, return([]));
  localbitprec(192);
  foreach (factor(p)[, 1]~, P,
    P /= content(P) * sign(pollead(P));
    if (poldegree(P) == 1,
      x = -polcoef(P, 0)/polcoef(P, 1); if (a <= x && x <= b, listput(X, rational(x)));
      next);
    foreach (polrootsreal(P, [a, b]), x,
      l = max(a, (floor(x << 100) - 1)/2^100); h = min(b, (floor(x << 100) + 2)/2^100);
      if (!changes(P, l, h) || (#X && X[#X][1] == P && X[#X][3] >= l), error("roots not separated"));
      listput(X, [P, l, h])));
  Vec(X);
}

\\ Shrink the interval of a point to a quarter.
refine(X) =
{
  my([P, a, b] = X, m);
  for (i = 1, 2, if (a < b, m = (a + b)/2; if (changes(P, a, m), b = m, a = m)));
  [P, a, b];
}

\\ [sign of X - Y, X, Y], the intervals refined to be disjoint, or X = Y.
compare(X, Y) =
{
  my(l = max(X[2], Y[2]), h = min(X[3], Y[3]));
  if (l <= h && X[1] == Y[1] && (l == h || changes(X[1], l, h)), return([0, X, X]));
  while (X[3] >= Y[2] && Y[3] >= X[2], X = refine(X); Y = refine(Y));
  [if (X[3] < Y[2], -1, 1), X, Y];
}
below(X, Y) = compare(X, Y)[1] < 0;

\\ The distinct points of a list in order, their intervals disjoint.
distinct(L) =
{
  my(Y = List(), c, k);
  foreach (L, x,
    k = 1; c = [-1];
    while (k <= #Y && (c = compare(Y[k], x))[1] < 0, Y[k] = c[2]; x = c[3]; k++);
    if (k > #Y, listput(Y, x), Y[k] = c[2]; if (c[1], listinsert(Y, c[3], k))));
  Vec(Y);
}

\\ ---- sets: lists of open intervals [X, Y] of points ----------------------------------------------------------------

union(F) =
{
  my(U = List(), c);
  F = vecsort(F, (x, y) -> if (c = compare(x[1], y[1])[1], c, compare(x[2], y[2])[1]));
  foreach (F, I,
    if (!#U || !below(I[1], U[#U][2]), listput(U, I),
        below(U[#U][2], I[2]), U[#U] = [U[#U][1], I[2]]));
  Vec(U);
}

intersection(F, G) =
{
  my(U = List(), a, b);
  foreach (F, I, foreach (G, J,
    a = if (below(I[1], J[1]), J[1], I[1]); b = if (below(I[2], J[2]), I[2], J[2]);
    if (below(a, b), listput(U, [a, b]))));
  Vec(U);
}

\\ ---- the textbook algorithm, for what bisection leaves --------------------------------------------------------------

\\ Where, in the open interval (a, b), sum |p_i| < T; p a vector of polynomials in t.
exactrow(p, T, a, b) =
{
  my(ends = [rational(a), rational(b)], between, signed, X, S, Z, F = List());
  between = ((X, k) -> (X[k][3] + X[k+1][2])/2);
  signed = (m -> sum(i = 1, #p, sign(subst(p[i], 't, m)) * p[i]) - T);          \\ R - T on the piece around m
  X = distinct(concat([ends, concat([roots(q, a, b) | q <- p])]));
  S = [signed(between(X, k)) | k <- [1..#X-1]];
  Z = distinct(concat([X, concat([roots(s, a, b) | s <- S])]));                 \\ R - T keeps its sign between these
  for (k = 1, #Z - 1,
    my(m = between(Z, k), s = signed(m));
    if (subst(s, 't, m) >= 0, next);
    \\ join to the interval before, unless R = T at the point between them
    if (#F && F[#F][2] == Z[k] && s % Z[k][1] != 0, F[#F] = [F[#F][1], Z[k+1]], listput(F, [Z[k], Z[k+1]])));
  Vec(F);
}

\\ The same for several rows; rowpolys(id) are the polynomials of a row, and scale is their T.
exactnode(rows, a, b) =
{
  my(F = [[rational(a), rational(b)]]);
  foreach (rows, r, F = intersection(F, exactrow(rowpolys(r[1]), scale, a, b)));
  F;
}

\\ ---- bisection in the Bernstein basis ------------------------------------------------------------------------------

\\ Where, in the open interval (a, b), every row is < T. rows: list of [row id, matrix], whose product with `half` holds
\\ the Bernstein coefficients on (a, b), scaled by T; rows most likely to exclude the node first. depth: bisections left.
node(rows, half, T, a, b, depth) =
{
  my(act = List(), B, W, S, m, F, G);
  foreach (rows, r,
    B = r[2] * half; W = vector(matsize(B)[1], i, 1) * abs(B);
    if (vecmax(W) < T, next);
    S = apply(sign, B * onecol)~ * B;
    if (vecmin(S) >= T, return([]));
    if (vecmax(W) == T && vecmin(W) < T, next);
    listput(act, [r[1], B, S, S == W, -vecmin(S)]));
  if (#act == 0, return([[rational(a), rational(b)]]));
  if (#act == 1 && act[1][4],
    S = apply(x -> x - T, act[1][3]); B = select(x -> x, apply(sign, S));
    if (sum(k = 2, #B, B[k] != B[k-1]) == 1,
      \\ one root strictly inside: back from Bernstein coefficients to powers of t
      S = sum(k = 0, deg, binomial(deg, k) * S[k+1] * ('t - a)^k * (b - 't)^(deg - k));
      m = select(x -> x[3] > a && x[2] < b, roots(S, a, b))[1];
      return([if (B[1] < 0, [rational(a), m], [m, rational(b)])])));
  if (depth == 0, return(exactnode(act, a, b)));
  if (#act > 1, act = vecsort(act, 5));
  m = (a + b)/2; T <<= deg;
  F = node(act, left, T, a, m, depth - 1);
  G = node(act, right, T, m, b, depth - 1);
  \\ join across m if all rows are < T there
  if (#F && #G && F[#F][2] == G[1][1] && !#[0 | r <- act, vecsum(abs(r[2] * right[, 1])) >= T],
    G[1][1] = F[#F][1]; F = F[1..#F-1]);
  concat(F, G);
}

\\ ---- levels --------------------------------------------------------------------------------------------------------

bisections = 40;    \\ at most so many before `exactnode`; 0 runs the textbook algorithm alone (same result, slower)

\\ The set with ||c^l|| < 1. C: coefficients of t^0, t^1, ... in T^l c^l, polynomials in z; (a, b) where to look.
level(C, T, l, a, b) =
{
  my(M = vecmax(apply(poldegree, C)), q = 2^l, A, J, conv, den, row);
  A = matrix(M + 1, l + 1, i, k, polcoef(C[k], i - 1));
  J = [j | j <- [0..min(q - 1, M)], j <= (M - j) % q];                        \\ one row of each mirrored pair
  deg = l; onecol = vectorv(l + 1, i, 1);
  left = matrix(l + 1, l + 1, j, k, if (j <= k, binomial(k-1, j-1) << (l - k + 1)));
  right = matrix(l + 1, l + 1, j, k, left[l + 2 - j, l + 2 - k]);
  \\ powers of t -> powers of s, t = a + (b-a) s -> Bernstein coefficients on (a, b)
  conv = matrix(l + 1, l + 1, i, j, if (j <= i, binomial(i-1, j-1) * a^(i-j) * (b - a)^(j-1)))
       * matrix(l + 1, l + 1, j, k, if (j <= k, binomial(k-1, j-1)/binomial(l, j-1)));
  den = denominator(conv);
  row = (j -> vecextract(A, vector((M - j)\q + 1, i, j + 1 + (i - 1)*q), Str("1..", l + 1)));
  scale = T^l; rowpolys = (j -> apply(p -> Polrev(p, 't), Vec(row(j)~)));
  node([[j, row(j)] | j <- J], conv * den, scale * den, a, b, bisections);
}

\\ [parameter, sets of levels 1..L]
levels(name, n, L) =
{
  my([u, v, T, par] = difference(name, n), C = [1], q, U = List(), up, vp, ends);
  \\ |c_0(t)| < 1 is necessary at every level
  if (polcoef(v, 0) == 0, error("the end coefficient does not depend on the parameter"));
  ends = vecsort([(T*s - polcoef(u, 0)) / polcoef(v, 0) | s <- [-1, 1]]);
  for (l = 1, L,
    q = 2^(l-1); up = subst(u, z, z^q); vp = subst(v, z, z^q);
    C = concat(apply(p -> p*up, C), [0]) + concat([0], apply(p -> p*vp, C));
    listput(U, level(C, T, l, ends[1], ends[2])));
  [par, Vec(U)];
}

\\ ---- output --------------------------------------------------------------------------------------------------------

\\ "exact" is p/q, or root(POLY, k): the k-th real root, ascending from 1, of the minimal polynomial.
number(X, par) =
{
  my([P, lo, hi] = X, e);
  e = if (lo == hi, Str(lo), Str("root(", subst(P, 't, eval(par)), ", ", polsturm(P, [-oo, hi]), ")"));
  Str("{\"exact\": \"", e, "\", \"lower\": \"", lo, "\", \"upper\": \"", hi,
      "\", \"approx\": ", strprintf("%.24f", (lo + hi)/2.), "}");
}
intervals(F, par) =
  Str("[", strjoin([Str("{\"lo\": ", number(I[1], par), ", \"hi\": ", number(I[2], par), "}") | I <- F], ", "), "]");

contractivity(name, n, L) =
{
  my([par, U] = levels(name, n, L));
  print("{\"tool\": \"PARI/GP\", \"scheme\": \"", name, "\", \"parameter\": \"", par, "\", \"continuity\": ", n,
    ", \"level\": ", L, ", \"levels\": [",
    strjoin([Str("{\"level\": ", l, ", \"proved\": ", intervals(U[l], par), "}") | l <- [1..L]], ", "),
    "], \"proved\": ", intervals(union(concat(U)), par), "}");
}
