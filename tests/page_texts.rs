//! What the page says, in which language, and to whom.

use std::fs;
use std::path::Path;

use lecture::PROGRAMS;
use serde_json::Value;
use serde_json::json;
use tests::portuguese;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::opened;
use crate::quiet;
use crate::show;
use crate::unfold;

/// What can be read on the page that is no code: texts, names for screen readers, and hints.
const TEXTS: &str = "
    const texts = [document.title];
    for (const place of document.body.querySelectorAll('*')) {
        if (place.closest('script, style, noscript, pre, code, strong, [hidden], #language, .control label, .control output, option')) continue;
        texts.push(place.getAttribute('aria-label'), place.title);
        for (const node of place.childNodes) if (node.nodeType === 3) texts.push(node.data.replace(/«[^»]*»/g, '').trim());
    }
    return texts.filter((text) => text)";

/// The texts that stand on the page and are one of `foreign`; long ones also as part of another text.
fn found(browser: &Browser, foreign: &[&str]) -> Vec<String> {
    let texts = browser.run(TEXTS);
    let texts = texts.as_array().expect("texts").iter().filter_map(Value::as_str);
    let is_foreign = |text: &&str| {
        let stands = |foreign: &&&str| {
            foreign.len() >= 12 && foreign.contains(' ') && text.contains(**foreign)
        };
        foreign.contains(text) || foreign.iter().any(|foreign| stands(&foreign))
    };
    texts.filter(is_foreign).map(str::to_owned).collect()
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn it_speaks_the_language_of_the_browser_or_the_one_chosen() {
    let catalogue = portuguese().catalogue();
    // What one language has in common with the other tells nothing.
    let pairs = || catalogue.iter().filter(|(english, portuguese)| english != portuguese);
    let english: Vec<&str> = pairs().map(|(english, _)| &**english).collect();
    let portuguese: Vec<&str> = pairs().map(|(_, portuguese)| &**portuguese).collect();
    for (languages, chosen) in
        [("pt-BR,en", "pt-BR"), ("en-US,pt-BR", "en"), ("de,pt,en", "pt-BR"), ("de", "en")]
    {
        let browser = Browser::speaking(languages, 1280, 800);
        let mut chosen = chosen;
        for (index, program) in PROGRAMS.iter().enumerate() {
            show(
                &browser,
                &format!("#{}&pixel=480,300&k_s=x&{}", &program.name[..6], "a=1&".repeat(index)),
            );
            for _ in 0..2 {
                let lang = browser.text("return document.documentElement.lang");
                assert_eq!(lang, chosen, "{languages}");
                let foreign = if chosen == "en" { &portuguese } else { &english };
                let found = found(&browser, foreign);
                assert!(found.is_empty(), "{} in {chosen}: {found:#?}", program.name);
                browser.run("$('language').click()");
                browser.wait_for(DRAWN);
                chosen = if chosen == "en" { "pt-BR" } else { "en" };
            }
        }
        quiet(&browser);
    }
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_is_drawn_speaks_too_and_the_address_keeps_the_language() {
    let browser = opened(1280, 800, "#step06&pixel=480,300&outside=on");
    let english = browser.canvas("#now");
    let link = "$('link').click(); return $('notice').textContent";
    assert!(!browser.text(link).contains("language"));
    browser.run("$('language').click()");
    browser.wait_for(DRAWN);
    let portuguese = browser.canvas("#now");
    assert!(english != portuguese);
    let link = browser.text(link);
    let (copied, link) = link.split_once(": ").expect("it says what was copied");
    assert_eq!(copied, "Copiado");
    browser.open(link);
    browser.wait_for(DRAWN);
    assert_eq!(browser.text("return document.documentElement.lang"), "pt-BR", "{link}");
    assert!(browser.canvas("#now") == portuguese);
    quiet(&browser);
}

#[test]
#[ignore = "needs Chromium, the wasm target and axe-core"]
fn everybody_can_use_it() {
    let folder = std::env::var("AXE").expect(".ci/page says where axe-core is");
    let axe = fs::read_to_string(Path::new(&folder).join("package/axe.min.js")).expect("axe-core");
    let browser = Browser::new(1280, 800);
    // The colours are the scheme's, the layout is the width's.
    for (scheme, width) in [("dark", 1280), ("light", 360)] {
        let scheme = json!({"features": [{"name": "prefers-color-scheme", "value": scheme}]});
        browser.tell("Emulation.setEmulatedMedia", &scheme);
        browser.resize(width, 640);
        for program in PROGRAMS {
            show(&browser, &format!("#{}&pixel=440,200&handles=on", &program.name[..6]));
            browser.run("press('k')");
            unfold(&browser);
            browser.run(&axe);
            let found = browser.wait_for(
                "axe.run().then(({ violations }) => done(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 200)).slice(0, 3)])))",
            );
            assert_eq!(found, json!([]), "{} {scheme} {width}", program.name);
        }
    }
}
