//! The explorer in a real browser: what the page says against what the library says, and every control.

mod browser;

use std::path::PathBuf;
use std::process::Command;

use refinable_algebra::{Rational, Ring, parse_rational, rational};
use refinable_analysis::{Fineness, Map, MapVerdict, Sharpness, degrees};
use refinable_refine::{Ends, Polygon};
use refinable_report::{Assignment, Maps, sharp_range};
use refinable_scheme::Scheme;
use serde_json::Value;
use tempfile::TempDir;

use crate::browser::Browser;

/// The page that the program writes.
fn page(dir: &TempDir, name: &str, arguments: &[&str]) -> PathBuf {
    let path = dir.path().join(name);
    let mut command = Command::new(env!("CARGO_BIN_EXE_refinable"));
    let output = command.arg("explore").args(arguments).arg("-o").arg(&path).output();
    let output = output.expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    path
}

fn family(name: &str) -> Scheme {
    Scheme::resolve(name, 2).expect("a scheme")
}

fn numbers(texts: &[&str]) -> Vec<Rational> {
    texts.iter().map(|text| parse_rational(text).expect("a number")).collect()
}

/// Enters a point into the fields, without the mouse, and tells the verdicts by order.
fn verdicts(browser: &mut Browser, point: &[Rational]) -> Vec<(usize, String)> {
    let script: String = point
        .iter()
        .enumerate()
        .map(|(k, x)| {
            format!(
                "{{ const f = document.getElementById('parameter-{k}'); f.value = '{x}';
                 f.dispatchEvent(new Event('change')); }}"
            )
        })
        .collect();
    browser.evaluate(&script);
    browser.settle();
    let list = browser.evaluate(
        "[...document.querySelectorAll('#verdicts li')].map((li) => [Number(li.dataset.order), li.dataset.verdict])",
    );
    let entry = |entry: &Value| {
        let order = entry[0].as_u64().expect("an order") as usize;
        (order, entry[1].as_str().expect("a verdict").to_string())
    };
    list.as_array().expect("a list").iter().map(entry).collect()
}

fn fact(browser: &mut Browser, name: &str) -> String {
    browser.text(&format!("[data-fact='{name}'] dd"))
}

/// Degrees of the member at a point, by the library, beside those of the page.
fn expect_degrees(browser: &mut Browser, scheme: &Scheme, point: &[Rational]) {
    let member = scheme.mask().at(point).expect("no pole");
    let found = degrees(&member);
    let generic = found.generic();
    let expected = [generic.generation.0.to_string(), generic.reproduction.0.to_string()];
    assert_eq!(["generation", "reproduction"].map(|f| fact(browser, f)), expected, "at {point:?}");
}

/// Points all over a box, and beyond it.
fn scattered(count: usize) -> impl Iterator<Item = [Rational; 2]> {
    let mut state = 12345_u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as i64 % 1000
    };
    (0..count).map(move |_| {
        [rational(next(), 640) - rational(1, 2), rational(next(), 320) - rational(1, 1)]
    })
}

/// The verdicts of the page at a point, which are those of the maps; what is not C^n is not smoother.
fn agreed(browser: &mut Browser, maps: &Maps, point: &[Rational; 2]) -> Vec<String> {
    let shown = verdicts(browser, point).into_iter();
    let mut rough = false;
    let agree = |(map, (order, verdict)): (&Map, (usize, String))| {
        let expected = match map.verdict_at(point) {
            MapVerdict::Proved => "proved",
            MapVerdict::Undecided if !rough => "undecided",
            MapVerdict::Refuted | MapVerdict::Undecided => "refuted",
        };
        rough |= expected == "refuted";
        assert_eq!((map.continuity(), expected), (order, &verdict[..]), "at {point:?}");
        verdict
    };
    maps.maps.iter().zip(shown).map(agree).collect()
}

