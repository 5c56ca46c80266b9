//! What can be done in a class, and what a shell is then asked to do.

use std::fmt;

use crate::Handle;
use crate::Language;
use crate::SettingError;
use crate::Size;
use crate::control::Refused;
use telling::LineName;

/// Something that is done in a class, however it was asked for.
///
/// Places in the picture are shares of its width from the left and of its height from the top.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// The control takes the value that the text names, as `--set NAME=VALUE` does; the onlooker's are
    /// called `outside.azimuth` and so on.
    Set(String, String),
    /// The control goes to this part of its range, 0 to 1.
    Fraction(String, f32),
    /// The control goes so many steps of a key on.
    Nudge(String, f32),
    /// The control takes its first value.
    Reset(String),
    /// The stop as it is written; away from one, all controls take their first values.
    ResetAll,
    /// The camera, or the onlooker where there is one, circles by these degrees: right, up.
    Orbit(f32, f32),
    /// It goes to this part of its distance.
    Zoom(f32),
    /// The handle goes to a place in the picture.
    Drag(Handle, (f32, f32)),
    /// The pixel at a place in the picture is pinned.
    Pin((f32, f32)),
    /// The pixel of this column and row is.
    PinPixel(usize, usize),
    /// The pin goes so many pixels right and down; without one, to the middle.
    MovePin(isize, isize),
    /// No pixel is pinned any more.
    Unpin,
    /// The camera is seen from outside, or looked through again.
    Outside,
    /// The pinned pixel's rays and vectors are shown, or hidden.
    Vectors,
    /// What can be dragged in the picture is shown without a pin, too, or hidden.
    Handles,
    /// Another step, by its number from 1 on, seen as this one is.
    Step(usize),
    /// The next stop.
    Next,
    /// The stop before.
    Previous,
    /// The stop of this number, from 1 on.
    Stop(usize),
    /// The stop's question, then its answer, then its text again.
    Ask,
    /// So far on in the list of stops and figures.
    Pick(isize),
    /// To what is at this place of the list.
    Listed(usize),
    /// Nothing is to be seen, or all again.
    Blank,
    /// The controls and the view on their way from what was shown before the stop: this part of it.
    Glide(f32),
    /// The step before takes this one's place, or no more.
    Hold(bool),
    /// A divider, left of which is the step before; or none.
    Divide,
    /// The divider goes to this part of the width.
    DivideAt(f32),
    /// How far each pixel is from the step before's; or no more.
    Difference,
    /// A text in place of the pixel's explanation; if it is shown, no more.
    Read(Reading),
    /// The code is shown to the letter, with its telling, or without it again.
    Whole,
    /// The next light or object is looked at in the code.
    Look,
    /// The picture becomes this told line's at every pixel; if it is, the light's again.
    Show(LineName),
    /// The same of the line of this name.
    ShowNamed(String),
    /// The shown numbers are told apart from one to another, such as `0,20`.
    Range(String),
    /// The shown quantity is seen as a curve too, along the row of the pinned pixel, or no more.
    Curve,
    /// The line is the one that keys act on.
    Choose(LineName),
    /// The line is answered otherwise, to begin with as it is, or where it is 0 or 1 as it
    /// is not; if it is already, no more.
    WhatIf(LineName),
    /// A line takes the value that the text names, such as `V=1`.
    Answer(String),
    /// So many lines on in what is told of the pinned pixel.
    Walk(isize),
    /// The chosen line becomes the picture.
    ShowLine,
    /// The chosen line, or the one that is shown, is answered otherwise.
    WhatIfLine,
    /// The picture alone, or with all beside it.
    Alone,
    /// The next of the languages.
    NextLanguage,
    /// This language.
    Speak(Language),
    /// Pictures are saved at this size.
    Size(Size),
    /// The command that gives this picture.
    Command,
    /// The picture as a file.
    Save,
    /// What was shown last goes: a text, then the pin.
    Leave,
    /// What an address says, from its `#` on, in place of all that is shown.
    Open(String),
}

impl Act {
    /// Whether a hand asks for it, so that a black screen is one no more.
    pub(super) fn wakes(&self) -> bool {
        !matches!(self, Self::Hold(false) | Self::Choose(_) | Self::Glide(_) | Self::Size(_))
    }

    /// Whether it goes to something else, also from a black screen.
    pub(super) fn goes_on(&self) -> bool {
        matches!(
            self,
            Self::Next | Self::Previous | Self::Stop(_) | Self::Listed(_) | Self::Open(_)
        )
    }
}

/// What is read in place of the pinned pixel's explanation.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub enum Reading {
    /// The explanation itself.
    #[default]
    Pixel,
    /// All keys.
    Keys,
    /// The step's code.
    Code,
    /// The step's equation and idea.
    Idea,
    /// All stops, and all figures.
    Stops,
}

/// What a shell is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Make the pictures anew, and then [`Repaint`](Self::Repaint): they are not those that are
    /// shown.
    Redraw,
    /// Show anew what is shown beside and over the pictures.
    Repaint,
    /// Show these words, until something else is done.
    Say(String),
    /// Print a text that ends with a line break.
    Print(String),
    /// Make the pictures at their own size, write them to a file, and say what became of it.
    Save,
    /// Glide to what is shown now, if there is a clock: by [`Act::Glide`].
    Glide,
}

/// Why something cannot be done; then nothing has changed.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// A control is not there, or does not take the value.
    Setting(SettingError),
    /// Anything else, in one sentence.
    Because(String),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Setting(error) => error.fmt(f),
            Self::Because(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Refusal {}

impl From<SettingError> for Refusal {
    fn from(error: SettingError) -> Self {
        Self::Setting(error)
    }
}

impl From<Refused> for Refusal {
    fn from(refused: Refused) -> Self {
        Self::Setting(SettingError::Refused(refused))
    }
}

impl From<&str> for Refusal {
    fn from(reason: &str) -> Self {
        Self::Because(reason.to_owned())
    }
}

impl From<String> for Refusal {
    fn from(reason: String) -> Self {
        Self::Because(reason)
    }
}
