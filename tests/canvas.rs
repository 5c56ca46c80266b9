//! What is drawn over a picture: nothing beyond its clip, dashes, and text that can be read. Where each
//! shape is, the committed pictures of `vectors` hold.

use tests::prelude::*;

const RED: Ink = Ink::new(255, 80, 60);

/// Letters that the slides, the panels and the messages need.
const LETTERS: &str =
    "ãçéõáíóúâêôàÃÇÉÕαβγδεθλρσφωΔΣ√−₀₁₂²³⁻·×≤≥∞‖∑½→←↑↓▸▾°«»…⊙⊗kₐkₛ|()[]=+/0123456789";

fn blank(width: u32, height: u32, grey: u8) -> RgbImage {
    RgbImage::from_pixel(width, height, Rgb([grey; 3]))
}

fn drawn(width: u32, height: u32, draw: impl FnOnce(&mut Canvas<'_>)) -> RgbImage {
    let mut picture = blank(width, height, 0);
    draw(&mut Canvas::new(&mut picture));
    picture
}

fn inked(picture: &RgbImage) -> Vec<(u32, u32)> {
    let pixels = picture.enumerate_pixels();
    pixels.filter(|(.., pixel)| pixel.0 != [0; 3]).map(|(col, row, _)| (col, row)).collect()
}

/// Draws one of everything that a clip only cuts.
fn draw_all(canvas: &mut Canvas<'_>, a: (f32, f32), b: (f32, f32), length: f32, text: &str) {
    let area = Area::new(a.0, a.1, b.0, b.1);
    let source = RgbImage::from_fn(7, 5, |col, row| Rgb([200, 30 * col as u8, 40 * row as u8]));
    canvas.fill(area, RED);
    canvas.fill(area, RED.with_alpha(99));
    canvas.border(area, length, RED);
    canvas.picture(&source, area);
    canvas.line(a, b, length, RED);
    canvas.dashed(a, b, length, Ink::WHITE);
    canvas.arrow(a, b, length, RED);
    canvas.arrow(a, a, length, RED);
    canvas.disc(a, length, RED);
    canvas.ring(b, length, a.0, RED);
    canvas.triangle([a, b, (b.0, a.1)], RED.with_alpha(120));
    canvas.pixel(a.0 as usize, a.1 as usize, RED);
    canvas.text(a, Anchor::Center, length, RED, text);
    canvas.text_within(a, Anchor::TopRight, length, RED, text, b.0);
}

/// Numbers that a canvas may get: in a picture, far outside, and none.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => -30.0_f32..90.0,
        1 => -1e6_f32..1e6,
        1 => select(&[0.0, 0.5, -0.5, 1e-30, f32::MAX, f32::MIN][..]),
        1 => select(&[f32::INFINITY, f32::NEG_INFINITY, f32::NAN][..]),
    ]
}

proptest! {
    #![proptest_config(config(256))]

    #[test]
    fn nothing_is_drawn_outside_the_clip_and_inside_it_what_would_be_drawn_without(
        (width, height) in (1_u32..70, 1_u32..50),
        clip in (number(), number(), number(), number()),
        a in (number(), number()),
        b in (number(), number()),
        length in number(),
        text in "[a-zα ₁√\n\u{0}]{0,12}",
    ) {
        let (mut picture, mut whole) = (blank(width, height, 77), blank(width, height, 77));
        draw_all(&mut Canvas::new(&mut whole), a, b, length, &text);
        let mut canvas = Canvas::new(&mut picture);
        let mut clipped = canvas.clipped(Area::new(clip.0, clip.1, clip.2, clip.3));
        let inside = clipped.clip();
        draw_all(&mut clipped, a, b, length, &text);
        for (col, row, pixel) in picture.enumerate_pixels() {
            let expected = match inside.contains((col as f32 + 0.5, row as f32 + 0.5)) {
                true => whole.get_pixel(col, row).0,
                false => [77; 3],
            };
            prop_assert!(off(pixel.0, expected) <= 2, "({}, {}) of {:?}", col, row, inside);
        }
        // What moves into the clip stays there.
        let mut canvas = Canvas::new(&mut picture);
        let mut clipped = canvas.clipped(inside);
        clipped.label(b, Anchor::BottomLeft, length, RED, &text);
        for line in Font::wrap(length, &text, a.0) {
            clipped.label(a, Anchor::Left, length, RED, &line);
        }
        for (col, row, pixel) in picture.enumerate_pixels() {
            let is_inside = inside.contains((col as f32 + 0.5, row as f32 + 0.5));
            prop_assert!(is_inside || pixel.0 == [77; 3], "a label at ({}, {})", col, row);
        }
    }

    #[test]
    fn a_paragraph_keeps_its_words_and_its_width(
        text in "[a-z]{1,9}( [a-zãé]{1,30}){0,20}", size in 6.0_f32..40.0, width in 1.0_f32..400.0,
    ) {
        let lines = Font::wrap(size, &text, width);
        let solid = |text: &str| text.replace(' ', "");
        prop_assert_eq!(solid(&lines.concat()), solid(&text));
        for line in &lines {
            let fits = Font::width(size, line) <= width * (1.0 + 1e-6);
            prop_assert!(fits || line.chars().count() == 1, "{:?} in {}", line, width);
        }
        let widest = text.split(' ').map(|word| Font::width(size, word)).fold(0.0, f32::max);
        if widest <= width {
            prop_assert_eq!(lines.join(" "), text);
            for pair in lines.windows(2) {
                let next = pair[1].split(' ').next().unwrap_or_default();
                let longer = format!("{} {next}", pair[0]);
                prop_assert!(Font::width(size, &longer) > width, "{:?} left room", pair);
            }
        }
    }
}