#[test]
fn two_parameters() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let path = page(&dir, "a3.html", &["a3"]);
    let scheme = family("a3");
    browser.resize(1280, 900);
    browser.open(&path, "");
    let shown = verdicts(&mut browser, &numbers(&["1/16", "-1/48"]));
    let highest = shown.last().expect("some orders").0;
    let maps =
        Maps::new(&scheme, &format!("0..{highest}"), None, &Fineness::default()).expect("maps");
    // On the curve of C^2 and C^3, at its ends, at its smoothest point, where a factor vanishes, far outside.
    let special = [
        ["3/16", "1/26"],
        ["0", "-1/16"],
        ["1/4", "1/12"],
        ["1/2", "3/8"],
        ["1/8", "0"],
        ["1", "1/3"],
        ["0.25", "1/12"],
        ["7", "-5"],
    ];
    let special = special.iter().map(|p| numbers(p).try_into().expect("two numbers"));
    let mut seen = Vec::new();
    for point in special.chain(scattered(40)) {
        seen.extend(agreed(&mut browser, &maps, &point));
        expect_degrees(&mut browser, &scheme, &point);
    }
    for verdict in ["proved", "refuted", "undecided"] {
        assert!(seen.iter().any(|v| v == verdict), "nowhere {verdict}");
    }
    numbers_beyond_floats(&mut browser);
    controls(&mut browser);
    curves(&mut browser, &path, &scheme);
    assert_eq!(browser.errors, [""; 0]);
}

/// Quotients of integers that are beyond all floats; the page keeps its functions to itself, so they are loaded apart.
fn numbers_beyond_floats(browser: &mut Browser) {
    const NUMBERS: &str = include_str!("../../../report/src/explorer/rational.js");
    for (n, d, nearest) in [
        ("-(10n ** 400n)", "4n * 10n ** 399n", -2.5),
        ("1n", "10n ** 400n", 0.0),
        ("-(3n ** 700n)", "3n ** 701n * 2n", -1.0 / 6.0),
        ("10n ** 400n", "10n ** 300n", 1e100),
    ] {
        let quotient = format!("(() => {{ {NUMBERS}; return toFloat({{ n: {n}, d: {d} }}) }})()");
        let float = browser.evaluate(&quotient).as_f64().expect("a number");
        assert!((float - nearest).abs() <= f64::EPSILON * nearest.abs(), "{n}/{d}: {float}");
    }
}

/// The fields, the mouse, the keys and the theme.
fn controls(browser: &mut Browser) {
    // What is typed stays in its field; the point is what the address says.
    let at = |browser: &mut Browser| {
        let at = browser.evaluate("location.hash.match(/at=([^&]*)/)[1]");
        let point: Vec<&str> = at.as_str().expect("text").split(',').collect();
        let point: [Rational; 2] = numbers(&point).try_into().expect("two numbers");
        point
    };
    browser.enter("#parameter-0", "1/16");
    browser.enter("#parameter-1", "-0.05");
    assert_eq!(at(browser), [rational(1, 16), rational(-1, 20)]);
    let commands = browser.text("#commands");
    assert!(
        commands.contains("refinable regularity a3 --set alpha=1/16 --set beta=-1/20"),
        "{commands}"
    );
    browser.enter("#parameter-1", "1/0");
    assert!(browser.text("#entry-error").contains("enter a number"));
    assert_eq!(at(browser)[1], rational(-1, 20));
    browser.enter("#parameter-1", "0");
    assert_eq!(browser.text("#entry-error"), "");
    // A drag ends on the grid that is stated.
    browser.evaluate("document.activeElement.blur()");
    let grid = browser.evaluate("Number(document.getElementById('grid').value)");
    let grid = Rational::from_i64(grid.as_i64().expect("a number"));
    browser.drag("#handle .knob", [40.0, -30.0]);
    let dragged = at(browser);
    assert!(dragged[0] > rational(1, 16) && dragged[1] > rational(0, 1), "{dragged:?}");
    assert!(dragged.iter().all(|x| (x * &grid).is_integer()), "{dragged:?}");
    browser.press("ArrowLeft");
    browser.press("ArrowUp");
    let [u, v] = at(browser);
    assert_eq!([&dragged[0] - u, v - &dragged[1]], [grid.recip(), grid.recip()]);
    assert_eq!(browser.evaluate("document.activeElement.getAttribute('role')"), "slider");
    let told = browser.evaluate("document.getElementById('handle').getAttribute('aria-valuetext')");
    assert!(told.as_str().expect("text").starts_with("alpha = "), "{told}");
    let touched = at(browser);
    browser.swipe("#handle .knob", [20.0, 20.0]);
    let [u, v] = at(browser);
    assert!(u > touched[0] && v < touched[1], "{touched:?} to {u}, {v}");
    let seen = "new URLSearchParams(location.hash.slice(1)).get('view')";
    browser.click("#zoom-in");
    assert!(browser.evaluate(seen).is_string());
    browser.click("#zoom-out");
    assert!(browser.evaluate(seen).is_null());
    // Too far away there is no curve, and nothing else goes wrong.
    for digits in [6, 20, 75] {
        browser.enter("#parameter-1", &"9".repeat(digits));
        assert_eq!(browser.evaluate("document.querySelector('.limit').getAttribute('d')"), "");
    }
    let background = "getComputedStyle(document.body).backgroundColor";
    let light = browser.evaluate(background);
    browser.click("#theme");
    assert_ne!(browser.evaluate(background), light);
    assert_eq!(browser.evaluate("document.documentElement.dataset.theme"), "dark");
    browser.click("#theme");
    assert_eq!(browser.evaluate(background), light);
    for width in [390, 320] {
        browser.resize(width, 844);
        let widest = browser.evaluate("document.documentElement.scrollWidth");
        assert!(widest.as_u64().expect("a number") <= u64::from(width), "{widest} in {width}");
    }
    browser.resize(1280, 900);
    let count = |browser: &mut Browser| {
        browser.evaluate("document.querySelectorAll('.vertex').length").as_u64().expect("a number")
    };
    let before = count(browser);
    browser.click("#add");
    assert_eq!(count(browser), before + 1);
    // The new vertex has the focus.
    browser.press("Delete");
    assert_eq!(count(browser), before);
    let [x, y] = browser.place_of(".vertex:nth-child(2) .dot");
    browser.click_at([x + 40.0, y + 40.0], 2);
    assert_eq!(count(browser), before + 1);
    browser.click("#remove");
    assert_eq!(count(browser), before);
    let hash = browser.evaluate("location.hash");
    browser.drag(".vertex:nth-child(3) .dot", [-25.0, 10.0]);
    assert_ne!(browser.evaluate("location.hash"), hash);
    browser.click("#reset");
}

