//! What a browser calls: it writes a command where [`page_input`] says, runs it, and reads the answer
//! where [`page_output`] says.

use std::cell::RefCell;

use crate::Page;

struct Desk {
    page: Page,
    input: Vec<u8>,
    output: Vec<u8>,
}

thread_local! {
    static DESK: RefCell<Desk> =
        RefCell::new(Desk { page: Page::default(), input: Vec::new(), output: Vec::new() });
}

/// Where a command of `length` bytes is to be written. The memory may grow: look at it afterwards.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_input(length: usize) -> *mut u8 {
    DESK.with_borrow_mut(|desk| {
        desk.input.resize(length, 0);
        desk.input.as_mut_ptr()
    })
}

/// Runs the command that was written. The length of the answer; below zero that of an error.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_run() -> isize {
    DESK.with_borrow_mut(|desk| {
        let (answer, sign) = match desk.page.answer(&desk.input) {
            Ok(answer) => (answer, 1),
            Err(error) => (error.into_bytes(), -1),
        };
        desk.output = answer;
        sign * desk.output.len() as isize
    })
}

/// Where the answer is, until the next command runs.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_output() -> *const u8 {
    DESK.with_borrow(|desk| desk.output.as_ptr())
}

/// What [`f32::powf`] is in a browser, where the linker takes this function in place of Rust's: a
/// picture of step 07 takes 0.93 of the time.
#[expect(unsafe_code, reason = "the linker finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn powf(x: f32, y: f32) -> f32 {
    pxfm::f_powf(x, y)
}
