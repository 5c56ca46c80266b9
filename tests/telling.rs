//! What is told is a tree: what is told of a thing ends with its block, and a sum adds its own terms.

use tests::prelude::*;

/// What `tell` tells.
fn told(tell: impl FnOnce(&Recorder)) -> Explanation {
    let recorder = Recorder::new(Pixel { col: 1, row: 2, width: 3, height: 4 });
    tell(&recorder);
    recorder.finish(Color::ZERO)
}

/// The only scope `name`, wherever it is.
fn only<'a>(told: &'a Explanation, name: &str) -> &'a Scope {
    let scopes: Vec<&Scope> =
        told.told.all().into_iter().filter(|scope| scope.name == name).collect();
    let [scope] = scopes[..] else { panic!("{} scopes are about {name}", scopes.len()) };
    scope
}

#[test]
fn values_are_found_by_their_symbol() {
    let told = told(|say| {
        let _about = say.about("light");
        for (equation, number) in [("t₂", 3.0), ("t = ½", 0.5), ("t", 7.0)] {
            assert_eq!(say.line(equation, number), number, "a value is handed back");
        }
        say.line("L = L_a", Vec3::X);
    });
    assert_eq!(told.value("t"), Some(Value::Number(0.5)), "the first whose left side is t");
    assert_eq!(told.value("L"), Some(Value::Vector(Vec3::X)), "the left side is the symbol");
    assert_eq!([told.value("light"), told.value("L_a")], [None; 2], "no thing, no right side");
    assert_eq!(told.lines().count(), 4, "four lines were told");
}

#[test]
fn what_is_told_of_a_thing_ends_with_its_block() {
    let early = |say: &Recorder, why: Option<f32>| -> Option<f32> {
        let _about = say.about("inner");
        say.line("a", 1.0);
        let number = why?;
        Some(say.line("b", number))
    };
    let told = told(|say| {
        say.line("before", 0.0);
        let outer = say.about("outer");
        early(say, None);
        early(say, Some(2.0));
        say.line("after", 3.0);
        drop(outer);
        say.line("last", 4.0);
    });
    let names: Vec<&str> = told.told.all().iter().map(|scope| scope.name).collect();
    assert_eq!(names, ["", "outer", "inner", "inner"], "two within one, however they end");
    let lines: Vec<&str> = told.lines().map(|line| line.equation).collect();
    assert_eq!(lines, ["before", "a", "a", "b", "after", "last"], "all, as they were told");
    let own = |scope: &Scope| scope.lines().map(|line| line.equation).collect::<Vec<_>>();
    assert_eq!(own(&told.told), ["before", "last"], "after the block it is about the rest");
    assert_eq!(own(only(&told, "outer")), ["after"], "and so it is within it");
    assert!(told.scope("outer").is_some() && told.scope("inner").is_none(), "it is within another");
}

#[test]
fn the_closest_is_the_last_that_was_closer() {
    let hit = |say: &Recorder, name, t: Option<f32>| {
        let _about = say.about(name);
        match t {
            Some(t) => assert_eq!(say.closest("t", t), t, "t is handed back"),
            None => assert_eq!(say.miss::<f32>("no root", "D < 0"), None, "a miss is none"),
        }
    };
    let told = told(|say| {
        let _about = say.about("intersection");
        hit(say, "far", Some(3.0));
        hit(say, "beside", None);
        hit(say, "near", Some(2.0));
        // What another ray hits is no farther and no closer.
        let _about = say.about("mirror");
        hit(say, "mirrored", Some(1.0));
    });
    let scopes = only(&told, "intersection").scopes();
    let outcomes: Vec<Outcome> = scopes.map(|scope| scope.outcome).collect();
    let (far, near) = (Outcome::Farther(3.0), Outcome::Closest(2.0));
    let expected = [far, Outcome::Missed("no root", "D < 0"), near, Outcome::Told];
    assert_eq!(outcomes, expected, "far was the closest until near was found");
    assert_eq!(only(&told, "mirrored").outcome, Outcome::Closest(1.0), "it is alone");
    let is_open = ["far", "beside", "near"].map(|name| only(&told, name).is_open());
    assert_eq!(is_open, [false, false, true], "only what is seen is open at first");
}

#[test]
fn a_sum_adds_each_term_of_its_block_once() {
    let color = |red: f32| Color::new(red, 0.5 * red, 0.0);
    let told = told(|say| {
        say.term("another = 1", color(9.0));
        let _about = say.about("illumination");
        let mut sum = say.term("L_a = k_a I_a", color(1.0));
        {
            let _about = say.about("key light");
            sum += say.term("L_d = …", color(2.0)) + say.term("L_s", color(4.0));
        }
        {
            // What is summed is no term of what is around, until it is told as one.
            let _about = say.about("mirror");
            let seen = say.term("L_a", color(16.0)) + say.term("L_d", color(32.0));
            say.sum("L", seen);
            sum += say.term("L_m = k_m L", 0.5 * seen);
        }
        drop(say.about("fill light"));
        say.sum("L", sum);
        say.sum("empty", Color::ZERO);
    });
    let values = |scope: &Scope| -> Vec<(&str, Value)> {
        scope.lines().map(|line| (line.symbol(), line.value)).collect()
    };
    let sums: Vec<_> =
        told.told.all().into_iter().filter(|scope| scope.name == "sum").map(values).collect();
    let all = |terms: &[(&'static str, f32)]| -> Vec<(&str, Value)> {
        terms.iter().map(|(symbol, red)| (*symbol, Value::Vector(color(*red)))).collect()
    };
    assert_eq!(sums[0], all(&[("L_a", 16.0), ("L_d", 32.0), ("L", 48.0)]), "the mirror's");
    let of_all = [("L_a", 1.0), ("key light", 6.0), ("mirror", 24.0), ("L", 31.0)];
    assert_eq!(sums[1], all(&of_all), "each by what it is of");
    assert_eq!(sums[2..], [all(&[("empty", 0.0)])], "no term is added twice");
    // What `--pixel` prints begins each thing two columns deeper than what it is within.
    let text = written(&told);
    for (name, depths) in [("illumination", &[0][..]), ("mirror", &[2]), ("sum", &[4, 2, 2])] {
        let lines = text.lines().filter(|line| line.trim() == name);
        let found: Vec<usize> = lines.map(|line| line.len() - line.trim_start().len()).collect();
        assert_eq!(found, depths, "{name} is within another:\n{text}");
    }
}

#[test]
fn numbers_are_shown_in_digits_that_say_something() {
    for (number, shown) in [
        (0.0, " 0"),
        (-0.0, " 0"),
        (1.0, " 1"),
        (-1.5, "-1.5"),
        (0.1, " 0.1"),
        (1.0 / 3.0, " 0.3333333"),
        (-0.001, "-0.001"),
        (-1e-4, "-1.0000e-4"),
        (9.9e-5, " 9.9000e-5"),
        (-1e-30, "-1.0000e-30"),
        (99_999.5, " 99999.5"),
        (100_000.0, " 100000"),
        (999_999.0, " 999999"),
        (1e6, " 1.0000e6"),
        (f32::INFINITY, " inf"),
        (f32::NAN, " NaN"),
    ] {
        assert_eq!(texts(&Value::Number(number)), [shown]);
    }
    let texts = texts(&Value::Vector(Vec3::new(1.0, -1e-9, 2e-5)));
    assert_eq!(texts, [" 1", " 0", " 0.00002"], "what is too small to see is 0, without a sign");
}
