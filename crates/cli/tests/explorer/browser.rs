//! A browser, driven by its debugging protocol over a pipe.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;

/// Set to `required` where the tests must not be skipped.
const WISH: &str = "REFINABLE_BROWSER";
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const FLAGS: [&str; 10] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--remote-debugging-pipe",
];
/// Longer than any answer takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// A running browser with one page.
pub struct Browser {
    child: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    next: u64,
    session: Option<String>,
    /// What went wrong on the page: exceptions, and errors and warnings on its console.
    pub errors: Vec<String>,
    /// Where the browser keeps what it keeps; removed with it.
    _profile: TempDir,
}

/// The first browser on the path.
fn find() -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    let folders: Vec<PathBuf> = env::split_paths(&path).collect();
    let all = NAMES.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    all.into_iter().find(|file| file.is_file())
}

impl Browser {
    /// A browser, if there is one; else a message, or a failure where one is required.
    pub fn start() -> Option<Browser> {
        let program = if cfg!(unix) { find() } else { None };
        let Some(program) = program else {
            let required = env::var(WISH).is_ok_and(|wish| wish == "required");
            assert!(!required, "{WISH}=required, but there is no browser: {}", NAMES.join(", "));
            eprintln!("skipped: no browser found ({})", NAMES.join(", "));
            return None;
        };
        let profile = TempDir::new().expect("a directory");
        // The protocol is spoken on the descriptors 3 and 4.
        let mut child = Command::new("sh")
            .args(["-c", "exec \"$0\" \"$@\" 3<&0 4>&1 </dev/null >/dev/null 2>&1"])
            .arg(program)
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .arg("about:blank")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the browser starts");
        let input = child.stdin.take().expect("piped");
        let mut output = BufReader::new(child.stdout.take().expect("piped"));
        let (sender, messages) = channel();
        thread::spawn(move || {
            let mut bytes = Vec::new();
            while output.read_until(0, &mut bytes).is_ok_and(|length| length > 0) {
                bytes.pop();
                let message = serde_json::from_slice(&bytes).expect("messages are JSON");
                if sender.send(message).is_err() {
                    return;
                }
                bytes.clear();
            }
        });
        let (next, session, errors) = (0, None, Vec::new());
        let mut browser =
            Browser { child, input, messages, next, session, errors, _profile: profile };
        let target = browser.call("Target.createTarget", &json!({"url": "about:blank"}));
        let attach = json!({"targetId": target["targetId"], "flatten": true});
        let attached = browser.call("Target.attachToTarget", &attach);
        browser.session = attached["sessionId"].as_str().map(String::from);
        for domain in ["Page", "Runtime", "Log"] {
            browser.call(&format!("{domain}.enable"), &json!({}));
        }
        Some(browser)
    }

    /// Calls a method of the protocol.
    pub fn call(&mut self, method: &str, parameters: &Value) -> Value {
        self.next += 1;
        let mut message = json!({"id": self.next, "method": method, "params": parameters});
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        write!(self.input, "{message}\0").expect("the browser listens");
        loop {
            let answer = self.messages.recv_timeout(PATIENCE).expect("the browser answers");
            self.note(&answer);
            if answer["id"] == self.next {
                assert!(answer["error"].is_null(), "{method}: {answer}");
                return answer["result"].clone();
            }
        }
    }

    fn note(&mut self, event: &Value) {
        let parameters = &event["params"];
        let is_bad = match event["method"].as_str() {
            Some("Runtime.exceptionThrown") => true,
            Some("Runtime.consoleAPICalled") => parameters["type"] != "log",
            Some("Log.entryAdded") => parameters["entry"]["level"] != "info",
            _ => false,
        };
        if is_bad {
            self.errors.push(parameters.to_string());
        }
    }

    /// The value of an expression on the page; promises are waited for.
    pub fn evaluate(&mut self, expression: &str) -> Value {
        let parameters = json!({
            "expression": expression, "awaitPromise": true, "returnByValue": true,
        });
        let found = self.call("Runtime.evaluate", &parameters);
        assert!(found["exceptionDetails"].is_null(), "{expression}: {found}");
        found["result"]["value"].clone()
    }