/// The curve of the page in the coordinates of its control points, which give the scale.
fn shown_curve(browser: &mut Browser) -> Vec<[f64; 2]> {
    let found = browser.evaluate(
        "(() => { const v = [...document.querySelectorAll('.vertex .dot')].map((c) => [+c.getAttribute('cx'), +c.getAttribute('cy')]);
         const d = document.querySelector('.limit').getAttribute('d');
         return [v, d.match(/[-\\d.]+ [-\\d.]+/g).map((p) => p.split(' ').map(Number))]; })()",
    );
    let place = |value: &Value| [0, 1].map(|k| value[k].as_f64().expect("a number"));
    // The bracket: vertex 0 at (0, 0), vertex 4 at (0, 10).
    let [origin, top] = [0, 4].map(|k| place(&found[0][k]));
    let scale = (origin[1] - top[1]) / 10.0;
    let world = |[x, y]: [f64; 2]| [(x - origin[0]) / scale, (origin[1] - y) / scale];
    found[1].as_array().expect("points").iter().map(|p| world(place(p))).collect()
}

/// Closed, open and interproximate curves against those of the library.
fn curves(browser: &mut Browser, path: &std::path::Path, scheme: &Scheme) {
    let bracket =
        [[0, 0], [4, 0], [5, 5], [4, 10], [0, 10], [0, 8], [1, 8], [2, 5], [1, 2], [0, 2]];
    let values: Vec<f64> = bracket.iter().flatten().map(|&x| f64::from(x)).collect();
    let (approximating, interpolating) = (["1/8", "1/50"], ["0", "-1/16"]);
    for (closed, tagged) in [(true, &[][..]), (false, &[]), (true, &[0, 3, 4]), (false, &[0, 2, 9])]
    {
        for levels in [0, 1, 5] {
            let list: Vec<String> = tagged.iter().map(ToString::to_string).collect();
            let hash = format!(
                "#at=1/8,1/50&levels={levels}&closed={}&interpolate={}",
                u8::from(closed),
                list.join(",")
            );
            browser.open(path, &hash);
            let shown = shown_curve(browser);
            let polygon = Polygon::new(2, values.clone(), closed).expect("a polygon");
            let [interpolating, approximating] =
                [interpolating, approximating].map(|m| numbers(&m));
            let members = Assignment::of_vertices(10, tagged, interpolating, approximating);
            let members = members.expect("members");
            let expected =
                members.refine(scheme, &polygon, levels, Ends::Reflect).expect("a curve");
            assert_eq!(shown.len(), expected.count(), "{hash}");
            for (shown, expected) in shown.iter().zip(expected.points()) {
                let near = (0..2).all(|k| (shown[k] - expected[k]).abs() < 1e-3);
                assert!(near, "{hash}: {shown:?}, not {expected:?}");
            }
        }
    }
}

