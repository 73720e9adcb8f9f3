//! The one door for files on disk. What is behind a path is asked first, and how large it is; only then it is opened, and never more of
//! it is read than is allowed.

use std::{
    fs::{self, File},
    io::{self, Read},
    path::Path,
};

use super::files::FileError;

/// Read in pieces of this size, after each of which it may be given up.
const PIECE_BYTES: u64 = 1 << 20;

/// What a file holds, of at most `limit` bytes.
pub fn read_file(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    read_file_while(path, limit, &|| true)
}

/// The same; of one that is given up, as much as was read.
pub fn read_file_while(
    path: &Path,
    limit: u64,
    is_wanted: &dyn Fn() -> bool,
) -> Result<Vec<u8>, FileError> {
    ask(path, limit)?;
    let mut bytes = Vec::new();
    // It may have grown since.
    let mut file = File::open(path)?.take(limit + 1);
    while file.by_ref().take(PIECE_BYTES).read_to_end(&mut bytes)? > 0 && is_wanted() {}
    if bytes.len() as u64 > limit {
        return Err(FileError::TooLarge { limit });
    }
    Ok(bytes)
}

/// Could it be read? A pipe is not opened: that would wait for somebody to write into it.
pub fn ask(path: &Path, limit: u64) -> Result<(), FileError> {
    let kind = fs::metadata(path)?;
    if kind.is_dir() {
        return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
    }
    if !kind.is_file() {
        return Err(io::Error::from(io::ErrorKind::InvalidInput).into());
    }
    if kind.len() > limit {
        return Err(FileError::TooLarge { limit });
    }
    Ok(())
}

/// The same as [`read_file`], of a file that has to lie where its path says: a link may not lead to another folder.
pub fn read_inside(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    let file = fs::canonicalize(path)?;
    let folder = path.parent().map(fs::canonicalize).transpose()?;
    if folder.is_some_and(|folder| file.parent() != Some(&*folder)) {
        return Err(FileError::LeadsOut);
    }
    read_file(path, limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_file_or_too_large_is_not_read() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("five"), "12345").unwrap();
        assert_eq!(read_file(&at("five"), 5), Ok(b"12345".to_vec()));
        let too_large = Err(FileError::TooLarge { limit: 4 });
        assert_eq!(read_file(&at("five"), 4), too_large);
        let kinds = [
            (folder.path().to_path_buf(), io::ErrorKind::IsADirectory),
            (at("nothing"), io::ErrorKind::NotFound),
        ];
        for (path, kind) in kinds {
            let Err(FileError::Unreadable(error)) = read_file(&path, 9) else {
                panic!("{} is no file", path.display());
            };
            assert_eq!(error.kind(), kind);
        }
        assert_eq!(read_inside(&at("five"), 5), Ok(b"12345".to_vec()));
    }

    #[cfg(unix)]
    #[test]
    fn devices_loops_and_links_that_lead_out_are_not_followed() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        symlink("/dev/zero", at("zero")).unwrap();
        symlink(at("loop"), at("loop")).unwrap();
        fs::create_dir(at("inner")).unwrap();
        fs::write(at("outer"), "1").unwrap();
        symlink(at("outer"), at("inner/out")).unwrap();
        symlink(at("outer"), at("beside")).unwrap();
        let not_a_file = FileError::from(io::Error::from(io::ErrorKind::InvalidInput));
        assert_eq!(read_file(&at("zero"), 9), Err(not_a_file));
        assert!(matches!(
            read_file(&at("loop"), 9),
            Err(FileError::Unreadable(_))
        ));
        assert_eq!(read_inside(&at("inner/out"), 9), Err(FileError::LeadsOut));
        assert_eq!(read_inside(&at("beside"), 9), Ok(b"1".to_vec()));
    }
}
