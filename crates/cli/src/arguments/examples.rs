//! What stands below the help of every command. A test runs all of it.

pub const REFINABLE: &str = "\
Examples:
  refinable regularity dd6
  refinable range '[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]' -n 1
  refinable tables --table masks-a-even";

pub const SHOW: &str = "\
Examples:
  refinable show '1/8*z^-2*(1+z)^4'
  refinable show a6 --derive
  refinable show a5 -o rules.svg";

pub const DEGREES: &str = "\
Examples:
  refinable degrees '1/16*[-1, 0, 9, 16, 9, 0, -1]'
  refinable degrees a3 --format latex";

pub const RANGE: &str = "\
Examples:
  refinable range '[-w, 0, 1/2+w, 1, 1/2+w, 0, -w]' --continuity 1
  refinable range a4 --continuity 2 --level 3
  refinable range a3 --set 'beta=(8*alpha-1)/(16*(1-alpha))' -n 3 --format json";

pub const REGULARITY: &str = "\
Examples:
  refinable regularity dd6
  refinable regularity a2 --sweep 'alpha=0..1/4:8' -o exponent.svg";

pub const MAP: &str = "\
Examples:
  refinable map a3 -n 1 --undecided 1/8 -o a3.svg
  refinable map a3 -n 0 --undecided 1/8 --mark 'alpha=3/16,beta=1/26' -o marked.svg";

pub const EXPLORE: &str = "\
Examples:
  refinable explore a2 -o a2.html";

pub const SCAN: &str = "\
Examples:
  refinable scan a3 --grid 'alpha=0..1/4:8,beta=-1/8..1/8:8'
  refinable scan a3 --grid 'alpha=0..1/4:8,beta=-1/8..1/8:8' --what generation -o scan.csv";

pub const CURVE: &str = "\
Examples:
  refinable curve bspline3 examples/bracket.csv --closed -o curve.svg
  refinable curve dd4 examples/bracket.csv --closed --levels 1 --exact
  echo '0,0 4,0 4,4' | tr ' ' '\\n' | refinable curve bspline2 --levels 1";

pub const SURFACE: &str = "\
Examples:
  refinable surface bspline3 examples/vessel.csv --closed rows -o vessel.obj
  refinable surface 'tensor(dd4, bspline3)' examples/vessel.csv --ends reflect -l 2 -o vessel.svg";

pub const BASIS: &str = "\
Examples:
  refinable basis dd4 --levels 0 --derivatives 1
  refinable basis dd6 -o phi.svg";

pub const INTERPROXIMATE: &str = "\
Examples:
  refinable interproximate a3 examples/tensions.csv --closed -o local.svg
  refinable interproximate a3 examples/bracket.csv --closed --interpolate 0,1 \\
    --interpolating 'alpha=0,beta=-1/20' --approximating 'alpha=1/8,beta=0' -o some.svg";

pub const CERTIFY: &str = "\
Examples:
  refinable certify i4 -n 1 -o i4.json
  refinable certify dd4 -o dd4.json";

pub const ANALYZE: &str = "\
Examples:
  refinable analyze '1/16*[-1, 0, 9, 16, 9, 0, -1]'";

pub const COMPARE: &str = "\
Examples:
  refinable compare dd4 bspline3 'pseudo(3, 1)' --format latex";

pub const SCHEMES: &str = "\
Examples:
  refinable schemes --format csv";

pub const CHECK: &str = "\
Examples:
  refinable expect dd4 > dd4.scheme.toml
  refinable check dd4.scheme.toml";

pub const EXPECT: &str = "\
Examples:
  refinable expect '1/16*[-1, 0, 9, 16, 9, 0, -1]'";

pub const EXPORT: &str = "\
Examples:
  refinable export a5 --to sympy
  refinable export a3 --set alpha=1/8 --to latex -o a3.tex";

pub const SCHEMA: &str = "\
Examples:
  refinable schema > scheme.schema.json";

pub const COMPLETIONS: &str = "\
Examples:
  refinable completions bash > refinable.bash
  refinable completions zsh > _refinable";

pub const MAN: &str = "\
Examples:
  refinable man man1";

pub const VERIFY: &str = "\
Examples:
  refinable certify dd4 -o dd4.json
  refinable verify dd4.json";

pub const NORM: &str = "\
Examples:
  refinable norm a3 --continuity 1
  refinable norm i4 --continuity 0 --level 2 --format latex";

pub const TABLES: &str = "\
Examples:
  refinable tables --table masks-a-even
  refinable tables --table norms --format csv";

pub const REPORT: &str = "\
Examples:
  refinable report build reports
  refinable report check reports";

pub const REPORT_BUILD: &str = "\
Examples:
  refinable report build reports";

pub const REPORT_CHECK: &str = "\
Examples:
  refinable report check reports";
