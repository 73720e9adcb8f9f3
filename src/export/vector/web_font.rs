//! A font for a web page: the shipped one cut down to the characters in use, with the tables that browsers ask for.

use std::collections::BTreeMap;

use super::face::Face;

/// Tables that are there once a font is cut for documents, which need no more, are joined by these.
const FROM_WHOLE: [&[u8; 4]; 1] = [b"OS/2"];

/// An OpenType file with the glyphs of these characters.
pub fn web_font(face: &Face, chars: impl IntoIterator<Item = char>) -> Vec<u8> {
    let (cut, numbers) = face.cut(chars);
    let mut tables: BTreeMap<[u8; 4], Vec<u8>> = tables(&cut).collect();
    for (tag, table) in self::tables(face.bytes) {
        if FROM_WHOLE.contains(&&tag) {
            tables.insert(tag, table);
        }
    }
    tables.insert(*b"cmap", character_map(&numbers));
    let version = cut.get(..4).unwrap_or(b"OTTO");
    file(version, &tables)
}

fn number(bytes: &[u8]) -> usize {
    bytes
        .iter()
        .fold(0, |sum, &byte| sum << 8 | usize::from(byte))
}

/// Each with its name.
pub fn tables(font: &[u8]) -> impl Iterator<Item = ([u8; 4], Vec<u8>)> {
    let n_tables = font.get(4..6).map_or(0, number);
    let record = move |nth: usize| {
        let record = font.get(12 + 16 * nth..28 + 16 * nth)?;
        let (start, length) = (number(&record[8..12]), number(&record[12..16]));
        let table = font.get(start..start.checked_add(length)?)?;
        Some((*record.first_chunk()?, table.to_vec()))
    };
    (0..n_tables).filter_map(record)
}

/// Format 12: each character by itself.
fn character_map(numbers: &BTreeMap<char, u16>) -> Vec<u8> {
    let mut map = Vec::new();
    for half in [0_u16, 1, 3, 10] {
        map.extend(half.to_be_bytes());
    }
    let n_groups = numbers.len() as u32;
    for word in [12, 12 << 16, 16 + 12 * n_groups, 0, n_groups] {
        map.extend(u32::to_be_bytes(word));
    }
    for (&c, &glyph) in numbers {
        for word in [c as u32, c as u32, u32::from(glyph)] {
            map.extend(word.to_be_bytes());
        }
    }
    map
}

fn file(version: &[u8], tables: &BTreeMap<[u8; 4], Vec<u8>>) -> Vec<u8> {
    let n_tables = tables.len() as u16;
    let power = n_tables.max(1).ilog2() as u16;
    let range = 16 << power;
    let mut file = version.to_vec();
    for half in [n_tables, range, power, 16 * n_tables - range] {
        file.extend(half.to_be_bytes());
    }
    let mut start = 12 + 16 * tables.len();
    for (tag, table) in tables {
        file.extend(tag);
        for word in [checksum(table), start as u32, table.len() as u32] {
            file.extend(word.to_be_bytes());
        }
        start += table.len().next_multiple_of(4);
    }
    for table in tables.values() {
        file.extend(table);
        file.resize(file.len().next_multiple_of(4), 0);
    }
    file
}

fn checksum(table: &[u8]) -> u32 {
    let word = |bytes: &[u8]| {
        (0..4).fold(0, |sum, i| {
            sum << 8 | u32::from(*bytes.get(i).unwrap_or(&0))
        })
    };
    table.chunks(4).map(word).fold(0, u32::wrapping_add)
}

#[cfg(test)]
mod tests {
    use egui::FontFamily;
    use skrifa::{FontRef, MetadataProvider};

    use super::*;

    #[test]
    fn each_character_is_found_in_what_is_cut_out() {
        for c in ['x', '₁', '区'] {
            let face = Face::of(&FontFamily::Proportional, c).expect("a face");
            let bytes = web_font(face, ['x', c]);
            assert!(bytes.len() < face.bytes.len(), "{}", face.name);
            let font = FontRef::new(&bytes).expect("a font");
            let glyph = font.charmap().map(c);
            assert!(glyph.is_some_and(|glyph| glyph.to_u32() > 0), "{c}");
            assert_eq!(font.charmap().map('Z'), None);
            assert!(tables(&bytes).any(|(tag, _)| &tag == b"OS/2"));
        }
    }
}
