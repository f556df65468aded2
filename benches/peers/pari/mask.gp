\\ mask.gp: the mask of a_{2N+2} from its closed form, in PARI/GP (written for 2.15).
\\
\\   echo 'mask("a20")' | gp -fq -s 256M benches/peers/pari/mask.gp
\\
\\ prints, as one JSON object, the coefficients of
\\
\\   a(z) = 1 - alpha (-D)^(N+1) + sum_{k<=N} C(2k,k)/16^k (-D)^k (z^-1 + z)/2,   D = z^-2 - 2 + z^2.

mask(name) =
{
  my(N = eval(concat(Vec(name)[2..-1]))/2 - 1, M = 2*N + 2, D = (z^2 - 1)^2, a);
  \\ z^M a(z); variables that are made first are the main ones, and z is made above
  a = z^M - alpha*(-D)^(N+1) + sum(k = 0, N, binomial(2*k, k)/16^k * (-D)^k * z^(2*(N-k)+1)) * (1 + z^2)/2;
  print("{\"mask\": [", strjoin([Str("{\"index\": ", i - M, ", \"coefficient\": \"", polcoef(a, i, z), "\"}")
    | i <- [0..2*M]], ", "), "]}");
}
