//! The equations of the slides as browsers set them.

use tests::prelude::*;

use crate::browser::Browser;

/// How high a row of the sheet is, and how wide its columns are, in pixels.
const ROW: u32 = 180;
const COLUMNS: [u32; 2] = [520, 820];

#[test]
#[ignore = "needs Chromium and the wasm target"]
fn no_equation_is_cut_or_scrolled_up_and_down() {
    let browser = Browser::new(1280, 800);
    for width in [390, 1280] {
        browser.resize(width, 800);
        for name in STEPS {
            browser.show(&format!("#{}&pixel=440,200", &name[..6]));
            browser.unfold();
            let high = browser.run(
                "const boxes = [...document.querySelectorAll('.math, .math *')];
                const scrolls = (box) => getComputedStyle(box).overflowY !== 'visible';
                const seen = boxes.filter((box) => box.clientHeight && scrolls(box));
                const cut = seen.filter((box) => box.scrollHeight > box.clientHeight);
                return [seen.length > 0, cut.map((box) => box.textContent)]",
            );
            assert_eq!(high, json!([true, []]), "{name} {width}");
        }
    }
}

/// A picture on the sheet, no larger than its place.
fn put(sheet: &mut RgbImage, picture: &RgbImage, (left, top): (u32, u32), width: u32) {
    let (wide, high) = (f64::from(picture.width()), f64::from(picture.height()));
    let part = (f64::from(width) / wide).min(f64::from(ROW) / high).min(1.0);
    let [wide, high] = [wide, high].map(|side| (part * side) as u32);
    let small = imageops::resize(picture, wide, high, imageops::FilterType::Triangle);
    imageops::overlay(sheet, &small, left.into(), (top + (ROW - high) / 2).into());
}

#[test]
#[ignore = "draws a sheet to be looked at, and needs Chromium and the wasm target"]
fn draw_the_sheet() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("equations.png");
    let [left, right] = COLUMNS;
    let mut sheet = RgbImage::new(2 * left + right, ROW * DECK.len() as u32);
    let browser = Browser::new(820, 1600);
    let all = programs();
    for (row, (index, equation)) in DECK.into_iter().enumerate() {
        let Program { name, idea, .. } = &all[index];
        let mut told = idea.lines().filter_map(|line| line.strip_prefix("  "));
        let key = latex(equation).key();
        let place = told.position(|line| latex(line).key().contains(&key)).expect("it is there");
        let own = idea.lines().filter_map(|line| line.strip_prefix("  ")).nth(place).expect("it");
        let top = (row as u32 * ROW) as f32;
        let mut canvas = Canvas::new(&mut sheet);
        let words = Font::wrap(17.0, equation, left as f32 - 20.0);
        for (line, text) in words.iter().enumerate() {
            let at = (10.0, top + 10.0 + 20.0 * line as f32);
            canvas.text(at, Anchor::TopLeft, 17.0, Ink::grey(200), text);
        }
        let set = Boxed::display(&latex(own), 28.0, left as f32 - 20.0);
        let baseline = top + (ROW as f32 - set.height()) / 2.0 + set.above;
        set.draw(&mut canvas, (left as f32 + 10.0, baseline), Ink::grey(238), false);
        canvas.fill(Area::new(0.0, top, (2 * left + right) as f32, 1.0), Ink::grey(90));
        if row == 0 || DECK[row - 1].0 != index {
            browser.show(&format!("#{}&pixel=440,200", &name[..6]));
        }
        browser.run(&format!(
            "for (const old of document.querySelectorAll('#drawn')) old.removeAttribute('id');
            formula().querySelectorAll('.math > div')[{place}].id = 'drawn'"
        ));
        put(&mut sheet, &browser.photo("#drawn"), (2 * left, row as u32 * ROW), right);
    }
    sheet.save(&file).expect("it is written");
    println!("{}", file.display());
}
