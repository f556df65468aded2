//! Markdown on pages.

use maud::{Markup, PreEscaped};
use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, TextMergeStream};

use super::typeset::typeset;

/// A document as a part of a page: without its title, the other headings one level deeper, formulas typeset, and links to
/// the pages instead of the Markdown they are made beside.
pub(super) fn markdown(text: &str) -> Markup {
    let mut within_title = false;
    let events = TextMergeStream::new(Parser::new_ext(text, Options::ENABLE_TABLES));
    let events = events.filter(move |event| {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) => within_title = true,
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => {
                within_title = false;
                return false;
            }
            _ => {}
        }
        !within_title
    });
    let mut html = String::new();
    pulldown_cmark::html::push_html(&mut html, events.map(adapted));
    PreEscaped(html)
}

fn adapted(event: Event<'_>) -> Event<'_> {
    match event {
        Event::Start(Tag::Heading { level, id, classes, attrs }) => {
            Event::Start(Tag::Heading { level: deeper(level), id, classes, attrs })
        }
        Event::End(TagEnd::Heading(level)) => Event::End(TagEnd::Heading(deeper(level))),
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let dest_url = match dest_url.strip_suffix(".md") {
                Some(stem) => CowStr::from(format!("{stem}.html")),
                None => dest_url,
            };
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        Event::Text(text) => Event::InlineHtml(typeset(&text).into_string().into()),
        other => other,
    }
}

fn deeper(level: HeadingLevel) -> HeadingLevel {
    match level {
        HeadingLevel::H1 => HeadingLevel::H2,
        HeadingLevel::H2 => HeadingLevel::H3,
        HeadingLevel::H3 => HeadingLevel::H4,
        HeadingLevel::H4 => HeadingLevel::H5,
        _ => HeadingLevel::H6,
    }
}

#[cfg(test)]
mod tests {
    use super::markdown;

    #[test]
    fn notes_become_a_part_of_a_page() {
        let html =
            markdown("# Title\n\n## A & B\n\nC^2, [all](tables/x.md), `a_b < c`\n").into_string();
        let expected = "<h3>A &amp; B</h3>\n<p>C<sup>2</sup>, <a href=\"tables/x.html\">all</a>, \
                        <code>a_b &lt; c</code></p>\n";
        assert_eq!(html.trim_start(), expected);
    }
}
