//! A SCORM 1.2 package: the page as one object that is launched and scored, with a manifest that names every file.

use std::{
    fmt::Write as _,
    fs, io,
    io::{Cursor, Write},
    path::Path,
};

use zip::{CompressionMethod, ZipWriter, write::SimpleFileOptions};

use crate::{
    lesson::{Lesson, Progress},
    text::Lang,
};

/// What a package has no use for: it is not there without its platform, and is no page of its own.
const LEFT_OUT: [&str; 2] = ["sw.js", "example.html"];
const PAGE: &str = "index.html";
/// What SCORM 1.2 keeps of a student, in characters.
pub const MOST_STATE: usize = 4096;

/// How long the marks of these lessons become, where that is more than a platform keeps.
pub fn too_much(lessons: &[Lesson]) -> Option<usize> {
    let lessons: Vec<&Lesson> = lessons.iter().collect();
    let mut all = Progress {
        begun: u64::from(u32::MAX),
        ..Progress::default()
    };
    for lesson in &lessons {
        all.mark_all(lesson);
    }
    let length = all.written_of(&lessons).chars().count();
    (length > MOST_STATE).then_some(length)
}

/// The bytes of the package; the same for the same page.
pub fn package(page: &Path, lessons: &[Lesson], lang: Lang) -> io::Result<Vec<u8>> {
    let mut files = Vec::new();
    walk(page, "", &mut files)?;
    files.retain(|name| !LEFT_OUT.contains(&&**name));
    files.sort();
    if !files.iter().any(|name| name == PAGE) {
        return Err(io::ErrorKind::NotFound.into());
    }
    let stored = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(zip::DateTime::default());
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let mut put = |name: &str, bytes: &[u8]| {
        zip.start_file(name, stored)?;
        zip.write_all(bytes)
    };
    put(
        "imsmanifest.xml",
        manifest(lessons, lang, &files).as_bytes(),
    )?;
    for name in &files {
        put(name, &fs::read(page.join(name))?)?;
    }
    Ok(zip.finish()?.into_inner())
}

fn walk(folder: &Path, before: &str, files: &mut Vec<String>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            walk(&entry.path(), &format!("{name}/"), files)?;
        } else {
            files.push(name);
        }
    }
    Ok(())
}

fn manifest(lessons: &[Lesson], lang: Lang, files: &[String]) -> String {
    let ids: Vec<&str> = lessons.iter().map(|lesson| &*lesson.id).collect();
    let titles: Vec<&str> = lessons.iter().map(|lesson| lesson.title(lang)).collect();
    let title = escaped(&titles.join(" · "));
    let parameters = escaped(&format!("?scorm={}&lang={lang}", ids.join(",")));
    let mut listed = String::new();
    for name in files {
        let _ = writeln!(listed, "      <file href=\"{}\"/>", escaped(name));
    }
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="clipscope-{first}" version="1.0"
  xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
  xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="course">
    <organization identifier="course">
      <title>{title}</title>
      <item identifier="lessons" identifierref="page" isvisible="true" parameters="{parameters}">
        <title>{title}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" adlcp:scormtype="sco" href="{PAGE}">
{listed}    </resource>
  </resources>
</manifest>
"#,
        first = ids.first().copied().unwrap_or_default(),
    )
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Course;
    use std::io::Read;

    #[test]
    fn a_package_names_every_file_that_is_in_it() {
        let page = tempfile::tempdir().unwrap();
        for name in ["index.html", "sw.js", "a-0.js"] {
            fs::write(page.path().join(name), name).unwrap();
        }
        fs::create_dir(page.path().join("licences")).unwrap();
        fs::write(page.path().join("licences/MIT"), "MIT").unwrap();
        let course = Course::embedded();
        let bytes = package(page.path(), &course.lessons[..2], Lang::Es).unwrap();
        assert_eq!(
            bytes,
            package(page.path(), &course.lessons[..2], Lang::Es).unwrap()
        );
        let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let mut names: Vec<String> = zip
            .file_names()
            .map(|name| name.unwrap().into_owned())
            .collect();
        names.sort();
        assert_eq!(
            names,
            ["a-0.js", "imsmanifest.xml", "index.html", "licences/MIT"]
        );
        let mut manifest = String::new();
        let mut file = zip.by_name("imsmanifest.xml").unwrap();
        file.read_to_string(&mut manifest).unwrap();
        for name in names.iter().filter(|name| *name != "imsmanifest.xml") {
            assert!(
                manifest.contains(&format!("<file href=\"{name}\"/>")),
                "{name}"
            );
        }
        let launched = format!(
            "?scorm={},{}&amp;lang=es",
            course.lessons[0].id, course.lessons[1].id
        );
        assert!(manifest.contains(&launched), "{manifest}");
    }

    #[test]
    fn what_a_platform_keeps_has_room_for_a_chapter() {
        let course = Course::embedded();
        assert_eq!(too_much(&course.lessons[..8]), None);
        assert!(too_much(&course.lessons).is_some_and(|length| length > 10_000));
    }

    #[test]
    fn a_folder_without_a_page_makes_no_package() {
        let empty = tempfile::tempdir().unwrap();
        let made = package(empty.path(), &Course::embedded().lessons[..1], Lang::En);
        assert_eq!(made.unwrap_err().kind(), io::ErrorKind::NotFound);
    }
}
