use common::Size;

/// A key that a session understands.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Key {
    /// The arrow.
    Up,
    /// The arrow.
    Down,
    /// The arrow.
    Left,
    /// The arrow.
    Right,
    /// To the start.
    Home,
    /// Takes one thing back.
    Backspace,
    /// The same as [`Backspace`](Self::Backspace).
    Delete,
    /// The space bar.
    Space,
    /// The large key.
    Enter,
    /// Leaves.
    Escape,
    /// The one beside Q.
    Tab,
    /// To the step before.
    PageUp,
    /// To the next step.
    PageDown,
    /// F1 and so on.
    F(u8),
    /// What the key writes, as a capital letter: `P`, `3`, `+`.
    Char(char),
}

/// What a session is told.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A key went down, with or without Shift.
    Key(Key, bool),
    /// A key went up.
    KeyUp(Key),
    /// The mouse button went down there, in pixels of the window from its upper left corner.
    Press(f32, f32),
    /// The mouse is there.
    Move(f32, f32),
    /// The mouse button went up there.
    Release(f32, f32),
    /// The wheel was turned by so many notches: up, or away from the hand, when positive.
    Wheel(f32),
    /// The window has this size.
    Resize(Size),
    /// Keys and mouse went to another window; what is held down there is not known.
    FocusLost,
    /// Something to be said in the window, such as what became of a file.
    Say(String),
}

/// What a session asks its shell to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Make the pictures anew, and then [`Repaint`](Self::Repaint): they are not those that are
    /// shown.
    Redraw,
    /// Paint the window anew.
    Repaint,
    /// Print a text that ends with a line break.
    Print(String),
    /// Make the [`saved`](super::Session::saved) pictures, save what is
    /// [`written`](super::Session::written) of them, and then say what became of it.
    Save,
    /// End.
    Quit,
}

/// The keys and what they do, as the help and the window list them.
pub const KEYS: &[(&str, &str)] = &[
    ("click, Enter, P", "pin the pixel there: how it comes by its colour"),
    ("drag", "orbit; on a slider, change its control"),
    ("wheel", "nearer or further; beside the picture, scroll"),
    ("Up, Down", "select a control or a heading"),
    ("Left, Right", "change it; with Shift in fine steps"),
    ("Backspace", "reset the selected control"),
    ("Home", "reset all controls"),
    ("Space", "the picture alone, or with all beside it"),
    ("+, -", "larger or smaller text"),
    ("V", "show or hide the rays and vectors"),
    ("O", "look from outside the camera, or through it"),
    ("C", "print the command that gives this picture"),
    ("G", "all this in Portuguese"),
    ("F1", "show or hide these keys"),
    ("F2", "save the picture as a new PNG"),
    ("Esc", "unpin; with nothing pinned, quit"),
];

/// What there is in a session of several programs besides.
pub const LECTURE_KEYS: &[(&str, &str)] = &[
    ("Page Down, Up", "the next step, or the one before"),
    ("1, 2, 3 …", "that step"),
    ("Tab", "as long as it is held, the step before"),
    ("D", "the step before left of a line that can be dragged"),
    ("X", "where the step before differs, times 8"),
    ("F3", "this step's diff"),
    ("F4", "the idea in short"),
];
