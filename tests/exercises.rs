//! Solutions of the exercises, right and wrong: `--check` accepts the right ones, refuses the others
//! and says what is wrong with them.

use std::process::Command;
use std::process::Output;
use std::sync::LazyLock;
use std::sync::Mutex;
use std::sync::MutexGuard;
use std::sync::PoisonError;

use exercises::Milestone;
use tests::prelude::*;

/// The text of a file that is replaced, and by what.
pub(crate) type Change = (String, String, String);

pub(crate) fn change(file: &str, from: &str, to: &str) -> Change {
    (file.to_owned(), from.to_owned(), to.to_owned())
}

/// A solution of `solutions.txt`.
struct Solution {
    kind: String,
    step: usize,
    /// What is said of it, as it begins, and a second text.
    words: [String; 2],
    changes: Vec<Change>,
}

fn solutions() -> Vec<Solution> {
    let text = source("tests/solutions.txt");
    let blocks = text.split("\n\n").filter(|block| !block.starts_with('#'));
    let solution = |block: &str| {
        let mut lines = block.lines();
        let (head, said) = lines.next().and_then(|it| it.split_once(':')).unwrap_or((block, ""));
        let (kind, step) = head.lines().next().and_then(|it| it.split_once(' ')).expect(block);
        let (first, second) = said.split_once("; ").unwrap_or((said, ""));
        let mut changes: Vec<Change> = Vec::new();
        for line in block.lines().skip(1) {
            let text = line.get(2..).unwrap_or_default();
            match (changes.last_mut(), line.chars().next()) {
                (Some((_, from, _)), Some('-')) => from.extend([text, "\n"]),
                (Some((.., to)), Some('+')) => to.extend([text, "\n"]),
                _ => changes.push(change(line, "", "")),
            }
        }
        for (_, from, to) in &mut changes {
            from.pop();
            to.pop();
        }
        let words = [first, second].map(|it| it.trim().to_owned());
        Solution { kind: kind.to_owned(), step: step.parse().expect("a step"), words, changes }
    };
    blocks.map(solution).collect()
}

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
        let (copied, programs) =
            (empty_folder("exercises/all"), empty_folder("exercises/programs"));
        for name in files(root()).into_iter().filter(|name| name != "target" && name != ".git") {
            match root().join(&name) {
                folder if folder.is_dir() => copy_folder(&folder, &copied.join(name)),
                file => drop(fs::copy(file, copied.join(name)).expect("the copy can be written")),
            }
        }
        let copy = Self { root: copied, programs };
        let steps = STEPS.iter().flat_map(|step| ["-p", step]);
        let built = copy.cargo().arg("build").args(steps).output().expect("cargo runs");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        for step in STEPS {
            let program = copy.target().join("debug").join(step);
            let program = program.with_extension(std::env::consts::EXE_EXTENSION);
            let name = program.file_name().expect("a name");
            fs::copy(&program, copy.programs.join(name)).expect("a program");
        }
        copy
    }

    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// The program of a step, from 1 on, as it is before anything is changed.
    pub(crate) fn program(&self, step: usize) -> PathBuf {
        self.programs.join(STEPS[step - 1])
    }

    pub(crate) fn target(&self) -> PathBuf {
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
            _ => start(self.program(step)),
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

/// Whether `text` says that a milestone is reached, that there is a mistake, and one on the way to it, as
/// they begin, and nothing else.
fn is_said(text: &str, [milestone, mistake, but]: [&str; 3]) -> bool {
    let after = |begin| text.lines().filter_map(move |line| line.strip_prefix(begin));
    let reached: Vec<&str> = after("So far so good: ").collect();
    let buts: Vec<&str> = after("But: ").collect();
    let named =
        text.lines().filter(|line| line.contains(". Slide «") && !line.starts_with("But: "));
    let named: Vec<&str> = named.map(|line| line.strip_prefix("Or: ").unwrap_or(line)).collect();
    let are = |said: &[&str], begin: &str| match begin {
        "" => said.is_empty(),
        _ => said.iter().any(|line| line.starts_with(begin)),
    };
    // A milestone may be taken for a mistake.
    let named = are(&named, mistake) || !reached.is_empty() && mistake.is_empty();
    reached.len() < 2 && are(&reached, milestone) && named && are(&buts, but)
}

#[test]
#[ignore = "builds all steps and some ninety solutions: minutes"]
fn right_solutions_are_accepted_and_others_refused_with_what_is_known_of_them() {
    let copy = copy();
    let (all, mut wrong) = (solutions(), Vec::new());
    let reached: Vec<&Solution> = all.iter().filter(|it| it.kind == "reaches").collect();
    for Solution { kind, step, words: [first, second], changes } in &all {
        let same = reached.iter().find(|it| it.step == *step && it.changes == *changes);
        let milestone = same.map_or("", |it| &it.words[0]);
        let expected = match &**kind {
            "right" => ["", "", ""],
            "reaches" => [first, "", ""],
            "but" => [first, "", second],
            _ => [milestone, first, ""],
        };
        let output = copy.check(*step, changes);
        let text = String::from_utf8_lossy(&output.stdout);
        let code = i32::from(kind != "right");
        let judgement = format!(
            "{step} {changes:?}: {:?}\n    {}\n{}",
            output.status.code(),
            text.lines().take(6).collect::<Vec<_>>().join("\n    "),
            String::from_utf8_lossy(&output.stderr),
        );
        say(&judgement);
        // What fails ends with what shows the same pixel of one's own program.
        let package = STEPS[step.saturating_sub(2)];
        let command = format!("the same pixel of {package}: cargo run -p {package} -- --size ");
        let ends = text.lines().last().is_some_and(|line| line.starts_with(&command));
        if output.status.code() != Some(code) || !is_said(&text, expected) || ends != (code == 1) {
            wrong.push(judgement);
        }
    }
    let broken = change("scene.rs", "let shadow_ray = ", "let shadow_ray: u8 = ");
    let broken = copy.check(6, &[broken]);
    let said = String::from_utf8_lossy(&broken.stderr);
    assert!(said.contains("error: step05_diffuse does not compile: "), "{said}");
    assert_eq!((broken.status.code(), &broken.stdout[..]), (Some(1), &[][..]));
    none(wrong);
}

#[test]
fn milestones_are_those_that_handouts_name() {
    let all = solutions();
    let reached: Vec<&Solution> = all.iter().filter(|it| it.kind == "reaches").collect();
    for Solution { step, words: [_, said], .. } in &reached {
        let handout = PROGRAMS[step - 1].handouts[0];
        let (_, exercise) = handout.split_once("\n## Exercise\n").expect("an exercise");
        let is_named = words(exercise).join(" ").contains(said);
        assert!(is_named, "the handout of step {step} does not say: {said}");
    }
    for milestone in Milestone::ALL {
        let is_it = |it: &&Solution| {
            STEPS[it.step - 1] == milestone.step && milestone.done.starts_with(&it.words[0])
        };
        assert!(reached.iter().any(is_it), "not tried: {milestone:?}");
    }
}

/// What each ray of a solution does before it is traced.
fn before_each_ray(line: &str) -> Change {
    change("render.rs", "let color = trace(&ray);", line)
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

/// One line, a catalogue, the handouts and the way through the slides.
#[test]
#[ignore = "builds the lecture: minutes"]
fn a_third_language_is_one_line_and_its_texts() {
    let copy = copy();
    let write = |path: &str, text: String| {
        fs::write(copy.root.join(path), text).expect("the copy can be written");
    };
    let list = "common/show/src/language.rs";
    let known = source(list);
    assert_eq!(known.matches("\"pt-BR\" }").count(), 1, "the only list of them");
    write(list, known.replace("\"pt-BR\" }", "\"pt-BR\" \"x-made-up\" }"));
    let texts = "msgid \"viewing ray\"\nmsgstr \"yar gniweiv\"\n";
    write("common/show/src/x-made-up.po", texts.to_owned());
    write("lecture/tour/x-made-up.md", source("lecture/tour/en.md"));
    for step in STEPS {
        write(&format!("{step}/README.x-made-up.md"), source(format!("{step}/README.md")));
    }
    let mut lecture = copy.cargo();
    lecture.args(words("run -p lecture -- --language x --pixel 9,9"));
    let output = lecture.env("LC_ALL", "pt_BR").output().expect("cargo runs");
    let said = [output.stdout, output.stderr].map(|it| String::from_utf8_lossy(&it).into_owned());
    assert!(output.status.success() && said[0].contains("yar gniweiv"), "{said:?}");
}
