//! Puts the page together: one file with everything in it.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;

use anyhow::Context;
use anyhow::Result;
use anyhow::bail;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use image::DynamicImage;
use jpeg_encoder::ColorType;
use jpeg_encoder::Encoder;
use jpeg_encoder::SamplingFactor;
use show::INKED;
use show::Language;
use show::Tour;
use show::Workspace;
use show::symbol_ink;
use show::text;

use crate::PROGRAMS;
use crate::escape::escape;
use crate::handout;
use crate::handout::Handout;
use crate::handout::Section;
use crate::packed::packed;
use crate::packed::without_unsaid;

/// Pixels of a figure's picture, and what part of it a JPEG keeps: so that the page stays small.
const STILL_WIDTH: u32 = 280;
const STILL_QUALITY: u8 = 35;

/// Of a step's own picture, which is small already.
const STEP_QUALITY: u8 = 70;

const TARGET: &str = "wasm32-unknown-unknown";

/// glam computes with it, and every browser has had it since 2023.
const FLAGS: &str = "-Ctarget-feature=+simd128";

/// What equations are set in, as no phone has a font for them.
const FONT: &[u8] = include_bytes!("../../common/canvas/font/StixTwoMath.woff2");

/// What the page runs.
const SCRIPT: &str = concat!(
    "\"use strict\";\n",
    include_str!("../page/texts.js"),
    include_str!("../page/program.js"),
    include_str!("../page/workers.js"),
    include_str!("../page/drawing.js"),
    include_str!("../page/address.js"),
    include_str!("../page/stage.js"),
    include_str!("../page/step.js"),
    include_str!("../page/prose.js"),
    include_str!("../page/cover.js"),
    include_str!("../page/explanation.js"),
    include_str!("../page/gist.js"),
    include_str!("../page/code.js"),
    include_str!("../page/desk.js"),
    include_str!("../page/controls.js"),
    include_str!("../page/figures.js"),
    include_str!("../page/class.js"),
    include_str!("../page/hands.js"),
    include_str!("../page/keys.js"),
    include_str!("../page/main.js"),
);

/// What has to stand by the fonts and crates that are in the page.
const LICENCES: [&str; 5] = [
    include_str!("../../LICENSES/DejaVu.txt"),
    include_str!("../../LICENSES/Iosevka.txt"),
    include_str!("../../LICENSES/STIX.txt"),
    include_str!("../../LICENSES/crates.txt"),
    include_str!("../../LICENSE-APACHE"),
];

/// The whole page, with the steps' program in it that [`build`] makes.
///
/// # Errors
///
/// When a handout or a picture cannot be read.
pub fn html(program: &[u8], tours: &[Tour]) -> Result<String> {
    let workspace = Workspace::find()?;
    let root = workspace.root();
    let wasm = packed(&without_unsaid(program))?;
    let (mut links, mut articles) = (String::new(), String::new());
    let font = STANDARD.encode(FONT);
    let mut style = format!(
        "@font-face {{ font-family: Mathematics; src: url(data:font/woff2;base64,{font}); }}\n{}",
        include_str!("../page/style.css")
    );
    for (name, ink) in INKED.into_iter().filter_map(|name| Some((name, symbol_ink(name)?))) {
        let [r, g, b] = ink.rgb;
        style.push_str(&format!("math .{name} {{ --ink: #{r:02x}{g:02x}{b:02x}; }}\n"));
    }
    // What is said besides the handouts is said in their language.
    let spoken = Language::spoken();
    let handouts = Language::all().map(|language| {
        language.speak();
        Ok((language, handouts(root, language)?))
    });
    let handouts = handouts.collect::<Result<Vec<_>>>();
    spoken.speak();
    for (language, (readme, steps)) in handouts? {
        articles.push_str(&cover(&readme, &steps, language.tag()));
        for (place, handout) in steps.iter().enumerate() {
            articles.push_str(&article(handout, steps.get(place + 1), place, language.tag()));
            if language != Language::ENGLISH {
                continue;
            }
            let (number, name) = (number(place), handout.title.rsplit(" · ").next());
            let _ = writeln!(
                links,
                "<li><a href=\"#step{number}\"><b>{number}</b> <span data-step=\"{number}\">{}</span></a></li>",
                name.unwrap_or_default(),
            );
        }
    }
    for program in PROGRAMS {
        let picture = format!("tests/pictures/{}_perspective.png", program.name);
        still(&root.join(picture), program.name, STEP_QUALITY, &mut style)?;
        stills(&root.join(program.name).join("figures"), &articles, &mut style)?;
    }
    let template = include_str!("../page/index.html");
    let texts = texts(&[template, SCRIPT, &articles]);
    Ok(filled(
        template,
        &[
            ("style", &style),
            ("script", &without_comments(SCRIPT)),
            ("texts", &texts),
            ("links", &links),
            ("articles", &articles),
            ("licences", &packed(LICENCES.join("\n").as_bytes())?),
            ("wasm", &wasm),
            ("tours", &packed(page::tours(tours)?.as_bytes())?),
        ],
    ))
}