    /// Opens a file from disk.
    pub fn open(&mut self, path: &Path, hash: &str) {
        // Twice the same path with another hash would not be loaded anew.
        self.call("Page.navigate", &json!({"url": "about:blank"}));
        let url = format!("file://{}{hash}", path.display());
        self.call("Page.navigate", &json!({"url": url}));
        let begun = Instant::now();
        let ready = "document.readyState === 'complete' && location.protocol === 'file:'";
        while self.evaluate(ready) != true {
            assert!(begun.elapsed() < PATIENCE, "{url} does not load");
            thread::sleep(Duration::from_millis(20));
        }
        self.settle();
    }

    /// Waits until what changed is shown.
    pub fn settle(&mut self) {
        let frame = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))";
        self.evaluate(frame);
    }

    /// The size of the window, in pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let size = json!({
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 700,
        });
        self.call("Emulation.setDeviceMetricsOverride", &size);
        self.settle();
    }

    /// The middle of an element, scrolled into view.
    pub fn place_of(&mut self, selector: &str) -> [f64; 2] {
        let script = format!(
            "(() => {{ const e = document.querySelector({selector:?}); e.scrollIntoView({{block: 'center'}});
             const b = e.getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }})()"
        );
        let place = self.evaluate(&script);
        [0, 1].map(|k| place[k].as_f64().unwrap_or_else(|| panic!("{selector} is there")))
    }

    fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], clicks: u32) {
        let buttons = u32::from(kind != "mouseReleased");
        let event = json!({
            "type": kind, "x": x, "y": y, "button": "left", "buttons": buttons, "clickCount": clicks,
        });
        self.call("Input.dispatchMouseEvent", &event);
    }

    /// Clicks at a place, as often as is said.
    pub fn click_at(&mut self, place: [f64; 2], times: u32) {
        for k in 1..=times {
            self.mouse("mousePressed", place, k);
            self.mouse("mouseReleased", place, k);
        }
        self.settle();
    }

    /// Clicks on an element.
    pub fn click(&mut self, selector: &str) {
        let place = self.place_of(selector);
        self.click_at(place, 1);
    }

    /// Drags an element by so many pixels.
    pub fn drag(&mut self, selector: &str, [dx, dy]: [f64; 2]) {
        let [x, y] = self.place_of(selector);
        self.mouse("mousePressed", [x, y], 1);
        for k in 1..=4 {
            let f = f64::from(k) / 4.0;
            self.mouse("mouseMoved", [x + f * dx, y + f * dy], 0);
        }
        self.mouse("mouseReleased", [x + dx, y + dy], 1);
        self.settle();
    }

    /// Drags an element by so many pixels with a finger.
    pub fn swipe(&mut self, selector: &str, [dx, dy]: [f64; 2]) {
        let [x, y] = self.place_of(selector);
        let mut touch = |kind: &str, points: Value| {
            let event = json!({"type": kind, "touchPoints": points});
            self.call("Input.dispatchTouchEvent", &event);
        };
        touch("touchStart", json!([{"x": x, "y": y}]));
        for k in 1..=4 {
            let f = f64::from(k) / 4.0;
            touch("touchMove", json!([{"x": x + f * dx, "y": y + f * dy}]));
        }
        touch("touchEnd", json!([]));
        self.settle();
    }

    /// Presses a key in whatever has the focus.
    pub fn press(&mut self, key: &str) {
        let text = if key == "Enter" { "\r" } else { "" };
        self.call("Input.dispatchKeyEvent", &json!({"type": "keyDown", "key": key, "text": text}));
        self.call("Input.dispatchKeyEvent", &json!({"type": "keyUp", "key": key}));
        self.settle();
    }

    /// Replaces what is in a text field, as by typing, and confirms.
    pub fn enter(&mut self, selector: &str, text: &str) {
        self.click(selector);
        self.evaluate(&format!("document.querySelector({selector:?}).select()"));
        self.call("Input.insertText", &json!({"text": text}));
        self.press("Enter");
    }

    /// The text of an element.
    pub fn text(&mut self, selector: &str) -> String {
        let script = format!("document.querySelector({selector:?}).textContent");
        self.evaluate(&script).as_str().unwrap_or_else(|| panic!("{selector} is there")).to_string()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // It may have gone already; then there is nothing to end.
        let _ = write!(self.input, "{}\0", json!({"id": 0, "method": "Browser.close"}));
        let begun = Instant::now();
        while matches!(self.child.try_wait(), Ok(None)) && begun.elapsed() < Duration::from_secs(5)
        {
            thread::sleep(Duration::from_millis(20));
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
