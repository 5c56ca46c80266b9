//! What the page says in a browser, in which language, and to whom.

use serde_json::Value;
use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;

/// What can be read on the page that is no code: texts, names for screen readers, and hints.
const TEXTS: &str = "
    const texts = [document.title];
    for (const place of document.body.querySelectorAll('*')) {
        if (place.closest('script, style, noscript, pre, code, strong, [hidden], #language, a.try, .control label, .control output, option')) continue;
        // A control's name is the same in all languages.
        texts.push(place.name ? '' : place.getAttribute('aria-label'), place.title);
        for (const node of place.childNodes) if (node.nodeType === 3) texts.push(node.data.replace(/«[^»]*»/g, '').trim());
    }
    return texts.filter((text) => text)";

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn it_speaks_the_language_of_the_browser_or_the_one_chosen() {
    // What one language has in common with the other tells nothing.
    let pairs: Vec<(String, String)> =
        portuguese().catalogue().into_iter().filter(|pair| pair.0 != pair.1).collect();
    for (languages, mut chosen) in
        [("pt-BR,en", "pt-BR"), ("en-US,pt-BR", "en"), ("de,pt,en", "pt-BR"), ("de", "en")]
    {
        let browser = Browser::speaking(languages, 1280, 800);
        for (index, name) in STEPS.iter().enumerate() {
            let wrong = "a=1&".repeat(index);
            browser.show(&format!("#{}&pixel=480,300&k_s=x&{wrong}", &name[..6]));
            for _ in 0..2 {
                assert_eq!(browser.text("return document.documentElement.lang"), chosen);
                let texts = browser.run(TEXTS);
                for text in texts.as_array().expect("texts").iter().filter_map(Value::as_str) {
                    let is_foreign = pairs.iter().any(|(english, portuguese)| {
                        let foreign = if chosen == "en" { portuguese } else { english };
                        let is_long = foreign.len() >= 12 && foreign.contains(' ');
                        text == foreign || is_long && text.contains(&**foreign)
                    });
                    assert!(!is_foreign, "{name} in {chosen}: {text}");
                }
                browser.run("$('language').click()");
                browser.wait_for(DRAWN);
                chosen = if chosen == "en" { "pt-BR" } else { "en" };
            }
        }
        // A link keeps the language, where it is not the browser's own.
        assert!(!browser.copied("link").contains("language"));
        browser.run("$('language').click()");
        assert!(browser.copied("link").contains("language"));
        browser.is_quiet();
    }
}

#[test]
#[ignore = "needs Chromium, the wasm target and axe-core"]
fn everybody_can_use_it() {
    let folder = std::env::var("AXE").expect(".ci/page says where axe-core is");
    let axe = source(Path::new(&folder).join("package/axe.min.js"));
    let browser = Browser::new(1280, 800);
    // The colours are the scheme's, the layout is the width's.
    for (scheme, width) in [("dark", 1280), ("light", 360), ("dark", 1920)] {
        let scheme = json!({"features": [{"name": "prefers-color-scheme", "value": scheme}]});
        browser.tell("Emulation.setEmulatedMedia", &scheme);
        browser.resize(width, 640);
        browser.show("");
        for name in std::iter::once("the cover").chain(STEPS) {
            if STEPS.contains(&name) {
                browser.show(&format!("#{}&pixel=440,200&handles=on", &name[..6]));
                // A line as a picture, with its curve, and another altered.
                browser.run("for (const key of 'kqjuw') press(key)");
                browser.run("press('m')");
                browser.unfold();
            }
            // There is nothing beyond the edge.
            let wide = browser.run("return document.documentElement.scrollWidth - innerWidth");
            assert_eq!(wide, json!(0), "{name} {width}");
            if width <= 1280 {
                browser.run(&axe);
                let found = browser.wait_for(
                    "axe.run().then(({ violations }) => done(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 200)).slice(0, 3)])))",
                );
                assert_eq!(found, json!([]), "{name} {scheme} {width}");
            }
        }
    }
}
