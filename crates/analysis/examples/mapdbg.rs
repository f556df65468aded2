use refinable_analysis::*;
use refinable_certificate::*;
use refinable_scheme::Scheme;
use std::time::Instant;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let scheme = Scheme::resolve(&args[1], 2).unwrap();
    for n in args[2].split(',').map(|n| n.parse::<usize>().unwrap()) {
        let t = Instant::now();
        let w = default_window(&args[1], scheme.mask(), n).unwrap();
        let t1 = t.elapsed();
        let t = Instant::now();
        let m = map(&args[1], scheme.mask(), n, &w, &Sharpness::default());
        let t2 = t.elapsed();
        println!("{} C{n} window {:?} {t1:?}", args[1], w.map(|s| s.map(|x| x.to_string())));
        match m {
            Err(e) => println!("  {e}"),
            Ok(m) => {
                let count = |f: fn(&Node) -> bool| {
                    m.certificate.nodes.iter().filter(|n: &&Node| f(*n)).count()
                };
                let a = m.areas().map(|a| refinable_algebra::decimal(&a.lower, 6));
                println!(
                    "  {t2:?} nodes {} norm {} poly {} word {} und {}; areas {a:?} size {} KB; stable {:?}, sections {}",
                    m.certificate.nodes.len(),
                    count(|n| matches!(n, Node::Norm)),
                    count(|n| matches!(n, Node::Polytope(_))),
                    count(|n| matches!(n, Node::Word(_))),
                    count(|n| matches!(n, Node::Undecided)),
                    m.certificate.to_json().len() / 1000,
                    m.certificate.stable_at.is_some(),
                    m.certificate.sections.len()
                );
                let v = Instant::now();
                verify_map(&m.certificate).unwrap();
                println!("  verify {:?}", v.elapsed());
                let f = |x: &refinable_algebra::Rational| refinable_algebra::decimal(x, 9);
                let mut out = String::new();
                for c in &m.cells {
                    let kind = match &m.certificate.nodes[c.node] {
                        Node::Norm => "norm".into(),
                        Node::Polytope(p) => format!("poly {}", p.vertices.len()),
                        Node::Word(w) => format!("word {} {:?} {}", w.word, w.eigenvalue, w.radius),
                        _ => "und".to_string(),
                    };
                    let pts: Vec<String> = c
                        .polygon
                        .points()
                        .iter()
                        .map(|[x, y]| format!("{},{}", f(x), f(y)))
                        .collect();
                    out += &format!("{kind};{}\n", pts.join(" "));
                }
                std::fs::write(format!("/tmp/m/{}-{n}.txt", args[1]), out).unwrap();
            }
        }
    }
}
