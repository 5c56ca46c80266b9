//! What `--help` says.

use std::fmt::Write as _;

use super::suite::Suite;
use crate::Frame;
use crate::Setting;
use crate::Setup;
use crate::keys;
use crate::text;
use crate::translated;
use common::View;

pub(super) fn help(suite: &Suite) -> String {
    let Suite { name, concept, programs, page, exercises, .. } = suite;
    let (size, last) = (programs[0].size, programs.len());
    let mut lecture = String::new();
    if last > 1 {
        lecture = text!(
            "
      --step N            begin with that step (1; at most {last}), not with the class's first stop
      --stop N            begin at that stop of the class
      --tour FILE         a class of your own in place of the lecture's, in the same Markdown
      --check-tour        which stops show nothing, or what the one before shows; exit 1 if any do
      --still             nothing glides from one stop to the next
      --divide PART       the step before left of PART of the width, such as 0.5
      --difference        where there is more light than in the step before, and less",
            last
        );
    }
    if page.is_some() {
        lecture += text!(
            "
      --page FILE         write all steps as one web page, to be opened by a double click; with
                          --tour, for that class
      --handout FILE      write the class for a browser to print: of each stop its picture, what is
                          said there, and room to write"
        );
    }
    let check = match exercises {
        None => "",
        Some(_) => text!(
            "
      --check STEP        is STEP's program now this one? compares many pictures, names the
                          mistake; expected, found and difference go to check.png, or to -o;
                          exit 1 if they differ; of this step itself, it checks the pixel loop
      --watch             build the program anew at each save of a source file; the window goes on
                          where it was, with the first error over the picture until it is mended
      --open ADDRESS      what an address of this program or of the page shows, from its # on
      --window WxH+X+Y    the window's size, and its place on the screen"
        ),
    };
    let code = match programs.iter().any(|program| !program.code.is_empty()) {
        true => text!(
            "
      --code              with --pixel, the code that ran for it, each line with its numbers"
        ),
        false => "",
    };
    let mut text = text!(
        "{name}: {concept}

Usage: {name} [OPTIONS]

Without options it opens a window; with no display it writes {name}.png.

Options:
  -o, --output FILE       write a PNG, open no window; - is standard output, and a.pfm has the
                          light before it is encoded; a name such as a.jpg is refused
  -s, --size WxH          pixels ({size})
      --camera KIND       {cameras}
      --set NAME=VALUE    set a control, as its slider would; repeatable, applied in order
      --samples N         N×N rays a pixel (1; at most {most})
      --pixel X,Y         print that pixel's equations with their numbers; with -o, write the
                          picture with its rays and vectors, and the equations beside it{code}
      --outside           with -o, write the camera as it is seen from outside; --set also takes
                          outside.azimuth, outside.elevation and outside.distance
      --show LINE         the picture of a told line at every pixel: 'n·l', 'key: n·l'; one that
                          there is not, such as ?, lists all
      --range LOW,HIGH    with --show, between which numbers its colours tell apart
      --curve             with --show and --pixel, the line along the pixel's row too
      --what-if LINE=V    a told line answered otherwise: 'V=1', 'L_s=0'; repeatable
      --compare FILE      render, say how far FILE is from it and where; exit 1 if they differ; a
                          PNG, PPM, BMP, TGA or JPEG, and - is standard input;
                          with -o, write expected, found and difference side by side; with --show,
                          compare a picture of that line, numbers as grey{check}{lecture}
      --language pt|en    Portuguese or English; else the system's language
  -h, --help              this text

Controls (default):
",
        name,
        concept = translated(concept),
        size,
        cameras = View::PROJECTIONS.join(" | "),
        most = Frame::MAX_SAMPLES,
        check,
        code,
        lecture
    );
    let mut listed: Vec<String> = Vec::new();
    for Setting { name, control, .. } in
        programs.iter().flat_map(|program| Setup::new(program.make.clone()).list())
    {
        if !listed.contains(&name) {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  {name:<16} {} ({})", control.takes(), control.text());
            listed.push(name);
        }
    }
    text.push_str(text!("\nIn the window:\n"));
    for row in keys().into_iter().filter(|row| last > 1 || !row.lecture) {
        let (keys, effect) = row.listed();
        let _ = writeln!(text, "  {keys:<16} {effect}");
    }
    text
}
