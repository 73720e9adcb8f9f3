use super::*;
use crate::{geom::Orbit, text::Lang};

fn read(link: &str) -> Result<Link, LinkError> {
    link.parse()
}

#[test]
fn a_link_is_written_as_it_is_read() {
    let scene =
        "method = \"cohen-sutherland\"\nwindow = [-1, -1, 1, 1]\nsegments = [[-2, -1, 2, 1]]\n";
    let links = [
        Link::to_step("05-intervals", "entering"),
        Link {
            at: "t left #2".parse().ok(),
            beside: Some("liang-barsky".to_owned()),
            lang: Some(Lang::ZhCn),
            theme: Some("projector".to_owned()),
            ..Link::to_step("05-intervals", "entering")
        },
        Link {
            eye: Some(Orbit::new([0.5, -1.0, 0.0], [30.25, 20.0], 5.0, 35.0)),
            ..Link::to(Opens::Scene(scene.to_owned(), None))
        },
        Link::to(Opens::Scene(scene.to_owned(), "课-1/步2".parse().ok())),
    ];
    for link in links {
        let written = link.to_string();
        assert!(written.is_ascii() && !written.contains(' '), "{written}");
        assert_eq!(read(&written), Ok(link), "{written}");
    }
}

#[test]
fn links_are_short_and_can_be_read() {
    let link = Link {
        at: "t left #2".parse().ok(),
        ..Link::to_step("05-intervals", "entering")
    };
    assert_eq!(link.to_string(), "#05-intervals/entering&at=t+left:2");
    // As chats and browsers hand them on.
    for written in [
        "#05-intervals/entering&at=t%20left%3A2",
        " https://example.org/clipscope/?course=a#05-intervals/entering&at=t+left:2\n",
        "#05-intervals/entering&at=t+left:2&later=1&also",
    ] {
        assert_eq!(read(written), Ok(link.clone()), "{written}");
        assert!(Link::is_one(written), "{written}");
    }
    let lesson = read("#05-intervals").expect("a lesson is a link");
    assert_eq!(lesson.to_string(), "#05-intervals");
}

#[test]
fn what_is_wrong_with_a_link_is_said() {
    let value = |key, value: &str| {
        let value = value.to_owned();
        Err(LinkError::Value { key, value })
    };
    let bomb = code::packed(&"a".repeat(code::MOST_TEXT + 1));
    let whole = Link::to(Opens::Scene("window = [0, 0, 1, 1]".to_owned(), None)).to_string();
    let cases = [
        ("", Err(LinkError::Nothing)),
        ("05-intervals/entering", Err(LinkError::Nothing)),
        ("#", Err(LinkError::Nothing)),
        ("#a b", Err(LinkError::Nothing)),
        ("#a/b/c", Err(LinkError::Nothing)),
        ("#x=1", Err(LinkError::Nothing)),
        ("#v2=abc", Err(LinkError::Version("v2".to_owned()))),
        ("#v1=abc", Err(LinkError::Damaged)),
        ("#v1=%zz", Err(LinkError::Damaged)),
        (&whole[..whole.len() - 4], Err(LinkError::Damaged)),
        (&format!("#v1={bomb}"), Err(LinkError::TooLarge)),
        ("#05-intervals&at=", value("at", "")),
        ("#05-intervals&at=t:0", value("at", "t:0")),
        ("#05-intervals&eye=1,2", value("eye", "1,2")),
        (
            "#05-intervals&eye=0,0,0,0,0,NaN,1",
            value("eye", "0,0,0,0,0,NaN,1"),
        ),
        ("#05-intervals&lang=fr", value("lang", "fr")),
        ("#05-intervals&step=a/b/c", value("step", "a/b/c")),
    ];
    for (link, expected) in cases {
        assert_eq!(read(link), expected, "{link:.60}");
    }
    assert_eq!(read(&whole).map(|link| link.to_string()), Ok(whole));
}

#[test]
fn what_could_not_be_read_again_is_not_written() {
    let step: Option<StepName> = "05-intervals/entering".parse().ok();
    for (n_bytes, is_whole) in [(code::MOST_TEXT, true), (code::MOST_TEXT + 1, false)] {
        let scene = Link::to(Opens::Scene("a".repeat(n_bytes), step.clone()));
        let written = scene.fitting().expect("it is on a page of the course");
        assert_eq!(read(&written) == Ok(scene), is_whole, "{n_bytes}");
        let free = Link::to(Opens::Scene("a".repeat(n_bytes), None));
        assert_eq!(free.fitting().is_some(), is_whole, "{n_bytes}");
    }
}

#[test]
fn a_picture_carries_its_link() {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.set_color(png::ColorType::Grayscale);
    with_link(&mut encoder, "#05-intervals/entering").expect("any text");
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[0]).expect("one pixel");
    writer.finish().expect("an end");
    assert!(is_picture(&bytes));
    assert_eq!(link_in(&bytes).as_deref(), Some("#05-intervals/entering"));
    assert_eq!(link_in(&bytes[..20]), None);
    assert_eq!(link_in(b"\x89PNG\r\n\x1a\n"), None);
    let link = "#v1=a&at=x<1";
    let svg = format!("<svg ><metadata>{}</metadata></svg>", link_element(link));
    assert!(is_picture(svg.as_bytes()));
    assert_eq!(link_in(svg.as_bytes()).as_deref(), Some(link));
    assert_eq!(link_in(&svg.as_bytes()[..svg.len() / 2]), None);
    assert_eq!(link_in(b"<svg ></svg>"), None);
}
