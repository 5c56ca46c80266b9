//! Solutions of the exercises, right and wrong: `--check` accepts the right ones, refuses the others
//! and says what is wrong with them.

use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;
use std::process::Output;
use std::sync::LazyLock;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;

use exercises::Milestone;
use tempfile::tempdir;
use tests::prelude::*;

use crate::solutions::BUT;
use crate::solutions::Change;
use crate::solutions::MILESTONES;
use crate::solutions::RIGHT;
use crate::solutions::WRONG;

/// A copy of the steps, with programs of its own.
pub(crate) struct Copy {
    root: PathBuf,
    /// The programs as they are before anything is changed.
    programs: PathBuf,
}

/// The one copy, for one test at a time.
pub(crate) fn copy() -> MutexGuard<'static, Copy> {
    static COPY: LazyLock<Mutex<Copy>> = LazyLock::new(|| Mutex::new(Copy::new()));
    COPY.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Copy {
    fn new() -> Self {
        let root_of_copy = empty_folder("exercises/steps");
        let packages = source("Cargo.toml");
        let steps: Vec<&str> = ["common"].into_iter().chain(STEPS).collect();
        let lines = packages.lines().map(|line| match line.split_once("members = ") {
            None => line.to_owned() + "\n",
            Some((which, _)) => format!("{which}members = {steps:?}\n"),
        });
        let packages: String = lines.collect();
        fs::write(root_of_copy.join("Cargo.toml"), packages).expect("the copy can be written");
        fs::copy(root().join("Cargo.lock"), root_of_copy.join("Cargo.lock")).expect("a lock file");
        for package in steps {
            copy_folder(&root().join(package), &root_of_copy.join(package));
        }
        let programs = empty_folder("exercises/programs");
        let copy = Self { root: root_of_copy, programs };
        let built = copy.cargo().arg("build").output().expect("cargo runs");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        for step in STEPS {
            let program = copy.target().join("debug").join(step);
            let program = program.with_extension(std::env::consts::EXE_EXTENSION);
            let name = program.file_name().expect("a name");
            fs::copy(&program, copy.programs.join(name)).expect("a program");
        }
        copy
    }

    fn target(&self) -> PathBuf {
        self.root.with_file_name("target")
    }

    fn cargo(&self) -> Command {
        let mut cargo = start(env!("CARGO"));
        cargo.current_dir(&self.root).args(["--quiet"]).env("CARGO_NET_OFFLINE", "true");
        cargo.env("CARGO_TARGET_DIR", self.target());
        cargo
    }

    /// Puts the source of `step`, from 1 on, with `changes` into the package of its exercise, and
    /// gives what `--check` says of it.
    pub(crate) fn check(&self, step: usize, changes: &[Change]) -> Output {
        self.with(step, changes, |mut check| check.output().expect("it runs"))
    }

    /// The same, for whatever `run` does with the check.
    fn with<T>(&self, step: usize, changes: &[Change], run: impl FnOnce(Command) -> T) -> T {
        let (reached, package) = (STEPS[step - 1], STEPS[step.saturating_sub(2)]);
        let source = self.root.join(package).join("src");
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(reached).join("src"), &source);
        for (file, from, to) in changes {
            let path = source.join(file);
            let text = fs::read_to_string(&path).expect("a source file");
            assert_eq!(text.matches(from).count(), 1, "{reached}: {file}: {from}");
            fs::write(path, text.replace(from, to)).expect("the copy can be written");
        }
        let mut check = match step {
            1 => {
                let mut cargo = self.cargo();
                cargo.args(["run", "-p", reached, "--manifest-path"]);
                cargo.arg(self.root.join("Cargo.toml")).arg("--");
                cargo
            }
            _ => start(self.programs.join(reached)),
        };
        check.env("CARGO", env!("CARGO")).env("CARGO_NET_OFFLINE", "true");
        check.env("CARGO_TARGET_DIR", self.target());
        check.current_dir(&self.root).args(["--check", package]);
        let done = run(check);
        fs::remove_dir_all(&source).expect("it was copied");
        copy_folder(&root().join(package).join("src"), &source);
        done
    }
}

/// What `--check` has to say of a solution, as it begins.
#[derive(Default)]
struct Expected {
    milestone: &'static str,
    mistake: &'static str,
    /// A mistake on the way to the milestone.
    but: &'static str,
}

