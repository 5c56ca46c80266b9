//! What a browser calls: it writes a question where [`page_input`] says, asks it, and reads the answer
//! where [`page_output`] says.

use std::cell::RefCell;

use page::Page;

/// What goes between the page and the browser.
struct Exchange {
    page: Page,
    input: Vec<u8>,
    output: Vec<u8>,
}

thread_local! {
    static EXCHANGE: RefCell<Exchange> =
        RefCell::new(Exchange { page: crate::page(), input: Vec::new(), output: Vec::new() });
}

/// Where a question of `length` bytes is to be written. The memory may grow: look at it afterwards.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_input(length: usize) -> *mut u8 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.input.resize(length, 0);
        exchange.input.as_mut_ptr()
    })
}

/// Asks the question that was written. The length of the answer; below zero that of an error.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_run() -> isize {
    EXCHANGE.with_borrow_mut(|exchange| {
        let (answer, sign) = match exchange.page.answer(&exchange.input) {
            Ok(answer) => (answer, 1),
            Err(error) => (error.into_bytes(), -1),
        };
        exchange.output = answer;
        sign * exchange.output.len() as isize
    })
}

/// Where the answer is, until the next question.
#[expect(unsafe_code, reason = "the browser finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn page_output() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.output.as_ptr())
}

/// What [`f32::powf`] is in a browser, where the linker takes this function in place of Rust's: a
/// picture of step 07 takes 0.93 of the time.
#[expect(unsafe_code, reason = "the linker finds the function by its name")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn powf(x: f32, y: f32) -> f32 {
    pxfm::f_powf(x, y)
}