/// A page of a box that was asked for begins in it; where the denominator vanishes nothing is defined.
#[test]
fn two_parameters_with_poles() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let (text, window) = ("even: [a/b, 1-2*a/b, a/b]; odd: [1/2, 1/2]", "a=-1..1,b=-1..1");
    let path = page(&dir, "poles.html", &[text, "--box", window]);
    let scheme = family(text);
    browser.open(&path, "");
    assert_eq!(browser.text("#headline"), "C¹ is proved, C² is refuted");
    let maps = Maps::new(&scheme, "0..3", Some(window), &Fineness::default()).expect("maps");
    let mut seen = Vec::new();
    for point in scattered(30) {
        seen.extend(agreed(&mut browser, &maps, &point));
    }
    assert!(["proved", "refuted", "undecided"].iter().all(|v| seen.iter().any(|s| s == v)));
    // On the line of cubic B-splines, t = 1/8.
    for point in [["1/16", "1/2"], ["-3/40", "-3/5"]] {
        let point: [Rational; 2] = numbers(&point).try_into().expect("two");
        let expected = ["proved", "proved", "proved", "refuted"];
        assert_eq!(agreed(&mut browser, &maps, &point), expected);
    }
    let undefined = ["undefined"; 4].map(String::from);
    for pole in [["1/2", "0"], ["0", "0"]] {
        let shown = verdicts(&mut browser, &numbers(&pole)).into_iter();
        assert_eq!(shown.map(|(_, verdict)| verdict).collect::<Vec<_>>(), undefined);
        assert!(browser.text("#mask").contains("pole"));
        assert_eq!(browser.text("#headline"), "The family has a pole here");
        let shown = browser.evaluate(
            "[...document.querySelectorAll('#commands li, #facts, #certificate')].filter((e) => e.offsetParent).length",
        );
        assert_eq!(shown, 1, "the address of this view");
    }
    assert_eq!(browser.errors, [""; 0]);
}

/// The quintic B-spline, C^4 with the exponent 5, at a single point of a family with products and quotients, where maps
/// leave nearly all orders open; beside it the page says no more than they.
#[test]
fn members_by_themselves() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let text = "[s*t, t/(1+t), 1/2-s*t, 1-2*t/(1+t), 1/2-s*t, t/(1+t), s*t]";
    let window = "s=-1..1,t=0..1";
    let path = page(&dir, "member.html", &[text, "--box", window]);
    browser.open(&path, "#at=13/96,3/13");
    assert_eq!(browser.text("#headline"), "C⁴ is proved, C⁵ is refuted");
    assert_eq!(fact(&mut browser, "Hölder exponent"), "5");
    assert_eq!(browser.text("#mask"), "1/32*[1, 6, 15, 20, 15, 6, 1]");
    let again = browser.text("#certify");
    assert!(again.contains("certify") && again.contains("--set s=13/96 --set t=3/13"), "{again}");
    let notable = browser.text("#notable");
    assert!(notable.contains("smoothest found; degrees 5, 1; exponent 5"), "{notable}");
    let maps = Maps::new(&family(text), "0..2", Some(window), &Fineness::default()).expect("maps");
    for point in scattered(20) {
        agreed(&mut browser, &maps, &point);
    }
    verdicts(&mut browser, &numbers(&["-7/8", "7/8"]));
    assert!(browser.text("#curve-note").contains("No continuous limit: C⁰ is refuted here"));
    // Names in the other order: the plane of `a3` takes `b` first, masks take `a`.
    let renamed = ["a3", "--set", "alpha=b", "--set", "beta=a", "--box", "b=0..1/4,a=0..1/8"];
    browser.open(&page(&dir, "renamed.html", &renamed), "#at=3/16,1/26");
    assert_eq!(fact(&mut browser, "Hölder exponent"), "5");
    assert_eq!(browser.text("#mask"), "1/32*[1, 6, 15, 20, 15, 6, 1]");
    assert_eq!(browser.errors, [""; 0]);
}