impl Expected {
    /// Whether `text` says all of it, and nothing else.
    fn is_said(&self, text: &str) -> bool {
        let reached: Vec<&str> =
            text.lines().filter_map(|line| line.strip_prefix("So far so good: ")).collect();
        let (but, named): (Vec<&str>, Vec<&str>) = text
            .lines()
            .filter(|line| line.contains(". Slide «"))
            .map(|line| line.strip_prefix("Or: ").unwrap_or(line))
            .partition(|line| line.starts_with("But: "));
        let are = |said: &[&str], begin: &str| match begin {
            "" => said.is_empty(),
            _ => said.iter().any(|line| line.starts_with(begin)),
        };
        // A milestone may be taken for a mistake.
        let named = are(&named, self.mistake) || !reached.is_empty() && self.mistake.is_empty();
        let but: Vec<&str> = but.iter().filter_map(|line| line.strip_prefix("But: ")).collect();
        reached.len() < 2 && are(&reached, self.milestone) && named && are(&but, self.but)
    }
}

#[test]
#[ignore = "builds all steps and some ninety solutions: minutes"]
fn right_solutions_are_accepted_and_others_refused_with_what_is_known_of_them() {
    let copy = copy();
    let mut wrong: Vec<String> = Vec::new();
    let mut judge = |step, changes, code: i32, expected: Expected| {
        let output = copy.check(step, changes);
        let text = String::from_utf8_lossy(&output.stdout);
        let fits = output.status.code() == Some(code) && expected.is_said(&text);
        let judgement = format!(
            "{} {step} {changes:?}: {:?}\n    {}\n{}",
            if fits { "ok " } else { "NOT" },
            output.status.code(),
            text.lines().take(6).collect::<Vec<_>>().join("\n    "),
            String::from_utf8_lossy(&output.stderr),
        );
        say(&judgement);
        if !fits {
            wrong.push(judgement);
        }
    };
    for (step, changes) in RIGHT {
        judge(*step, changes, 0, Expected::default());
    }
    let broken = copy.check(6, &[("scene.rs", "let shadow_ray = ", "let shadow_ray: u8 = ")]);
    let said = String::from_utf8_lossy(&broken.stderr);
    assert!(said.contains("error: step05_diffuse does not compile: "), "{said}");
    assert_eq!((broken.status.code(), &broken.stdout[..]), (Some(1), &[][..]));
    for (step, changes, mistake) in WRONG {
        let reached = MILESTONES.iter().find(|it| it.0 == *step && it.2 == *changes);
        let milestone = reached.map_or("", |it| it.3);
        judge(*step, changes, 1, Expected { milestone, mistake, but: "" });
    }
    for (step, _, changes, milestone) in MILESTONES {
        judge(*step, changes, 1, Expected { milestone, ..Expected::default() });
    }
    let (step, changes, milestone, but) = BUT;
    judge(step, changes, 1, Expected { milestone, mistake: "", but });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn milestones_are_those_that_handouts_name() {
    for (step, words, ..) in MILESTONES {
        let handout = lecture::PROGRAMS[step - 1].handouts[0];
        let (_, exercise) = handout.split_once("\n## Exercise\n").expect("an exercise");
        let exercise: Vec<&str> = exercise.split_whitespace().collect();
        let name = STEPS[step - 1];
        assert!(exercise.join(" ").contains(words), "{name}: its handout does not say: {words}");
    }
    for milestone in Milestone::ALL {
        let is_it = |it: &&(usize, &str, &[Change], &str)| {
            STEPS[it.0 - 1] == milestone.step && milestone.done.starts_with(it.3)
        };
        assert!(MILESTONES.iter().any(|it| is_it(&it)), "not tried: {milestone:?}");
    }
}

/// What each ray of a solution does before it is traced.
const fn before_each_ray(line: &'static str) -> Change {
    ("render.rs", "let color = trace(&ray);", line)
}

#[test]
#[ignore = "builds all steps and some solutions: minutes"]
fn programs_that_crash_or_flood_are_ended_and_what_they_say_is_shown() {
    let copy = copy();
    let [said, flooded, panicked] = [
        "println!(\"{ray:?}\"); let color = trace(&ray);",
        "eprintln!(\"{ray:?}\"); let color = trace(&ray);",
        "eprintln!(\"{ray:?}\"); assert!(row < 100, \"too far down\"); let color = trace(&ray);",
    ];
    for line in [said, flooded] {
        let output = copy.check(2, &[before_each_ray(line)]);
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(text.starts_with("done: step01_rays draws all "), "{line}: {text}");
        assert_eq!((output.status.code(), &output.stderr[..]), (Some(0), &[][..]), "{line}");
    }
    let output = copy.check(2, &[before_each_ray(panicked)]);
    let text = String::from_utf8_lossy(&output.stderr);
    let last = text.lines().last().expect("a line");
    assert!(text.contains("render.rs:") && text.contains("too far down"), "{text}");
    assert!(last.starts_with("error: step01_rays stops at --size 320x180"), "{text}");
    assert!(last.ends_with(": what it says of that stands above"), "{text}");
    assert!(text.lines().count() < 30, "floods: {text}");
    assert_eq!((output.status.code(), &output.stdout[..]), (Some(1), &[][..]), "{text}");
}

#[cfg(unix)]
#[test]
#[ignore = "builds all steps and a solution: minutes"]
fn a_program_that_never_ends_is_said_to_compute_and_ends_on_ctrl_c() {
    use std::io::BufRead;
    use std::io::BufReader;
    use std::os::unix::process::CommandExt;
    use std::os::unix::process::ExitStatusExt;
    use std::process::Stdio;

    let copy = copy();
    let forever = before_each_ray("if row == 50 { loop {} } let color = trace(&ray);");
    let said = copy.with(2, &[forever], |mut check| {
        // What a terminal sends goes to all programs of a group.
        let mut check = check.process_group(0).stderr(Stdio::piped()).spawn().expect("it runs");
        let group = format!("-{}", check.id());
        let lines = BufReader::new(check.stderr.take().expect("a pipe")).lines();
        let said = lines.map_while(Result::ok).find(|line| line.contains("Ctrl+C"));
        let sent = start("kill").args(["-INT", "--", &group]).status();
        assert!(sent.expect("kill runs").success());
        assert_eq!(check.wait().expect("it was started").signal(), Some(2));
        said
    });
    let expected = "step01_rays: still computes --size 320x180 after 10 s; Ctrl+C stops";
    assert_eq!(said.as_deref(), Some(expected));
}

#[test]
fn the_steps_are_those_of_the_folder_where_a_check_runs() {
    // Another workspace, however its steps are called.
    let elsewhere = tempdir().expect("a folder");
    let folders = ["", "step42_other", "no_step", "a/b"].map(|name| elsewhere.path().join(name));
    for (folder, is_package) in folders.iter().zip([true, true, true, false]) {
        fs::create_dir_all(folder).expect("a folder");
        if is_package {
            fs::write(folder.join("Cargo.toml"), "").expect("a file");
        }
    }
    let name = format!("program{}", std::env::consts::EXE_SUFFIX);
    let home = tempdir().expect("a folder");
    let alone = home.path().join(name);
    let [root, .., below] = &folders;
    let asks = |mut program: Command, folder: &Path| {
        let program = program.current_dir(folder).args(["--check", "step99"]);
        let output = program.output().expect("it runs");
        (output.status.code(), only_line(&output).to_owned())
    };
    let others = "error: there is no step 'step99'; there are step42_other (";
    for folder in [root, below] {
        let (code, line) = asks(program(STEPS[1]), folder);
        assert!(line.starts_with(others) && code == Some(2), "{line}");
    }
    // Where there are none, those among which the program lies.
    let empty = tempdir().expect("a folder");
    let (code, line) = asks(program(STEPS[1]), empty.path());
    assert!(line.contains(&STEPS.join(", ")) && code == Some(2), "{line}");
    // And if it lies nowhere, it says where it looked.
    fs::copy(program(STEPS[1]).get_program(), &alone).expect("a program");
    let (code, line) = asks(start(&alone), empty.path());
    let looked = [empty.path(), home.path()].map(|path| path.file_name().expect("a name"));
    let named = looked.iter().all(|name| line.contains(&*name.to_string_lossy()));
    assert!(line.starts_with("error: the steps are found neither in ") && named, "{line}");
    assert_eq!(code, Some(1));
}

#[test]
fn a_step_checks_its_own_pixel_loop() {
    let folder = tempdir().expect("a folder");
    let mut program = command("step02_sphere", folder.path());
    let checked = program.args(["--check", "step02_sphere"]).output().expect("it runs");
    let text = String::from_utf8_lossy(&checked.stdout);
    assert!(text.starts_with("done: the pixel loop of step02_sphere is right in all "), "{text}");
    assert_eq!(checked.status.code(), Some(0));
    assert!(files(folder.path()).is_empty(), "nothing differs, so nothing is written");
}
