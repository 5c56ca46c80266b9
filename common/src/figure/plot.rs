use std::convert::Infallible;
use std::ops::Range;

use plotters::chart::ChartBuilder;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::drawing::IntoDrawingArea;
use plotters::series::LineSeries;
use plotters::style::IntoFont;
use plotters::style::RGBColor;
use plotters::style::ShapeStyle;
use plotters_backend::BackendColor;
use plotters_backend::BackendCoord;
use plotters_backend::BackendStyle;
use plotters_backend::BackendTextStyle;
use plotters_backend::DrawingBackend;
use plotters_backend::DrawingErrorKind;
use plotters_backend::text_anchor::HPos;
use plotters_backend::text_anchor::VPos;

use super::Canvas;
use super::canvas::GLYPH;
use super::canvas::magnification;
use crate::Color;

// The eight bits a channel of these colours are linear, as everything is on a canvas.
const INK: RGBColor = RGBColor(200, 200, 200);
const GRID: RGBColor = RGBColor(10, 11, 14);
const FIRST: Color = Color::new(1.0, 0.45, 0.05);
const LAST: Color = Color::new(0.05, 0.3, 1.0);

/// A plot's width and height, in letters, are at least these.
const MIN_LETTERS: usize = 20;
const MIN_LINES: usize = 8;

/// In how many pieces a curve is drawn.
const PIECES: u16 = 250;

impl Canvas<'_> {
    /// Fills the panel with a plot: what is along the x axis and its range, the range of the y
    /// axis, and a name and a function for each curve.
    pub fn plot<F: Fn(f32) -> f32>(
        &mut self, x_name: &str, x: Range<f32>, y: Range<f32>, curves: &[(String, F)],
    ) {
        let labels = self.magnification;
        let wide = self.width() as f32 / (MIN_LETTERS * GLYPH.0) as f32;
        let high = self.height() as f32 / (MIN_LINES * GLYPH.1) as f32;
        self.magnification = magnification(wide.min(high)).min(labels);
        // Without room for a letter there is none for axes.
        if self.text_size("0").0 > 0
            && let Err(error) = plot(self, x_name, x, y, curves)
        {
            self.text((0.5, 0.5), Color::ONE, &error.to_string());
        }
        self.magnification = labels;
    }
}

fn plot<F: Fn(f32) -> f32>(
    canvas: &mut Canvas<'_>, x_name: &str, x: Range<f32>, y: Range<f32>, curves: &[(String, F)],
) -> Result<(), DrawingAreaErrorKind<Infallible>> {
    let (letter, line) = canvas.text_size("0");
    let names = curves.iter().map(|(name, _)| canvas.text_size(name).0);
    let right = (names.max().unwrap_or(0) + 3 * letter) as i32;
    let (letter, line) = (letter as i32, line as i32);
    let canvas_width = canvas.width() as i32;
    let color = |index: usize| FIRST.lerp(LAST, index as f32 / (curves.len().max(2) - 1) as f32);
    for (index, (name, _)) in curves.iter().enumerate() {
        // Off the panel, if a name is wider than that.
        let left = (canvas_width - right + 2 * letter) as f32;
        let top = (line + line * 5 / 4 * index as i32) as f32;
        canvas.write(left, top, (0.0, 0.0), color(index), name);
    }
    let font = || ("monospace", line).into_font().color(&INK);
    let number = |number: &f32| {
        let text = format!("{number:.2}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    let area = Paper(canvas).into_drawing_area();
    let mut chart = ChartBuilder::on(&area)
        .margin_top(line)
        .margin_right(right)
        .x_label_area_size(5 * line / 2)
        .y_label_area_size(5 * letter)
        .build_cartesian_2d(x.clone(), y)?;
    chart
        .configure_mesh()
        .axis_style(INK)
        .bold_line_style(GRID)
        .max_light_lines(0)
        .x_labels((canvas_width / (6 * letter)) as usize)
        .y_labels(6)
        .x_label_formatter(&number)
        .y_label_formatter(&number)
        .label_style(font())
        .axis_desc_style(font())
        .x_desc(x_name)
        .draw()?;
    for (index, (_, function)) in curves.iter().enumerate() {
        let [red, green, blue] = color(index).to_array().map(|channel| (255.0 * channel) as u8);
        let style = ShapeStyle::from(RGBColor(red, green, blue)).stroke_width(2);
        let at = |piece| x.start + (x.end - x.start) * f32::from(piece) / f32::from(PIECES);
        let points = (0..=PIECES).map(at).map(|x| (x, function(x)));
        chart.draw_series(LineSeries::new(points, style))?;
    }
    area.present()
}

/// A canvas as plotters draws on it. Lines outside the rows to be filled cost next to nothing.
struct Paper<'a, 'b>(&'a mut Canvas<'b>);

fn linear(BackendColor { rgb: (red, green, blue), .. }: BackendColor) -> Color {
    Color::from([red, green, blue].map(f32::from)) / 255.0
}

impl DrawingBackend for Paper<'_, '_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.0.width() as u32, self.0.height() as u32)
    }

    fn ensure_prepared(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn present(&mut self) -> Result<(), DrawingErrorKind<Infallible>> {
        Ok(())
    }

    fn draw_pixel(
        &mut self, (x, y): BackendCoord, color: BackendColor,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        if let (Ok(col), Ok(row)) = (x.try_into(), y.try_into()) {
            self.0.blend(col, row, linear(color), color.alpha as f32);
        }
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self, path: I, style: &S,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let (color, thickness) = (style.color(), style.stroke_width() as f32);
        let mut path = path.into_iter().map(|(x, y)| (x as f32 + 0.5, y as f32 + 0.5));
        let Some(mut from) = path.next() else { return Ok(()) };
        for to in path.filter(|_| color.alpha > 0.0) {
            self.0.stroke(from, to, thickness, linear(color));
            from = to;
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self, text: &str, style: &S, (x, y): BackendCoord,
    ) -> Result<(), DrawingErrorKind<Infallible>> {
        let anchor = style.anchor();
        let across = match anchor.h_pos {
            HPos::Left => 0.0,
            HPos::Center => 0.5,
            HPos::Right => 1.0,
        };
        let down = match anchor.v_pos {
            VPos::Top => 0.0,
            VPos::Center => 0.5,
            VPos::Bottom => 1.0,
        };
        self.0.write(x as f32, y as f32, (across, down), linear(style.color()), text);
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self, text: &str, _: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let (width, height) = self.0.text_size(text);
        Ok((width as u32, height as u32))
    }
}