/// In a language what is said of the whole class, and each step's handout.
fn handouts(root: &Path, language: Language) -> Result<(Handout, Vec<Handout>)> {
    let file = match language {
        Language::ENGLISH => "README.md".to_owned(),
        language => format!("README.{}.md", language.tag()),
    };
    let read = |folder: &str| handout::read(&root.join(folder).join(&file), folder);
    let steps = PROGRAMS.iter().map(|program| read(program.name)).collect::<Result<_>>()?;
    Ok((read(".")?, steps))
}

/// Of each language the page's own texts by their English, for its script: those that `sources` have
/// in quotes.
fn texts(sources: &[&str]) -> String {
    let is_said = |(english, _): &(String, String)| {
        let quoted = format!("\"{english}\"");
        sources.iter().any(|source| source.contains(&quoted))
    };
    let texts = Language::all().map(|language| {
        let tag = language.tag();
        let said = language.catalogue().into_iter().filter(is_said);
        let pairs: Vec<String> =
            said.map(|(english, text)| format!("{english:?}:{text:?}")).collect();
        format!("{tag:?}:{{{}}}", pairs.join(","))
    });
    format!("{{{}}}", texts.collect::<Vec<_>>().join(","))
}

/// `script` without the lines that only say something.
fn without_comments(script: &str) -> String {
    let is_said =
        |line: &&str| ["//", "/**", "* "].iter().any(|sign| line.trim().starts_with(sign));
    let lines = script.lines().filter(|line| !is_said(line) && !matches!(line.trim(), "" | "*/"));
    lines.map(|line| format!("{line}\n")).collect()
}

/// The committed pictures in `folder`, small, as the grounds of the places for the figures: where
/// nothing can be drawn, they remain. Those of one language, NAME.LANGUAGE.png, are not needed.
fn stills(folder: &Path, articles: &str, style: &mut String) -> Result<()> {
    // A step needs no figures.
    if !folder.exists() {
        return Ok(());
    }
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        paths.push(entry?.path());
    }
    paths.sort();
    for path in paths {
        let name = path.file_stem().unwrap_or_default().display().to_string();
        if !articles.contains(&format!("data-figure=\"{name}\"")) {
            continue;
        }
        still(&path, &name, STILL_QUALITY, style)?;
    }
    Ok(())
}

/// The picture in `path` as the ground of what is of the class `name`.
fn still(path: &Path, name: &str, quality: u8, style: &mut String) -> Result<()> {
    let picture = image::open(path).with_context(|| path.display().to_string())?;
    let (width, height) = (picture.width(), picture.height());
    let bytes = jpeg(picture, STILL_WIDTH, quality)?;
    let _ = writeln!(
        style,
        ".{name} {{ aspect-ratio: {width} / {height}; background-image: url(data:image/jpeg;base64,{bytes}); }}"
    );
    Ok(())
}

/// The picture, no wider than `width`, as a JPEG in base64.
pub(crate) fn jpeg(picture: impl Into<DynamicImage>, width: u32, quality: u8) -> Result<String> {
    let picture = picture.into();
    let small = picture.thumbnail(width.min(picture.width()), picture.height()).to_rgb8();
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality);
    encoder.set_optimized_huffman_tables(true);
    encoder.set_sampling_factor(SamplingFactor::R_4_2_0);
    encoder.encode(&small, small.width() as u16, small.height() as u16, ColorType::Rgb)?;
    Ok(STANDARD.encode(bytes))
}

fn number(place: usize) -> String {
    format!("{:02}", place + 1)
}

