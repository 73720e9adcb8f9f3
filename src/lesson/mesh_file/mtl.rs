//! Reading the MTL file beside an OBJ file.

use super::statements::statements;

/// The picture that a material of an MTL file is painted with, by its file's name.
pub fn read_mtl(bytes: &[u8], material: &str) -> Option<String> {
    let text = String::from_utf8_lossy(bytes);
    let mut is_wanted = false;
    let mut found = None;
    for statement in statements(&text) {
        match statement.keyword() {
            "newmtl" => is_wanted = statement.rest() == Some(material),
            "map_Kd" if is_wanted => found = statement.rest().map(str::to_owned),
            _ => {}
        }
    }
    found
}
