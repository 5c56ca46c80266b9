//! The symbols that mistakes listen for. Nothing else is listened for, so that whoever gives a line of
//! a step another symbol is told by a test, which looks for all of these.

use std::marker::PhantomData;

use common::Value;
use common::Vec3;
use telling::Line;

/// A symbol whose value is a `T`.
pub(crate) struct Symbol<T> {
    name: &'static str,
    value: PhantomData<T>,
}

impl<T> Clone for Symbol<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Symbol<T> {}

impl<T: TryFrom<Value>> Symbol<T> {
    /// The value that `line` gives it, if that is what it is about.
    pub(crate) fn of(self, line: &Line) -> Option<T> {
        self.named(line.symbol(), line.value)
    }

    fn named(self, symbol: &str, value: Value) -> Option<T> {
        if symbol == self.name { value.try_into().ok() } else { None }
    }
}

impl<T: TryFrom<Value> + Into<Value>> Symbol<T> {
    /// What `other` makes of the `value` told of `symbol`, if that is this one.
    pub(crate) fn told_otherwise(
        self, symbol: &str, value: Value, other: impl FnOnce(T) -> Option<T>,
    ) -> Option<Value> {
        other(self.named(symbol, value)?).map(Into::into)
    }
}

macro_rules! symbols {
    ($($symbol:ident: $type:ty = $name:literal;)*) => {
        $(pub(crate) const $symbol: Symbol<$type> = Symbol { name: $name, value: PhantomData };)*

        /// All of them, each with whether a line is about it.
        pub const SYMBOLS: &[(&str, fn(&Line) -> bool)] =
            &[$(($name, |line| Symbol::<$type> { name: $name, value: PhantomData }.of(line).is_some())),*];
    };
}

symbols! {
    BACKGROUND: Vec3 = "background";
    RADIANCE: Vec3 = "L";
    A: f32 = "a";
    B: f32 = "b";
    Q_SQUARED: f32 = "q²";
    D: f32 = "D";
    ROOT: f32 = "√D";
    T_1: f32 = "t₁";
    T_2: f32 = "t₂";
    T: f32 = "t";
    ALPHA: f32 = "α";
    BETA: f32 = "β";
    GAMMA: f32 = "γ";
    POINT: Vec3 = "point";
    NORMAL: Vec3 = "normal";
    T_MAX: f32 = "t_max";
    VISIBLE: f32 = "V";
    K_A: Vec3 = "k_a";
    I_A: f32 = "I_a";
    L_A: Vec3 = "L_a";
    TO_VIEWER: Vec3 = "v";
    N: Vec3 = "n";
    TO_LIGHT: Vec3 = "l";
    N_DOT_L: f32 = "n·l";
    R_SQUARED: f32 = "r²";
    IRRADIANCE: f32 = "I/r²";
    K_D: Vec3 = "k_d";
    L_D: Vec3 = "L_d";
    H: Vec3 = "h";
    N_DOT_H: f32 = "n·h";
    EXPONENT: f32 = "p";
    HIGHLIGHT: f32 = "max(0, n·h)^p";
    K_S: f32 = "k_s";
    L_S: Vec3 = "L_s";
}
