//! Bytes as an OBJ file, and what must hold of whatever is read of it.
#![no_main]

use clipscope::{
    lesson::{read_mtl, read_obj},
    text::{Catalog, Lang},
};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // Marks a hole in a text, so it is not to come from outside.
    if String::from_utf8_lossy(bytes).contains('⟦') {
        return;
    }
    let lang = Lang::ALL[bytes.len() % Lang::ALL.len()];
    let problems = match read_obj("a.obj", bytes) {
        Ok(read) => {
            let mesh = &read.mesh;
            let n = mesh.positions().len();
            assert!(mesh.uvs().is_empty() || mesh.uvs().len() == n);
            assert!(!mesh.faces().is_empty());
            assert!(
                mesh.faces()
                    .as_flattened()
                    .iter()
                    .all(|&i| (i as usize) < n)
            );
            let numbers = mesh.positions().as_flattened().iter();
            assert!(
                numbers
                    .chain(mesh.uvs().as_flattened())
                    .all(|x| x.is_finite())
            );
            // No triangle comes from nowhere: a face of n corners is n − 2 of them.
            assert!(mesh.faces().len() <= bytes.len());
            let bounds = mesh.bounds().expect("a mesh has vertices");
            assert!((0..3).all(|axis| bounds.min()[axis] <= bounds.max()[axis]));
            if let Some([_, material]) = &read.material {
                let _ = read_mtl(bytes, material);
            }
            read.warnings
        }
        Err(problems) => {
            assert!(!problems.is_empty(), "a refusal says why");
            problems
        }
    };
    for problem in problems {
        let said = problem.render(Catalog::of(lang));
        assert!(said.starts_with("a.obj:") && !said.contains('⟦'), "{said}");
    }
});
