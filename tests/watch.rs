#![cfg(target_os = "linux")]
//! `--watch`: a program that goes on in its window, whatever is saved beside it.

use std::fs;
use std::fs::File;
use std::os::unix::fs::MetadataExt;
use std::process::Child;

use tests::prelude::*;

use crate::exercises::copy;
use crate::window::Display;
use crate::window::until;

/// What is shown from the beginning to the end.
const SHOWN: &str = "--set I=80 --pixel 480,270";

/// Ends a program however a test ends.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
#[ignore = "builds a step six times"]
fn what_is_saved_is_seen_and_what_is_wrong_stands_over_the_picture() {
    let (copy, display, folder) = (copy(), Display::start(), scratch());
    let (output, errors) = (folder.join("output"), folder.join("errors"));
    let mut watch = start(copy.program(5));
    watch.args(["--watch", "--open", "#step05&I=80&pixel=480,270", "--window", "900x500+40+30"]);
    watch.current_dir(copy.root()).env("DISPLAY", &display.name);
    watch.env("CARGO_TARGET_DIR", copy.target()).env("CARGO_NET_OFFLINE", "true");
    watch.stdout(File::create(&output).expect("a file"));
    let watch = watch.stderr(File::create(&errors).expect("a file"));
    let program = Ended(watch.spawn().expect("the step starts"));
    let id = program.0.id();
    let built = || fs::metadata(format!("/proc/{id}/exe")).map(|program| program.ino()).ok();
    let said = |path| fs::read_to_string(path).expect("text");
    let shown = || {
        let window = until("a window", || {
            let found = display.ask("search --onlyvisible --name ^step05_diffuse:")?;
            Some(found.lines().next()?.to_owned())
        });
        let before = said(&output).len();
        until("the command", || {
            display.ask(&format!("windowfocus {window} key --window {window} c"))?;
            said(&output)[before..].lines().next().map(str::to_owned)
        })
    };
    assert!(shown().contains(SHOWN));
    let path = copy.root().join("step05_diffuse/src/material.rs");
    let source = said(&path);
    let save = |lambert: &str| {
        let changed = source.replace("n_dot_l.max(0.0))", lambert);
        assert_ne!(changed, source);
        fs::write(&path, changed).expect("the copy can be written");
    };
    for (lambert, wrong) in [
        ("n_dot_l.max(0.0) * 0.5)", ""),
        ("n_dot_l.max(0.0)", "step05_diffuse/src/material.rs:"),
        ("{ assert!(n_dot_l < 0.5, \"too bright\"); n_dot_l })", "the program panics: too bright"),
        ("n_dot_l.abs())", ""),
    ] {
        let (before, told) = (built(), said(&errors).len());
        save(lambert);
        until(lambert, || match wrong {
            "" => (built() != before).then_some(()),
            wrong => said(&errors)[told..].contains(wrong).then_some(()),
        });
        assert!(shown().contains(SHOWN), "{lambert}");
        assert_eq!(built() == before, !wrong.is_empty(), "{lambert}");
    }
    let place = said(&format!("/proc/{id}/cmdline").into());
    assert!(place.contains("900x500+40+30"), "{place}");
    fs::write(&path, source).expect("the copy can be written");
}
