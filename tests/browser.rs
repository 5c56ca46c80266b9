//! A browser without a screen, driven as a hand would: the one that `BROWSER` names, or Chromium.

use std::env;
use std::io::BufRead;
use std::io::BufReader;
use std::io::Read;
use std::io::Write;
use std::net::TcpListener;
use std::net::TcpStream;
use std::process::Child;
use std::process::Stdio;
use std::sync::LazyLock;
use std::thread;
use std::time::Duration;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::Value;
use tests::prelude::*;

pub(crate) static PAGE: LazyLock<PathBuf> = LazyLock::new(|| {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("class.html");
    let mut make = start(env!("CARGO"));
    make.current_dir(root()).args(["run", "--quiet", "-p", "lecture", "--", "--page"]).arg(&page);
    assert!(make.status().expect("cargo runs").success(), "the page is not made");
    page
});

/// Waits until the page has drawn its picture: its number, and the milliseconds it took.
pub(crate) const DRAWN: &str = "(function look() {
    if (document.body.dataset.drawn) done(document.body.dataset.drawn);
    else requestAnimationFrame(look);
})()";

/// Whose browser it is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum Maker {
    Chromium,
    Firefox,
    /// What Safari is made of.
    WebKit,
}

pub(crate) static MAKER: LazyLock<Maker> = LazyLock::new(|| match env::var("BROWSER").as_deref() {
    Err(_) | Ok("chromium") => Maker::Chromium,
    Ok("firefox") => Maker::Firefox,
    Ok("webkit") => Maker::WebKit,
    Ok(other) => panic!("BROWSER={other}: chromium, firefox or webkit"),
});

/// A browser, and the program that drives it.
pub(crate) struct Browser {
    driver: Child,
    port: u16,
    session: String,
}

