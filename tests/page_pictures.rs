//! What the page draws in a browser is what the steps and their figures draw.

use tests::prelude::*;

use crate::browser::Browser;
use crate::browser::DRAWN;
use crate::browser::PAGE;

/// How many channels of `found` differ from `expected` at all, and by how much at most.
fn differences(expected: &RgbImage, found: &RgbImage) -> (usize, u8) {
    assert_eq!(expected.dimensions(), found.dimensions());
    let pairs = expected.iter().zip(found.iter());
    let each = pairs.map(|(a, b)| a.abs_diff(*b)).filter(|difference| *difference > 0);
    each.fold((0, 0), |(count, most), difference| (count + 1, most.max(difference)))
}

fn is_committed(browser: &Browser, name: &str, projection: &str) {
    browser.show(&format!("#{}&camera={projection}&size=240x135", &name[..6]));
    let path = root().join("tests/pictures").join(format!("{name}_{projection}.png"));
    let (count, most) = differences(&read_picture(&path), &browser.canvas("#now"));
    assert!(count <= 90 && most <= 1, "{name}, {projection}: {count} channels, by up to {most}");
}

/// The controls that leave the picture as it is at both ends, and those that are not put back.
const STILL: &str = "
    const drawn = () => new Promise((resolve) => (function look() {
        if (document.body.dataset.drawn) resolve($('now').toDataURL());
        else requestAnimationFrame(look);
    })());
    (async () => {
        const [start, still] = [await drawn(), []];
        for (const { name } of state.groups.flatMap(({ settings }) => settings)) {
            let moves = false;
            for (const end of [0, 1]) {
                const input = $(`input-${name}`);
                if (input.type === 'checkbox') input.click();
                else if (input.type === 'range') input.value = end;
                else input.selectedIndex = end * (input.options.length - 1);
                input.dispatchEvent(new Event(input.type === 'range' ? 'input' : 'change'));
                moves ||= await drawn() !== start;
                $(`control-${name}`).querySelector('button').click();
                if (await drawn() !== start) still.push(`${name} is not reset`);
            }
            if (!moves) still.push(name);
        }
        done(still);
    })()";

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_step_shows_the_committed_picture_and_each_control_moves_it() {
    let browser = Browser::new(1280, 800);
    for name in STEPS {
        View::PROJECTIONS.iter().for_each(|projection| is_committed(&browser, name, projection));
        browser.show(&format!("#{}&size=240x135", &name[..6]));
        // A direction knows no distance, a sphere at the target looks alike from everywhere, and so
        // does a triangle in the target's plane with both cameras.
        let expected = match name {
            "step01_rays" => json!(["distance"]),
            "step02_sphere" => json!(["azimuth", "elevation"]),
            "step03_triangle" => json!(["camera"]),
            _ => json!([]),
        };
        assert_eq!(browser.wait_for(STILL), expected, "{name}");
    }
    browser.is_quiet();
    let size = fs::metadata(&*PAGE).expect("the page").len();
    // One megabyte for seven steps.
    let most = 720_000 + 40_000 * STEPS.len() as u64;
    assert!(size <= most, "it has {size} bytes, and may have {most}");
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn the_divider_shows_the_step_before() {
    let browser = Browser::at("#step06&size=240x135");
    let before = browser.canvas("#now");
    browser.show("#step07&size=240x135");
    let now = browser.canvas("#now");
    let is_divided = |left: u32| {
        browser.canvas("#now").enumerate_pixels().all(|(col, row, pixel)| {
            pixel == if col < left { &before } else { &now }.get_pixel(col, row)
        })
    };
    // All of it as long as the button is held.
    let hold = |event| {
        format!(
            "const hold = $('hold'); hold.setPointerCapture = () => {{}}; hold.dispatchEvent(new PointerEvent('{event}'))"
        )
    };
    let slide = "$('divider').value = 0.25; $('divider').dispatchEvent(new Event('input'))";
    for (done, left) in [
        ("$('divide').click()".to_owned(), 120),
        (slide.to_owned(), 60),
        (hold("pointerdown"), 240),
        (hold("pointerup"), 60),
    ] {
        browser.run(&done);
        browser.wait_for(DRAWN);
        assert!(before != now && is_divided(left), "{done}");
    }
    let edge = browser.run("return [$('edge').hidden, $('edge').style.left]");
    assert_eq!(edge, json!([false, "25%"]));
    // What is saved has both halves.
    let saved = browser.picture(
        "let saved;
        HTMLAnchorElement.prototype.click = function () { saved = this.href };
        $('save').click();
        return saved",
    );
    assert!(saved == browser.canvas("#now"));
    // To where there is no step before, while a picture with both is drawn quickly.
    let workers = browser.run("return workers.length");
    browser.run("stage.cost = 1; moved({ orbit: [1, 0] }); act({ step: 1 })");
    browser.wait_for(DRAWN);
    let shown = "return [state.step, $('edge').hidden, workers.length]";
    assert_eq!(browser.run(shown), json!([1, true, workers]));
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn each_figure_is_live() {
    let browser = Browser::at("#step01");
    browser.run("for (const it of document.querySelectorAll('article')) it.hidden = false");
    browser.unfold();
    for (name, figure) in FIGURES {
        let place = format!("document.querySelector('article[lang=en] .{name}')");
        let drawn = || {
            browser.run(&format!("{place}.scrollIntoView({{ behavior: 'instant' }})"));
            browser.wait_until(&format!("{place}.dataset.drawn"));
            browser.canvas(&format!("article[lang=en] .{name} canvas"))
        };
        let (found, figure) = (drawn(), figure());
        let shown = Setup::new(figure.make);
        let mut expected = picture_of(&shown, figure.size.width(), figure.size.height());
        shown.draw_over(&*shown.view().camera(figure.size.aspect()), &mut expected);
        // Which points shadow themselves is decided by the last bit of a number.
        if name != "acne" {
            let (count, most) = differences(&expected, &found);
            assert!(count <= 300 && most <= 16, "{name}: {count} channels, by up to {most}");
        }
        browser.run(&format!(
            "{place}.dataset.drawn = '';
            const input = {place}.parentNode.querySelector('.controls input[type=range]');
            input.value = 1;
            input.dispatchEvent(new Event('input'))"
        ));
        assert!(drawn() != found, "{name} does not move");
    }
    browser.is_quiet();
}

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn what_the_browser_lacks_is_done_without() {
    let browser = Browser::new(1280, 800);
    browser.before_each_page("delete window.Worker");
    is_committed(&browser, STEPS[6], "perspective");
    // What is not copied is not said to be.
    for (copies, said) in [(true, "Copied: "), (false, "To copy by hand: ")] {
        browser.run(&format!("document.execCommand = () => {copies}; navigator.clipboard.writeText = () => Promise.reject()"));
        browser.copied("link");
        assert!(browser.text("return $('notice').textContent").starts_with(said), "{said}");
    }
    browser.before_each_page("delete window.WebAssembly");
    browser.open(&format!("file://{}", PAGE.display()));
    browser.wait_until("!$('broken').hidden");
    let seen = "return document.querySelectorAll('article[lang=en]:not([hidden])').length";
    // The cover is one, too.
    assert_eq!(browser.run(seen), json!(1 + STEPS.len()));
    let notice = browser.text("$('language').click(); return $('broken').textContent");
    assert!(notice.starts_with("As imagens não podem"), "{notice}");
    assert_eq!(browser.run(seen), json!(0));
    let still = "return getComputedStyle(document.querySelector('.four_views')).backgroundImage";
    let still = browser.text(still);
    assert!(still.starts_with("url(\"data:image/jpeg;base64,"), "{still}");
}
