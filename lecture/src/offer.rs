//! A setting in the prose: what it is called, and what shows just that.

use std::fmt::Write as _;

use show::Act;
use show::Desk;
use show::Letters;
use show::Program;
use show::Size;
use show::mathml;
use show::plain;

use crate::PROGRAMS;
use crate::escape::escape;
use crate::make;

/// `--camera parallel --set p=10` in a handout of the step called `name`, as what the page makes a button
/// of; none where it is more than the page can do.
pub(crate) fn offer(name: &str, code: &str) -> Option<String> {
    let mut address = format!("#{}", name.get(..6)?);
    let mut words = code.split_whitespace();
    let mut labels: Vec<String> = Vec::new();
    // Whose the next settings are.
    let mut owner = String::new();
    while let Some(flag) = words.next() {
        let _ = match flag {
            "--set" => write!(address, "&{}", words.clone().next()?),
            "--outside" | "--curve" => write!(address, "&{}=on", &flag[2..]),
            "--camera" | "--pixel" | "--size" | "--show" | "--range" | "--what-if" => {
                write!(address, "&{}={}", &flag[2..], words.clone().next()?)
            }
            _ => return None,
        };
        labels.push(match flag {
            "--set" => {
                let setting = words.next()?;
                match setting.split_once('=') {
                    Some(("light" | "sphere", name)) => {
                        owner = format!("{name}.");
                        continue;
                    }
                    _ => equal(&format!("{owner}{setting}")),
                }
            }
            "--what-if" => equal(words.next()?),
            "--show" => formula(words.next()?),
            "--pixel" => format!("pixel {}", escape(&words.next()?.replace(',', ", "))),
            "--outside" | "--curve" => escape(&flag[2..]),
            _ => format!("{} = {}", &flag[2..], escape(words.next()?)),
        });
    }
    let title = escape(code);
    // No line ends between a bracket and what stands in it.
    let span = |label: &String| format!("<span>\u{2060}{label}</span>");
    let labels: Vec<String> = labels.iter().map(span).collect();
    let (label, address) = (labels.join(", "), escape(&shown(name, &address)));
    let offer =
        format!("<a class=\"try\" data-address=\"{address}\" title=\"{title}\">{label}</a>");
    (!labels.is_empty()).then_some(offer)
}

/// `light.x=-4` as an equation.
fn equal(setting: &str) -> String {
    let (name, value) = setting.split_once('=').unwrap_or((setting, ""));
    format!("{} = {}", formula(name), escape(&value.replace('-', "−")))
}

fn formula(name: &str) -> String {
    let is_axis = [".x", ".y", ".z"].iter().any(|axis| name.ends_with(axis));
    let letters = if is_axis { Letters::Vector } else { Letters::Scalar };
    mathml(&plain(name, letters), false, &mut |_, _| None)
}

/// The address of what `address` shows, as the page writes it once that is shown.
fn shown(name: &str, address: &str) -> String {
    let step = PROGRAMS.into_iter().filter(|program| program.name == name);
    let program = |step: crate::Program| Program::new(step.name, "", Size::DEFAULT, make(step));
    let steps: Vec<Program> = step.map(program).collect();
    if steps.is_empty() {
        return address.to_owned();
    }
    let mut desk = Desk::new(steps, 0);
    let _ = desk.act(Act::Open(address.to_owned()));
    desk.shown_address()
}
