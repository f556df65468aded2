\\ degrees.gp: exact degrees of generation and reproduction with the tensions free, in PARI/GP (written for 2.15).
\\
\\   echo 'degrees("a43")' | gp -fq benches/peers/pari/degrees.gp
\\
\\ prints, as one JSON object, the strata of the scheme a_{2N+3}, symbol (D = z^-2 - 2 + z^2, b = beta (1-alpha))
\\
\\   a(z) = 1 - alpha (-D)^(N+1) + e_N(z) + b D^(N+1) (z^-1 + z),
\\
\\ or a_{2N+2}, the same without the last summand; generic stratum first, then every set on which a degree rises, down to single points.
\\
\\ Method: with tau = a'(1)/2, the generation degree is the largest d with a^(k)(-1) = 0 for k <= d, and reproduction asks
\\ besides that a^(k)(1) = 2 tau (tau-1) ... (tau-k+1) for k <= d. The symbol is affine in (alpha, b), so all derivatives
\\ are affine forms: two matrix products. The first form that does not vanish on a stratum stops the degree; where it has
\\ zeros, they are the next stratum. Derivatives up to order 2N+8 suffice, which is checked.

\\ Forms are row vectors on (1, alpha, b). A stratum is a matrix whose columns parametrise it: (1, alpha, b)~ = S (1, ...)~.

forms(m) =
{
  my(N = m\2 - 1, D = (z^2 - 1)^2, M = 2*N + 3, K = 2*N + 8, E, A, mask, G, R, tau);
  E = sum(k = 0, N, binomial(2*k, k)/16^k * (-D)^k * z^(2*(N-k))) * z^2 * (1 + z^2)/2;
  \\ z^(2N+3) times the parts of a: exponent i of a is row i + M + 1
  A = [z^M + E, -z*(-D)^(N+1), D^(N+1) * (1 + z^2)];
  if (m % 2 == 0, A = A[1..2]);
  mask = matrix(2*M + 1, #A, i, j, polcoef(A[j], i - 1));
  G = matrix(K + 1, 2*M + 1, k, i, binomial(i - 1 - M, k - 1));      \\ of order k-1, divided by (k-1)!
  R = G * mask;
  G = matrix(K + 1, 2*M + 1, k, i, (-1)^(i - M - k) * G[k, i]) * mask;
  tau = R[2, ]/2; if (tau[2..-1] != 0*tau[2..-1], error("tau depends on the parameters")); tau = tau[1];
  for (k = 0, K, R[k+1, 1] -= 2 * prod(l = 0, k - 1, tau - l)/k!);
  [G, R, tau];
}

\\ Order of the first form that does not vanish on S.
stop(F, S) = { for (k = 1, matsize(F)[1], if (F[k, ] * S, return(k - 1))); error("more derivatives needed"); }

\\ The zeros on S of the form f: a stratum of one dimension less, or [] if there are none. Solves for the last unknown.
cut(f, S) =
{
  my(g = f * S, n = #g, j = n, Q);
  while (j > 1 && g[j] == 0, j--); if (j == 1, return([]));
  Q = matid(n); for (i = 1, n, if (i != j, Q[j, i] = -g[i]/g[j]));
  S * vecextract(Q, Str("^", j));
}

strata(m) =
{
  my([G, R, tau] = forms(m), todo = List([matid(#G)]), out = List(), i = 1, S, g, r, T);
  while (i <= #todo,
    S = todo[i]; i++;
    g = stop(G, S) - 1; r = min(g, stop(R, S) - 1);
    listput(out, [S, g, r]);
    foreach (concat([G[g+2, ]], if (r < g, [R[r+2, ]], [])), f,
      T = cut(f, S); if (T != [] && !setsearch(Set(Vec(todo)), T), listput(todo, T))));
  [Vec(out), tau];
}

\\ alpha and beta = b/(1-alpha) of a stratum, as far as they are determined: [name, value as a string] pairs.
parameters(S) =
{
  my(d = #S - 1, v = S * [1, 'alpha, 'b][1..d+1]~, den);
  if (d == #v - 1, return([]));
  if (#v == 2, return([["alpha", Str(v[2])]]));
  if (v[2] == 1, error("alpha = 1"));
  if (d == 0, return([["alpha", Str(v[2])], ["beta", Str(v[3]/(1 - v[2]))]]));
  if (v[2] != 'alpha, return([["alpha", Str(v[2])]]));                            \\ a line alpha = constant
  den = denominator(content(v[3]));
  [["beta", Str("(", den*v[3], ")/(", den, "*(1 - alpha))")]];
}

degrees(name) =
{
  my(m = eval(concat(Vec(name)[2..-1])), s, tau, p, rows = List());
  if (Vec(name)[1] != "a" || m < 2, error("a2, a3, a4, ... expected"));
  [s, tau] = strata(m);
  foreach (s, x,
    p = parameters(x[1]);
    listput(rows, Str("{\"condition\": \"", if (#p, strjoin([Str(q[1], " = ", q[2]) | q <- p], ", "), "generic"),
      "\", \"parameters\": {", strjoin([Str("\"", q[1], "\": {\"exact\": \"", q[2], "\"}") | q <- p], ", "),
      "}, \"generation\": ", x[2], ", \"reproduction\": ", x[3], ", \"tau\": \"", tau, "\"}")));
  print("{\"tool\": \"PARI/GP\", \"scheme\": \"", name, "\", \"strata\": [", strjoin(Vec(rows), ", "), "]}");
}