impl Browser {
    /// A browser whose window is so large, in CSS pixels.
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self::speaking("en-US,en", width, height)
    }

    /// A browser whose user likes these languages, the first one most.
    pub(crate) fn speaking(languages: &str, width: u32, height: u32) -> Self {
        // Whoever is root has no sandbox; what is opened is our own.
        let arguments = ["--headless=new", "--no-sandbox", "--hide-scrollbars"];
        let preferred = json!({"intl.accept_languages": languages});
        let (program, wish) = match *MAKER {
            Maker::Chromium => (
                "chromedriver",
                json!({
                    "goog:loggingPrefs": {"browser": "ALL"},
                    "goog:chromeOptions": {"args": arguments, "prefs": preferred},
                }),
            ),
            Maker::Firefox => (
                "geckodriver",
                json!({"moz:firefoxOptions": {"args": ["-headless"], "prefs": preferred}}),
            ),
            Maker::WebKit => ("WebKitWebDriver", json!({})),
        };
        let free = TcpListener::bind(("127.0.0.1", 0)).expect("a port is free");
        let port = free.local_addr().expect("it has an address").port();
        drop(free);
        let mut driver = start(program);
        if *MAKER == Maker::WebKit {
            // It has no way to be without a screen.
            driver.envs(env::var("DISPLAY").map(|display| ("DISPLAY", display)));
        }
        let driver = driver
            .arg(format!("--port={port}"))
            .env("LC_ALL", format!("{}.UTF-8", languages[..2].to_owned()))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap_or_else(|error| panic!("{program} runs, which .ci/page installs: {error}"));
        while TcpStream::connect(("127.0.0.1", port)).is_err() {
            thread::sleep(Duration::from_millis(10));
        }
        let mut browser = Self { driver, port, session: String::new() };
        let session =
            browser.ask("POST", "/session", &json!({"capabilities": {"alwaysMatch": wish}}));
        browser.session = format!("/session/{}", text(&session["sessionId"]));
        browser.resize(width, height);
        browser
    }

    /// One exchange with the driver.
    fn ask(&self, method: &str, path: &str, body: &Value) -> Value {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("the driver listens");
        let body = if method == "POST" { body.to_string() } else { String::new() };
        let host = format!("127.0.0.1:{}", self.port);
        let head = format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\nContent-Length: ");
        let question = format!("{head}{}\r\n\r\n{body}", body.len());
        stream.write_all(question.as_bytes()).expect("the driver reads");
        // It keeps the connection, so the end is where the head says.
        let mut reader = BufReader::new(stream);
        let head = reader.by_ref().lines().map(|line| line.expect("the driver answers"));
        let head: Vec<String> = head.take_while(|line| !line.is_empty()).collect();
        let mut lengths = head.iter().filter_map(|line| {
            line.to_lowercase().strip_prefix("content-length:")?.trim().parse().ok()
        });
        let mut answer = vec![0; lengths.next().expect("a length")];
        reader.read_exact(&mut answer).expect("the whole answer");
        let answer: Value = serde_json::from_slice(&answer).expect("an answer in JSON");
        let value = answer["value"].clone();
        assert!(value["error"].is_null(), "{method} {path}: {}", value["message"]);
        value
    }

    fn post(&self, path: &str, body: &Value) -> Value {
        self.ask("POST", &format!("{}{path}", self.session), body)
    }

    /// What only Chromium's own protocol can do.
    pub(crate) fn tell(&self, command: &str, parameters: &Value) {
        self.post("/goog/cdp/execute", &json!({"cmd": command, "params": parameters}));
    }

    /// A browser with the page, at the address `#…`, when all is drawn.
    pub(crate) fn at(address: &str) -> Self {
        let browser = Self::new(1280, 800);
        browser.show(address);
        browser
    }

    pub(crate) fn show(&self, address: &str) {
        self.open(&format!("file://{}{address}", PAGE.display()));
        self.wait_for(DRAWN);
    }

    /// Opens all that is folded, and makes all figures live.
    pub(crate) fn unfold(&self) {
        self.run(
            "for (const folded of document.querySelectorAll('details')) folded.open = true;
            for (const place of document.querySelectorAll('article:not([hidden]) [data-figure]')) {
                if (!figures.has(place)) figures.set(place, new Figure(place));
                figures.get(place).refresh();
            }",
        );
    }

    pub(crate) fn resize(&self, width: u32, height: u32) {
        if *MAKER != Maker::Chromium {
            // What is around the page belongs to the window.
            let rest = self.run("return [outerWidth - innerWidth, outerHeight - innerHeight]");
            let around = |side: u32, at: usize| f64::from(side) + rest[at].as_f64().unwrap_or(0.0);
            let size = json!({"width": around(width, 0), "height": around(height, 1)});
            self.post("/window/rect", &size);
            return;
        }
        let metrics = json!({"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500});
        self.tell("Emulation.setDeviceMetricsOverride", &metrics);
    }

    /// Runs `script` in every page that is opened from now on, before the page's own.
    pub(crate) fn before_each_page(&self, script: &str) {
        self.tell("Page.addScriptToEvaluateOnNewDocument", &json!({"source": script}));
    }

    /// Opens an address anew, also when only its end differs.
    pub(crate) fn open(&self, address: &str) {
        self.post("/url", &json!({"url": "about:blank"}));
        self.post("/url", &json!({"url": address}));
    }

    /// What `script` returns, or the error that it throws.
    pub(crate) fn run(&self, script: &str) -> Value {
        let tried = format!("done((() => {{ {script}\n }})())");
        self.wait_for(&format!("try {{ {tried} }} catch (error) {{ done(`${{error}}`) }}"))
    }

    /// What `script` hands to `done`. It is one of the page's own: those of Firefox's driver see none of
    /// what the page calls by name.
    pub(crate) fn wait_for(&self, script: &str) -> Value {
        let own = format!(
            "{{ const done = (value = null) =>
                document.dispatchEvent(new CustomEvent('done', {{ detail: JSON.stringify(value) }}));
            {script}\n }}"
        );
        let begin = "const [text, answer] = arguments;
            document.addEventListener('done', ({ detail }) => answer(detail), { once: true });
            const own = document.createElement('script');
            own.textContent = text;
            document.documentElement.append(own);
            own.remove();";
        let answer = text(&self.post("/execute/async", &json!({"script": begin, "args": [own]})));
        serde_json::from_str(&answer).expect("an answer in JSON")
    }

    pub(crate) fn wait_until(&self, condition: &str) {
        let look = format!("if ({condition}) done(); else requestAnimationFrame(look);");
        self.wait_for(&format!("(function look() {{ {look} }})()"));
    }

    pub(crate) fn text(&self, script: &str) -> String {
        text(&self.run(script))
    }

    /// What the page says was copied, or is to be by hand, once this was pressed.
    pub(crate) fn copied(&self, id: &str) -> String {
        self.run(&format!("notice(); $('{id}').click()"));
        self.wait_until("!$('notice').hidden");
        let said = self.text("return $('notice').textContent");
        said.split_once(": ").expect("it says what was copied").1.to_owned()
    }

    /// Hands on the pointer or keyboard: see `Actions` of the WebDriver standard.
    pub(crate) fn act(&self, actions: &Value) {
        self.post("/actions", &json!({"actions": actions}));
    }

    /// Presses a key, or lets it go; named keys are the standard's private characters.
    pub(crate) fn key(&self, way: &str, key: &str) {
        let way = json!({"type": way, "value": key});
        self.act(&json!([{"type": "key", "id": "keyboard", "actions": [way]}]));
    }

    /// What the page's script drew on the canvas that `selector` names.
    pub(crate) fn canvas(&self, selector: &str) -> RgbImage {
        let canvas = format!("document.querySelector('{selector}')");
        self.picture(&format!("return {canvas}.toDataURL('image/png')"))
    }

    /// The picture whose data address `script` returns.
    pub(crate) fn picture(&self, script: &str) -> RgbImage {
        let address = self.text(script);
        let png = STANDARD.decode(address.split_once(',').expect("a data address").1);
        image::load_from_memory(&png.expect("base64")).expect("a PNG").to_rgb8()
    }

    /// What is seen of the first element that `selector` names.
    pub(crate) fn photo(&self, selector: &str) -> RgbImage {
        let seen = self.wait_for(&format!(
            "const place = document.querySelector('{selector}');
            // What comes into sight may move it.
            (function look(before) {{
                place.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                const {{ left, top, width, height }} = place.getBoundingClientRect();
                if (before === top) done([left, top, width, height]);
                else setTimeout(look, 300, top);
            }})()"
        ));
        let side = |place: usize| seen[place].as_f64().expect("a length") as u32;
        let png = text(&self.ask("GET", &format!("{}/screenshot", self.session), &Value::Null));
        let whole = image::load_from_memory(&STANDARD.decode(png).expect("base64"));
        whole.expect("a PNG").crop_imm(side(0), side(1), side(2), side(3)).to_rgb8()
    }

    /// Nothing is in the console, of errors and warnings, as far as the browser tells.
    #[track_caller]
    pub(crate) fn is_quiet(&self) {
        if *MAKER != Maker::Chromium {
            return;
        }
        assert_eq!(self.post("/se/log", &json!({"type": "browser"})), json!([]));
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        // With a slash at its end the browser would be left behind. Chromium goes with its driver.
        if !std::thread::panicking() || *MAKER != Maker::Chromium {
            self.ask("DELETE", &self.session, &Value::Null);
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_else(|| panic!("text instead of {value}")).to_owned()
}