/// A step's handout, as an essay: what it asks comes first, and the next step's question last.
fn article(handout: &Handout, next: Option<&Handout>, place: usize, language: &str) -> String {
    let Handout { title, question, lead, seen, sections } = handout;
    let [title, question, seen] = [title, question, seen].map(|text| escape(text));
    let (number, name) = (number(place), PROGRAMS[place].name);
    let mut html = format!(
        "<article id=\"handout{number}-{language}\" lang=\"{language}\"><h2>{title}</h2>\
         <p class=\"question\">{question}</p>\
         <div class=\"still shot {name}\" role=\"img\" aria-label=\"{seen}\"></div>\n"
    );
    let kinds = ["idea", "equation", "try", "trap", "asks", "exercise"];
    for (place, Section { heading, html: text }) in sections.iter().enumerate() {
        let kind = kinds.get(place).unwrap_or(&"more");
        let heading = escape(heading);
        let _ = writeln!(html, "<section class=\"{kind}\"><h3>{heading}</h3>{text}</section>");
    }
    if let Some(Handout { title, question, .. }) = next {
        let [title, question] = [title, question].map(|text| escape(text));
        let number = self::number(place + 1);
        let _ = writeln!(
            html,
            "<p class=\"next\"><a href=\"#step{number}\"><small>{title}</small> {question}</a></p>"
        );
    }
    let _ = writeln!(html, "<div class=\"slides\">{lead}</div></article>");
    if language == Language::ENGLISH.tag() {
        // Where there is no script, the links lead here.
        html = format!("<noscript><span id=\"step{number}\"></span></noscript>{html}");
    }
    html
}

/// What the whole class is, and what its steps ask.
fn cover(readme: &Handout, steps: &[Handout], language: &str) -> String {
    let title = escape(&readme.title);
    let paragraphs = readme.lead.split_inclusive("</p>").collect::<Vec<_>>();
    let promise = paragraphs.get(1).copied().unwrap_or_default();
    let mut html = format!(
        "<article id=\"cover-{language}\" class=\"cover\" lang=\"{language}\"><h2>{title}</h2>\
         <div class=\"still shot {last}\" role=\"img\" aria-label=\"{seen}\"></div>{promise}<ol>\n",
        last = PROGRAMS[PROGRAMS.len() - 1].name,
        seen = escape(steps.last().map_or("", |step| &step.seen)),
    );
    for (place, Handout { question, .. }) in steps.iter().enumerate() {
        let (number, question) = (number(place), escape(question));
        let _ = writeln!(
            html,
            "<li><a href=\"#step{number}\"><b>{number}</b> <span>{question}</span></a></li>"
        );
    }
    html + "</ol></article>\n"
}

/// `template` with each `{{name}}` replaced. What is put in is not looked at again.
fn filled(template: &str, parts: &[(&str, &str)]) -> String {
    let mut pieces = template.split("{{");
    let mut page = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").unwrap_or((piece, ""));
        let part = parts.iter().find(|part| part.0 == name);
        page.push_str(part.map_or("", |part| part.1));
        page.push_str(rest);
    }
    page
}

/// Builds all steps for a browser, in WebAssembly.
///
/// What `WASM` names, if it is set, is given cargo and its arguments to run: a machine without
/// rustup has its own way to that target.
///
/// # Errors
///
/// When they do not build.
pub fn build() -> Result<Vec<u8>> {
    let workspace = Workspace::find()?;
    let root = workspace.root();
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = match env::var_os("WASM") {
        Some(helper) => {
            let mut build = Command::new(helper);
            build.arg(cargo);
            build
        }
        None if has_target() => Command::new(cargo),
        None => bail!(text!(
            "Rust cannot build for a browser yet: {command}; where there is no rustup, sudo apt install \
             libstd-rust-dev-wasm32, or sudo dnf install rust-std-static-wasm32-unknown-unknown",
            command = format!("rustup target add {TARGET}")
        )),
    };
    build.current_dir(root).args(["rustc", "--quiet", "-p", "lecture", "--lib"]);
    build.args(["--crate-type", "cdylib", "--profile", "page"]);
    let target = env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from);
    let target = path::absolute(target)?;
    build.args(["--target", TARGET, "--target-dir"]).arg(&target);
    // Where a profile has an exception for a package, cargo leaves its functions' names in.
    build.args(["--", "-Cstrip=symbols"]);
    build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", FLAGS);
    let built = build.status().context(text!("cannot run cargo, which has to build the page"))?;
    if !built.success() {
        bail!(text!("the steps do not build for a browser: what cargo says of it stands above"));
    }
    let wasm = target.join(TARGET).join("page/lecture.wasm");
    fs::read(&wasm).with_context(|| text!("cannot read {path}", path = wasm.display()))
}

/// Whether Rust's standard library for a browser is there.
fn has_target() -> bool {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let folder =
        Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
    folder.is_ok_and(|folder| Path::new(String::from_utf8_lossy(&folder.stdout).trim()).exists())
}
