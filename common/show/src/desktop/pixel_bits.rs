//! How many bits a display's pixels have, asked before there is a window: minifb ends by a segmentation
//! fault where they are not 32.

use std::env;
use std::fs;
use std::io::Read;
use std::io::Write;
use std::iter;
use std::net::TcpStream;
use std::os::unix::net::UnixStream;
use std::path::PathBuf;
use std::time::Duration;

/// How long a display may take to answer.
const PATIENCE: Duration = Duration::from_secs(2);

/// How one is greeted by whoever may use it.
const COOKIE: &[u8] = b"MIT-MAGIC-COOKIE-1";

/// How many bits the pixels of the X11 display `name` have; none where nobody says so.
pub(super) fn pixel_bits(name: &str) -> Option<u8> {
    let (host, place) = name.rsplit_once(':')?;
    let number = place.split('.').next()?;
    let cookies = cookies(number).unwrap_or_default().into_iter().map(Some);
    cookies.chain(iter::once(None)).find_map(|cookie| {
        let greeting = greeting(cookie.as_deref());
        let setup = match host {
            "" | "unix" => {
                let stream = UnixStream::connect(format!("/tmp/.X11-unix/X{number}")).ok()?;
                stream.set_read_timeout(Some(PATIENCE)).ok()?;
                answer(stream, &greeting)
            }
            _ => {
                let stream =
                    TcpStream::connect((host, number.parse::<u16>().ok()?.checked_add(6000)?))
                        .ok()?;
                stream.set_read_timeout(Some(PATIENCE)).ok()?;
                answer(stream, &greeting)
            }
        };
        bits_of(&setup?)
    })
}

/// What those greet with who may use the display of this number: file by file of xauth(1), each field
/// behind its length.
fn cookies(number: &str) -> Option<Vec<Vec<u8>>> {
    let file = env::var_os("XAUTHORITY").map(PathBuf::from);
    let bytes = fs::read(file.or_else(|| Some(env::home_dir()?.join(".Xauthority")))?).ok()?;
    let (mut rest, mut cookies) = (&bytes[..], Vec::new());
    let field = |rest: &mut &[u8]| {
        let (length, behind) = rest.split_at_checked(2)?;
        let length = usize::from(u16::from_be_bytes(length.try_into().ok()?));
        let (field, behind) = behind.split_at_checked(length)?;
        *rest = behind;
        Some(field.to_vec())
    };
    while let Some((_family, behind)) = rest.split_at_checked(2) {
        rest = behind;
        let [_address, of, name, data] = [(); 4].map(|()| field(&mut rest));
        let is_it = of? == number.as_bytes() && name? == COOKIE;
        cookies.extend(data.filter(|_| is_it));
    }
    Some(cookies)
}

/// The first that a display is told, the lowest byte first.
fn greeting(cookie: Option<&[u8]>) -> Vec<u8> {
    let (name, data) = cookie.map_or((&b""[..], &b""[..]), |cookie| (COOKIE, cookie));
    let length = |bytes: &[u8]| (bytes.len() as u16).to_le_bytes();
    let padded =
        |bytes: &[u8]| [bytes, &[0; 3][..bytes.len().next_multiple_of(4) - bytes.len()]].concat();
    let version = [b'l', 0, 11, 0, 0, 0];
    [&version[..], &length(name), &length(data), &[0; 2], &padded(name), &padded(data)].concat()
}

/// What the display says of itself, if it takes the greeting.
fn answer(mut stream: impl Read + Write, greeting: &[u8]) -> Option<Vec<u8>> {
    let mut head = [0; 8];
    stream.write_all(greeting).ok()?;
    stream.read_exact(&mut head).ok()?;
    let mut setup = vec![0; 4 * usize::from(u16::from_le_bytes([head[6], head[7]]))];
    stream.read_exact(&mut setup).ok()?;
    (head[0] == 1).then_some(setup)
}

/// Of which bits the pixels of the first screen are made: behind the vendor's name stand the formats, with
/// the bits of each depth, and behind these the screens.
fn bits_of(setup: &[u8]) -> Option<u8> {
    let vendor = usize::from(u16::from_le_bytes([*setup.get(16)?, *setup.get(17)?]));
    let formats = setup.get(32 + vendor.next_multiple_of(4)..)?;
    let (formats, screens) = formats.split_at_checked(8 * usize::from(*setup.get(21)?))?;
    let depth = screens.get(38)?;
    formats.chunks(8).find(|format| format[0] == *depth).map(|format| format[1])
}
