//! Scratch.
use refinable_analysis::*;
use refinable_scheme::{Scheme, Substitution};
use refinable_certificate::Lemma;
fn main() {
    let mut args = std::env::args().skip(1);
    let (name, n) = (args.next().unwrap(), args.next().unwrap().parse::<usize>().unwrap());
    let subs: Vec<_> = args.map(|a| Substitution::parse(&a).unwrap()).collect();
    let scheme = Scheme::resolve_with(&name, 2, &subs).unwrap();
    let parameter = scheme.mask().parameters().into_iter().next().unwrap();
    let t = std::time::Instant::now();
    let r = continuity_range(&name, scheme.mask(), &parameter, n, &Sharpness::default());
    println!("time {:?}", t.elapsed());
    let r = match r { Ok(r) => r, Err(e) => { println!("error {e}"); return } };
    println!("proved {}", r.proved.display("x"));
    for e in r.refuted.ends() { println!("end {} degree {:?}", e.decimal(10), e.polynomial().degree()); }  if std::env::var("R").is_ok() { println!("refuted {}", r.refuted.display("x")); }
    for i in r.undecided().intervals() { println!("undecided {:?} {:?}", i.lower.number().map(|x| x.decimal(10)), i.upper.number().map(|x| x.decimal(10))); }
    println!("points {:?}", r.points.iter().map(|(x, v)| format!("{} {v:?}", x.decimal(8))).collect::<Vec<_>>());
    let c = r.certificate;
    for l in &c.lemmas {
        match l {
            Lemma::Polytope(p) => print!("P {:?} {}v; ", p.leading.iter().map(|l| format!("{}{}", l.sign, l.word)).collect::<Vec<_>>(), p.vertices.len()),
            Lemma::Word { word, .. } => print!("W {word}; "),
            Lemma::Norm { level, .. } => print!("N {level}; "),
            Lemma::Stable { except } => print!("S {}; ", except.len()),
            Lemma::At { .. } => print!("At; "),
            _ => print!("other; ")
        }
    }
    println!();
    let t = std::time::Instant::now();
    refinable_certificate::verify(&c).unwrap();
    println!("verify {:?}", t.elapsed());
    let json = serde_json::to_string(&c).unwrap();
    println!("bytes {}", json.len());
}