/// Arity 3: the stability of the shifts is tested by contrasts, and C^1 holds on a line, `b = 1/3` with `0 < a < 1/3`.
#[test]
fn two_parameters_of_a_ternary_family() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let text = "[a, b, 1-b, 1-2a, 1-b, b, a]";
    let path = page(&dir, "ternary.html", &[text, "--arity", "3"]);
    let scheme = Scheme::resolve(text, 3).expect("a scheme");
    browser.open(&path, "");
    let maps = Maps::new(&scheme, "0..2", None, &Fineness::default()).expect("maps");
    let mut seen = Vec::new();
    for point in scattered(30) {
        seen.extend(agreed(&mut browser, &maps, &point));
    }
    assert!(["proved", "refuted", "undecided"].iter().all(|v| seen.iter().any(|s| s == v)));
    for (point, expected) in [
        (["1/9", "1/3"], ["proved", "proved", "refuted"]),
        (["2/5", "1/3"], ["proved", "refuted", "refuted"]),
        (["1/9", "1/4"], ["proved", "refuted", "refuted"]),
    ] {
        let point: [Rational; 2] = numbers(&point).try_into().expect("two");
        assert_eq!(agreed(&mut browser, &maps, &point), expected, "{point:?}");
    }
    assert_eq!(browser.errors, [""; 0]);
}

#[test]
fn one_parameter() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let path = page(&dir, "i4.html", &["i4"]);
    let scheme = family("i4");
    browser.open(&path, "");
    let points = [
        "-1/2",
        "-0.4999",
        "-1/5",
        "-0.1927288",
        "-0.192729",
        "-0.19273",
        "-1/16",
        "0",
        "1/4",
        "1/2",
        "0.51",
        "9",
    ];
    for point in points.map(|text| numbers(&[text])) {
        let shown = verdicts(&mut browser, &point);
        assert!(shown.len() >= 3);
        for (order, verdict) in shown {
            let range = sharp_range(&scheme, order, &Sharpness::default()).expect("a range");
            let regions = [&range.proved, &range.refuted];
            let expected = match regions.map(|region| region.contains_rational(&point[0])) {
                [true, _] => "proved",
                [_, true] => "refuted",
                _ => "undecided",
            };
            assert_eq!(verdict, expected, "C^{order} at {point:?}");
        }
        expect_degrees(&mut browser, &scheme, &point);
    }
    assert!(browser.text("#tag-note").contains("interpolated already"));
    browser.drag("#handle .knob", [30.0, 0.0]);
    browser.press("ArrowRight");
    assert_eq!(browser.errors, [""; 0]);
}

/// Names are text, whatever they contain, and the address sets all of the state.
#[test]
fn no_parameter_and_a_name_like_markup() {
    let Some(mut browser) = Browser::start() else { return };
    let dir = TempDir::new().expect("a directory");
    let name = "</script><script>throw 1</script>\"'&amp;";
    let file = dir.path().join("odd.scheme.toml");
    std::fs::write(
        &file,
        format!("name = '''{name}'''\nmask = \"1/16*[-1, 0, 9, 16, 9, 0, -1]\"\n"),
    )
    .expect("a file");
    let path = page(&dir, "odd.html", &[file.to_str().expect("text")]);
    browser.open(&path, "#levels=2&closed=0&theme=dark&points=0,0;1,2;3,0");
    assert_eq!(browser.text("#name"), name);
    assert_eq!(browser.text("#headline"), "C¹ is proved, C² is refuted");
    assert_eq!(fact(&mut browser, "Hölder exponent"), "2");
    assert_eq!(fact(&mut browser, "type"), "primal, interpolatory");
    assert_eq!(browser.evaluate("document.getElementById('closed').checked"), false);
    assert_eq!(browser.evaluate("document.querySelectorAll('.vertex').length"), 3);
    assert_eq!(browser.evaluate("document.getElementById('place').hidden"), true);
    assert_eq!(browser.errors, [""; 0]);
}
