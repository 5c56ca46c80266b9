//! HTML as the page writes it: its elements, and what stands in them.

/// A piece of a page between a tag and the one that closes it.
#[derive(Clone, Copy)]
pub(crate) struct Element<'a> {
    tag: &'a str,
    pub(crate) inner: &'a str,
}

/// All elements of `html` in the order of their tags.
///
/// # Panics
///
/// When a tag is not closed, or another one is before it.
pub(crate) fn elements(html: &str) -> Vec<Element<'_>> {
    let (mut found, mut open): (Vec<Element<'_>>, Vec<(usize, usize)>) = (Vec::new(), Vec::new());
    let mut at = 0;
    while let Some(start) = html[at..].find('<').map(|start| at + start) {
        let end = start + html[start..].find('>').expect("a tag ends");
        let tag = &html[start + 1..end];
        at = end + 1;
        if let Some(name) = tag.strip_prefix('/') {
            let (place, inside) = open.pop().expect("what ends has begun");
            assert_eq!(found[place].name(), name, "…{}", &html[inside..start]);
            found[place].inner = &html[inside..start];
        } else if is_name(tag) {
            let element = Element { tag, inner: "" };
            let name = element.name();
            found.push(element);
            if !tag.ends_with('/') && !["br", "hr", "input", "link", "meta"].contains(&name) {
                open.push((found.len() - 1, at));
            }
            if ["script", "style"].contains(&name) {
                at += html[at..].find(&format!("</{name}>")).expect("it ends");
            }
        } else {
            assert!(!tag.starts_with("!--"), "a comment: {tag}");
            // A sign of its own, or what kind of file it is.
            at = start + 1;
        }
    }
    assert_eq!(open, [], "not closed");
    found
}

fn is_name(tag: &str) -> bool {
    tag.starts_with(|first: char| first.is_ascii_alphabetic())
}

impl<'a> Element<'a> {
    pub(crate) fn name(&self) -> &'a str {
        self.tag.split([' ', '/']).next().unwrap_or_default()
    }

    /// What an attribute says; none when the element does not have it, and "" when it says nothing.
    pub(crate) fn says(&self, attribute: &str) -> Option<String> {
        let tag = format!("{} ", self.tag);
        if tag.contains(&format!(" {attribute} ")) {
            return Some(String::new());
        }
        let (_, value) = tag.split_once(&format!(" {attribute}=\""))?;
        value.split('"').next().map(plain)
    }

    pub(crate) fn id(&self) -> String {
        self.says("id").unwrap_or_default()
    }

    pub(crate) fn is(&self, class: &str) -> bool {
        self.says("class").is_some_and(|classes| classes.split(' ').any(|each| each == class))
    }

    /// The elements in it.
    pub(crate) fn elements(&self) -> Vec<Element<'a>> {
        elements(self.inner)
    }

    /// What can be read in it.
    pub(crate) fn text(&self) -> String {
        let mut pieces = self.inner.split('<');
        let mut text = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            match piece.split_once('>').filter(|_| is_name(piece.trim_start_matches('/'))) {
                Some((_, after)) => text.push_str(after),
                None => text.extend(["<", piece]),
            }
        }
        plain(&text)
    }
}

/// The first of `elements` that has this id.
pub(crate) fn by_id<'a>(elements: &[Element<'a>], id: &str) -> Element<'a> {
    let found = elements.iter().find(|element| element.id() == id);
    *found.unwrap_or_else(|| panic!("there is no #{id}"))
}

/// `text` without the names that HTML has for signs.
fn plain(text: &str) -> String {
    let signs = [("lt", "<"), ("gt", ">"), ("quot", "\""), ("nbsp", "\u{a0}"), ("amp", "&")];
    let signs = signs.into_iter().map(|(name, sign)| (format!("&{name};"), sign));
    signs.fold(text.to_owned(), |text, (name, sign)| text.replace(&name, sign))
}
