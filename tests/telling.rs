//! What is told is a tree: what is told of a thing ends with its block, and a sum adds its own terms.

use tests::prelude::*;

/// What `tell` tells.
fn told(tell: impl FnOnce(&Recorder)) -> Explanation {
    let recorder = Recorder::new(Pixel { col: 1, row: 2, width: 3, height: 4 });
    tell(&recorder);
    recorder.finish(Color::ZERO)
}

/// What is printed, without the values and what is around them.
fn outline(told: &Explanation) -> String {
    let lines = written(told);
    let lines = lines.lines().map(|line| line.split("  ").find(|part| !part.is_empty()));
    lines.flatten().collect::<Vec<_>>().join("; ")
}

#[test]
fn what_is_told_of_a_thing_ends_with_its_block_and_is_found_by_its_symbol() {
    let early = |say: &Recorder, why: Option<f32>| -> Option<f32> {
        let _about = say.about("inner");
        say.line("t₂", 1.0);
        let number = why?;
        Some(say.line("t = ½", number))
    };
    let told = told(|say| {
        assert_eq!(say.line("before", 0.0), 0.0, "a value is handed back");
        let outer = say.about("outer");
        early(say, None);
        early(say, Some(2.0));
        say.line("L = L_a", Vec3::X);
        drop(outer);
        say.line("t", 4.0);
    });
    let names: Vec<&str> = told.told.all().iter().map(|scope| scope.name).collect();
    assert_eq!(names, ["", "outer", "inner", "inner"], "two within one, however they end");
    let lines: Vec<&str> = told.lines().map(|line| line.equation).collect();
    assert_eq!(lines, ["before", "t₂", "t₂", "t = ½", "L = L_a", "t"], "all, as they were told");
    let own: Vec<&str> = told.told.lines().map(|line| line.equation).collect();
    assert_eq!(own, ["before", "t"], "after the block it is about the rest");
    assert!(told.scope("outer").is_some() && told.scope("inner").is_none(), "it is within another");
    assert_eq!(told.value("t"), Some(Value::Number(2.0)), "the first whose left side is t");
    assert_eq!(told.value("L"), Some(Value::Vector(Vec3::X)), "the left side is the symbol");
    assert_eq!([told.value("outer"), told.value("L_a")], [None; 2], "no thing, no right side");
    let printed = outline(&told);
    assert!(printed.contains("outer; inner; t₂; inner; t₂; t = ½; L = L_a; t"), "{printed}");
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
    let outcomes = told.told.all();
    let outcomes = outcomes.iter().map(|scope| (scope.name, scope.outcome, scope.is_open()));
    let expected = [
        ("far", Outcome::Farther(3.0), false),
        ("beside", Outcome::Missed("no root", "D < 0"), false),
        ("near", Outcome::Closest(2.0), true),
        ("mirror", Outcome::Told, true),
        ("mirrored", Outcome::Closest(1.0), true),
    ];
    assert_eq!(outcomes.skip(2).collect::<Vec<_>>(), expected, "what is seen is open at first");
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
    let red = |value: Value| Color::try_from(value).map_or(f32::NAN, |color| color.x);
    let scopes = told.told.all().into_iter().filter(|scope| scope.is_sum());
    let sums = scopes.map(|scope| scope.lines().map(|it| (it.symbol(), red(it.value))).collect());
    let sums: Vec<Vec<(&str, f32)>> = sums.collect();
    // Each by what it is of.
    let of_all = vec![("L_a", 1.0), ("key light", 6.0), ("mirror", 24.0), ("L", 31.0)];
    let expected = [vec![("L_a", 16.0), ("L_d", 32.0), ("L", 48.0)], of_all, vec![("empty", 0.0)]];
    assert_eq!(sums, expected);
}

#[test]
fn numbers_are_shown_in_digits_that_say_something() {
    for (number, shown) in [
        (-0.0, " 0"),
        (-1.5, "-1.5"),
        (1.0 / 3.0, " 0.3333333"),
        (-0.001, "-0.001"),
        (-1e-4, "-1.0000e-4"),
        (99_999.5, " 99999.5"),
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