#[test]
fn a_line_is_dashed_from_its_start_and_has_gaps_of_its_width() {
    // Wherever it comes in.
    for left in [10.0, -1.0, -5.5, -1000.0] {
        let picture =
            drawn(120, 20, |canvas| canvas.dashed((left, 10.0), (110.0, 10.0), 2.0, Ink::WHITE));
        // A period is 13 pixels, a dash 6 with a round end of 1 on either side.
        for col in (0..100).filter(|col| *col as f32 >= left) {
            let along = (col as f32 + 0.5 - left).rem_euclid(13.0);
            let unsure = [7.0, 12.0].iter().any(|end| (along - end).abs() < 0.8);
            let is_dash = picture.get_pixel(col, 10).0[0] > 128;
            let expected = !(7.0..12.0).contains(&along);
            assert!(unsure || is_dash == expected, "{col} of a line from {left}");
        }
    }
}

#[test]
fn the_font_has_every_letter_and_tells_them_apart() {
    let missing: String = LETTERS.chars().filter(|letter| !Font::has(*letter)).collect();
    assert_eq!((missing.as_str(), Font::has('\u{10FFFF}')), ("", false));
    for (pair, size) in ["αa", "lI", "l1", "l|", "γy", "νv", "₁1", "−-", "×x"]
        .into_iter()
        .flat_map(|pair| [12.0, 15.0, 30.0].map(|size| (pair, size)))
    {
        let letters = pair.chars().map(|letter| {
            let (at, letter) = ((30.0, 30.0), letter.to_string());
            drawn(60, 60, |canvas| canvas.text(at, Anchor::Center, size, Ink::WHITE, &letter))
        });
        let [a, b] = &letters.collect::<Vec<_>>()[..] else { panic!("{pair}") };
        let apart: u32 = a.iter().zip(b.iter()).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
        let ink: u32 = a.iter().map(|sample| u32::from(*sample)).sum();
        assert!(f64::from(apart) > 0.2 * f64::from(ink), "{pair} at {size} px");
    }
}

#[test]
fn text_that_is_too_wide_is_cut_and_a_size_that_is_none_leaves_none() {
    let text = "intensidade da luz";
    assert_eq!(Font::cut(15.0, text, Font::width(15.0, text)), text);
    for width in 0..Font::width(15.0, text) as usize {
        let cut = Font::cut(15.0, text, width as f32);
        assert!(Font::width(15.0, &cut) <= width as f32);
        match cut.strip_suffix('…') {
            Some(start) => assert!(text.starts_with(start) && !start.ends_with(' ')),
            None => assert!(width as f32 <= Font::width(15.0, "…") && cut.is_empty()),
        }
    }
    assert!(Font::cut(15.0, text, 60.0).chars().count() > 5);
    assert_eq!(Font::wrap(15.0, "a\n\nb  c", f32::INFINITY), ["a", "", "b c"]);
    for size in [0.0, -3.0, f32::NAN, f32::NEG_INFINITY] {
        assert_eq!([Font::width(size, "texto"), Font::line_height(size)], [0.0; 2]);
    }
    assert_eq!(Font::width(1e9, "texto"), Font::width(Font::MAX_SIZE, "texto"));
}

#[test]
fn a_label_has_contrast_on_any_picture_and_is_moved_inside() {
    assert!((Ink::BLACK.contrast(Ink::WHITE) - 21.0).abs() < 1e-4, "as WCAG computes it");
    assert!((Ink::WHITE.contrast(Ink::grey(118)) - 4.54).abs() < 0.01);
    assert_eq!(Ink::encoded(Color::new(1.0, 0.0, 2.0)), Ink::new(255, 0, 255));
    let (at, text) = ((110.0, 50.0), "αg₁ n·l");
    for size in [15.0, 24.0, 60.0] {
        let letters =
            drawn(260, 100, |canvas| canvas.text(at, Anchor::Center, size, Ink::WHITE, text));
        let covered = |(col, row): (u32, u32)| letters.get_pixel(col, row).0[0];
        let solid = inked(&letters).into_iter().filter(|at| covered(*at) >= 128);
        let beside = solid.flat_map(|(col, row)| {
            [(col - 1, row), (col + 1, row), (col, row - 1), (col, row + 1)]
        });
        let edges: Vec<(u32, u32)> = beside.filter(|at| covered(*at) == 0).collect();
        assert!(edges.len() > 20, "edges are looked at");
        let inks = [Ink::WHITE, Ink::BLACK, RED, Ink::grey(118), Ink::new(110, 178, 255)];
        for (ground, ink) in
            [0, 64, 128, 192, 255].into_iter().flat_map(|ground| inks.map(|ink| (ground, ink)))
        {
            let mut label = blank(260, 100, ground);
            Canvas::new(&mut label).label(at, Anchor::Center, size, ink, text);
            for (col, row) in &edges {
                let [red, green, blue] = label.get_pixel(*col, *row).0;
                let contrast = ink.contrast(Ink::new(red, green, blue));
                assert!(contrast >= 4.5, "{ink:?} on {ground}, {size} px: {contrast}");
            }
        }
    }
    let label =
        |at: (f32, f32), anchor| drawn(120, 60, |canvas| canvas.label(at, anchor, 20.0, RED, "HH"));
    assert_eq!(label((119.0, 59.0), Anchor::TopLeft), label((120.0, 60.0), Anchor::BottomRight));
    assert!(inked(&label((190.0, 30.0), Anchor::Left)).is_empty(), "nor what is outside");
}
