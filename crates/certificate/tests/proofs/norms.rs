//! The lemma `norm`.

use serde_json::json;

use crate::support::{
    accept, certificate, check, constant_family, four_point, nothing, refuse, smooth,
};

#[test]
fn norms_of_the_four_point_scheme() {
    // The classical range of level two is 0 < ω < (√5 - 1)/8 = 0.1545….
    let norm = |from: &str, to: &str| json!([{"kind": "norm", "level": 2, "from": from, "to": to}]);
    for (from, to) in [("1/100", "1/8"), ("1/1000000", "77/500"), ("1/16", "1/16")] {
        accept(&certificate(&four_point(), &smooth(1, &[[from, to]]), &norm(from, to)));
    }
    for (from, to) in [("0", "1/8"), ("1/100", "31/200"), ("1/8", "1/100"), ("1/5", "1/5")] {
        let claim = certificate(&four_point(), &nothing(1), &norm(from, to));
        assert!(check(&claim).is_err(), "{from} {to}");
    }
    let claim = certificate(&four_point(), &smooth(1, &[["1/101", "1/8"]]), &norm("1/100", "1/8"));
    refuse(&claim, "proved interval 0 is not covered");
    let mut level = norm("1/100", "1/8");
    level[0]["level"] = json!(0);
    refuse(&certificate(&four_point(), &nothing(1), &level), "the level is less than one");
    // c = (-1 + 5z)/4: one row of the two, which are not mirror images.
    for mask in [[-1, 4, 5], [5, 4, -1]] {
        let family = constant_family(&mask, 4, 1);
        let norm = json!([{"kind": "norm", "level": 1, "from": "0", "to": "0"}]);
        refuse(&certificate(&family, &nothing(0), &norm), "of the norm is not shown");
    }
    // Two lemmas that meet, and two that leave a number out.
    let two = |to: &str, from: &str| {
        let lemmas = [norm("1/100", to)[0].clone(), norm(from, "1/8")[0].clone()];
        certificate(&four_point(), &smooth(1, &[["1/50", "1/9"]]), &json!(lemmas))
    };
    accept(&two("1/20", "1/20"));
    refuse(&two("1/20", "51/1000"), "not covered");
}
