//! Accepted pictures, and what a test says of one that differs.

use std::{
    env, fs,
    path::{Path, PathBuf},
};

use clipscope::paint::Image;

use super::say_left_out;

/// Pictures that are accepted, and the folder for those that differ.
pub struct Pictures {
    accepted: PathBuf,
    /// The crate's package has none of the accepted pictures, only the repository has.
    are_absent: bool,
    failed: PathBuf,
    bless: bool,
    known: Vec<PathBuf>,
    complaints: Vec<String>,
}

impl Pictures {
    /// Those below `tests/<name>`; what differs goes to `target/<name>`.
    pub fn of(name: &str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let accepted = root.join("tests").join(name);
        let bless = env::var_os("CLIPSCOPE_BLESS").is_some();
        Self {
            are_absent: !bless && !accepted.exists(),
            accepted,
            failed: root.join("target").join(name),
            bless,
            known: Vec::new(),
            complaints: Vec::new(),
        }
    }

    /// Compares a picture with the accepted one. Where they differ, the accepted one, the new one and their difference
    /// are written beside each other, unless the new one is to be accepted.
    pub fn check(&mut self, path: &str, png: &[u8]) {
        let accepted = self.accepted.join(path);
        let old = fs::read(&accepted).ok();
        self.known.push(accepted.clone());
        // What a file says besides its pixels, its link, is no part of the picture.
        let is_same = |old: &Vec<u8>| old == png || decode(old) == decode(png);
        if self.are_absent || old.as_ref().is_some_and(is_same) {
            return;
        }
        if self.bless {
            write(&accepted, png);
            return;
        }
        let beside = |what: &str| self.failed.join(path).with_extension(format!("{what}.png"));
        write(&beside("new"), png);
        let complaint = match old {
            None => format!("{path}: no picture has been accepted"),
            Some(old) => {
                write(&beside("accepted"), &old);
                let (n_differing, difference) = difference(&decode(&old), &decode(png));
                write(&beside("difference"), &difference.to_png());
                format!("{path}: {n_differing} pixels differ")
            }
        };
        self.complaints.push(complaint);
    }

    /// Fails with all that differed, or was accepted once and is drawn no more. Where the whole folder is missing, it
    /// says so and passes.
    pub fn finish(mut self) {
        if self.are_absent {
            let (n, folder) = (self.known.len(), self.accepted.display());
            say_left_out(&format!(
                "{n} pictures were drawn and compared with none: {folder} is missing. The package leaves it out, \
                 the repository has it. CLIPSCOPE_BLESS=1 accepts the pictures as they are drawn now."
            ));
        }
        for path in pictures_below(&self.accepted) {
            if self.known.contains(&path) {
                continue;
            }
            if self.bless {
                fs::remove_file(&path).unwrap();
            } else {
                self.complaints
                    .push(format!("{}: is drawn no more", path.display()));
            }
        }
        assert!(
            self.complaints.is_empty(),
            "these pictures differ from {}; accepted, new and difference lie in {}: {:#?}",
            self.accepted.display(),
            self.failed.display(),
            self.complaints
        );
    }
}

fn write(path: &Path, png: &[u8]) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, png).unwrap();
}

fn decode(png: &[u8]) -> Image {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgb).unwrap();
    let pixels = rgb[..info.buffer_size()].as_chunks::<3>().0.iter();
    Image {
        size: [info.width as usize, info.height as usize],
        rgba: pixels.flat_map(|&[r, g, b]| [r, g, b, 255]).collect(),
    }
}

/// How many pixels differ; and the old picture, pale, with those in red. Pictures of two sizes differ everywhere.
fn difference(old: &Image, new: &Image) -> (usize, Image) {
    let mut n_differing = 0;
    let size = [0, 1].map(|i| old.size[i].max(new.size[i]));
    let at = |image: &Image, x: usize, y: usize| {
        let is_inside = x < image.size[0] && y < image.size[1];
        is_inside.then(|| image.rgba.as_chunks::<4>().0[y * image.size[0] + x])
    };
    let mut rgba = Vec::with_capacity(4 * size[0] * size[1]);
    for y in 0..size[1] {
        for x in 0..size[0] {
            let (old, new) = (at(old, x, y), at(new, x, y));
            if old == new {
                let pale = |byte: u8| 191 + byte / 4;
                let [r, g, b, _] = old.unwrap_or([255; 4]);
                rgba.extend([pale(r), pale(g), pale(b), 255]);
            } else {
                n_differing += 1;
                rgba.extend([216, 0, 0, 255]);
            }
        }
    }
    (n_differing, Image { size, rgba })
}

fn pictures_below(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    entries
        .map(|entry| entry.unwrap().path())
        .flat_map(|path| {
            if path.is_dir() {
                pictures_below(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}
