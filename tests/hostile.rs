//! Hostile input, as the program meets it: the real binary, under limits of memory and of time.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    time::{Duration, Instant},
};

use tempfile::TempDir;

/// Kibibytes of address space, for the program with its libraries.
const MEMORY_KIB: u64 = 2 << 20;
const PATIENCE: Duration = Duration::from_secs(30);

/// A folder of files that a run is given.
struct Desk(TempDir);

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.at(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder is made");
        fs::write(path, content).expect("the file is written");
    }

    /// A lesson of one step in this folder, with these fields in its scene.
    fn lesson(&self, folder: &str, scene: &str, title: &str) {
        let toml = format!(
            "lab = \"frustum\"\nsource = \"none\"\n[scenes.s]\nmethod = \"sphere-cull\"\ncamera = {{ position = [0, 1, 5], target = [0, 0, 0], fov_y_deg = 40, aspect = 1.6, near = 1, far = 12 }}\n{scene}\n[[step]]\nid = \"a\"\nscene = \"s\"\nfigure = \"one\"\n"
        );
        self.write(&format!("{folder}/lesson.toml"), toml);
        self.write(
            &format!("{folder}/en.md"),
            format!("# {title}\n\n## a: A\n\nText.\n"),
        );
    }

    /// The program with these arguments, in this folder, under both limits.
    fn run(&self, args: &[&str]) -> Output {
        let program = env!("CARGO_BIN_EXE_clipscope");
        let script = format!("ulimit -v {MEMORY_KIB}; exec \"$0\" \"$@\"");
        let started = Instant::now();
        let output = Command::new("sh")
            .args(["-c", &script, program])
            .args(args)
            .current_dir(self.0.path())
            .env("HOME", self.0.path())
            .stdin(Stdio::null())
            .output()
            .expect("the program runs");
        let took = started.elapsed();
        assert!(took < PATIENCE, "{args:?} took {took:?}");
        output
    }
}

fn said(output: &Output) -> String {
    let both = [&output.stderr[..], &output.stdout[..]].concat();
    String::from_utf8_lossy(&both).into_owned()
}

/// What it is given, what it is told, and how it ends: 0, 1 or 2.
fn ends(desk: &Desk, args: &[&str], code: i32, says: &str) {
    let output = desk.run(args);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(code), "{args:?}: {said:.2000}");
    assert!(said.contains(says), "{args:?}: {said:.2000}");
    assert!(!said.contains("panicked"), "{args:?}: {said:.2000}");
}

fn mkfifo(path: &Path) {
    let made = Command::new("mkfifo").arg(path).status();
    assert!(made.is_ok_and(|status| status.success()), "a pipe");
}

#[test]
fn what_is_no_file_is_told_what_it_is() {
    let desk = Desk::new();
    mkfifo(&desk.at("pipe.toml"));
    mkfifo(&desk.at("pipe.obj"));
    std::os::unix::fs::symlink("/dev/zero", desk.at("zero.toml")).expect("a link");
    std::os::unix::fs::symlink(desk.at("loop.toml"), desk.at("loop.toml")).expect("a link");
    let huge = fs::File::create(desk.at("huge.toml")).expect("a file");
    huge.set_len(5 << 30).expect("a sparse file");
    let table = [
        ("check pipe.toml", "it is not a file"),
        ("check zero.toml", "it is not a file"),
        ("check loop.toml", "a link that leads to itself"),
        ("check huge.toml", "larger than 128 MiB"),
        ("export huge.toml --out o", "larger than 128 MiB"),
        ("list /dev/zero", "it is not a file"),
        ("open pipe.toml", "it is not a file"),
        ("open pipe.obj", "it is not a file"),
        ("open zero.toml", "it is not a file"),
    ];
    for (args, says) in table {
        ends(&desk, &args.split(' ').collect::<Vec<_>>(), 2, says);
    }
}

#[test]
fn a_mesh_is_read_once_and_its_texture_is_missed_aloud() {
    let desk = Desk::new();
    let objects = "{ mesh = \"x.obj\" }, ".repeat(40);
    desk.lesson("l", &format!("objects = [{objects}]"), "T");
    desk.write(
        "l/x.obj",
        "mtllib x.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    desk.write("l/x.mtl", "newmtl m\nmap_Kd x.png\n");
    desk.write("l/x.png", black_png(8192));
    ends(&desk, &["check", "l"], 0, "without errors");
    for (file, content, says) in [
        (
            "l/x.png",
            &b"\x89PNG no"[..],
            "“x.png” is not a PNG or JPEG",
        ),
        (
            "l/x.mtl",
            b"newmtl m\nmap_Kd ../x.png\n",
            "is not beside the mesh",
        ),
        (
            "l/x.mtl",
            b"newmtl m\nmap_Kd y.png\n",
            "“y.png”: The file cannot be read",
        ),
        ("l/x.mtl", b"newmtl other\n", "has no material “m”"),
    ] {
        desk.write(file, content);
        let output = desk.run(&["check", "l"]);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(0), "{said}");
        assert_eq!(
            said.matches("without its texture").count(),
            1,
            "{said:.3000}"
        );
        assert!(said.contains(says), "{said:.3000}");
    }
    // Two of the largest are more than a scene may have.
    let both = "objects = [{ mesh = \"x.obj\" }, { mesh = \"y.obj\" }]";
    desk.lesson("l", both, "T");
    desk.write(
        "l/y.obj",
        "mtllib y.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    desk.write("l/x.mtl", "newmtl m\nmap_Kd x.png\n");
    desk.write("l/y.mtl", "newmtl m\nmap_Kd y.png\n");
    for name in ["l/x.png", "l/y.png"] {
        desk.write(name, black_png(8192));
    }
    ends(&desk, &["check", "l"], 1, "134,217,728 texels together");
}

/// Each pixel one bit.
fn black_png(side: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side, side);
    encoder.set_depth(png::BitDepth::One);
    let mut writer = encoder.write_header().expect("a header");
    let pixels = vec![0; side as usize * side as usize / 8];
    writer.write_image_data(&pixels).expect("a picture");
    writer.finish().expect("a picture");
    bytes
}

#[test]
fn a_link_out_of_a_lesson_is_not_followed() {
    let desk = Desk::new();
    desk.lesson("l", "objects = [{ mesh = \"x.obj\" }]", "T");
    desk.write("secret.obj", "v 0 0 0\n");
    std::os::unix::fs::symlink(desk.at("secret.obj"), desk.at("l/x.obj")).expect("a link");
    ends(
        &desk,
        &["check", "l"],
        1,
        "leads out of the lesson’s folder",
    );
}

#[test]
fn figures_of_one_name_are_refused_before_anything_is_drawn() {
    let desk = Desk::new();
    for folder in ["A/x-ok", "B/x-ok"] {
        desk.lesson(folder, "objects = [{ solid = \"cube\" }]", "T");
    }
    let output = desk.run(&["export", "A/x-ok", "B/x-ok", "--out", "O"]);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for name in ["A/x-ok", "B/x-ok", "x-ok/one.png"] {
        assert!(said.contains(name), "{said}");
    }
    assert!(!desk.at("O").exists(), "nothing is drawn");
    ends(&desk, &["export", "A/x-ok", "--out", "O"], 0, "1 figure");
    desk.write("file", "");
    ends(
        &desk,
        &["export", "A/x-ok", "--out", "file"],
        2,
        "not a folder",
    );
}

#[test]
fn what_is_too_long_or_too_deep_has_its_place() {
    let desk = Desk::new();
    desk.lesson("l", "objects = [{ solid = \"cube\" }]", "T");
    let steps = (0..100_000).map(|i| format!("[[step]]\nid = \"s{i}\"\n"));
    let toml = format!(
        "lab = \"lines\"\nsource = \"n\"\n{}",
        steps.collect::<String>()
    );
    desk.write("many/lesson.toml", toml);
    desk.write("many/en.md", "# T\n");
    ends(&desk, &["check", "many"], 1, "more than 1000");
    let letters = "x".repeat(4_000_000);
    desk.write("l/en.md", format!("# T\n\n## a: A\n\n{letters}\n"));
    ends(&desk, &["check", "l"], 1, "en.md:5:1");
    let bold = "**a**".repeat(300_000);
    desk.write("l/en.md", format!("# T\n\n## a: A\n\n{bold}\n"));
    ends(&desk, &["check", "l"], 1, "more than 20,000");
    let deep = format!("window = {}1{}", "[".repeat(200), "]".repeat(200));
    desk.write("deep.toml", deep);
    ends(&desk, &["check", "deep.toml"], 1, "deep.toml:1:");
    ends(&desk, &["check", "deep.toml"], 1, "nested too deep");
}

#[test]
fn no_escape_sequence_reaches_the_terminal() {
    let desk = Desk::new();
    let title = "T\u{1b}]0;pwn\u{7}";
    desk.lesson("l", "objects = [{ solid = \"cube\" }]", title);
    for args in [vec!["list", "l"], vec!["check", "l", "--filled"]] {
        let output = desk.run(&args);
        assert!(
            !output.stdout.contains(&0x1b),
            "{args:?}: {}",
            said(&output)
        );
        assert!(said(&output).contains("pwn"), "{args:?}");
    }
}

/// A long text's places are not those of a short one.
#[test]
fn of_several_lessons_each_is_read_from_its_own_folder() {
    let desk = Desk::new();
    let objects = "objects = [{ solid = \"cube\" }]";
    desk.lesson("long", objects, &"A long title ".repeat(40));
    desk.lesson("short", objects, "Short");
    let output = desk.run(&["check", "short", "long", "short", "--filled"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert_eq!(said(&output).matches("Short").count(), 2);
}

#[test]
fn a_filter_fits_a_pipeline() {
    let desk = Desk::new();
    ends(&desk, &["trace"], 0, "");
    desk.write("cases", "\n{\"id\":1,\"algorithm\":\"liang-barski\"}\n");
    ends(
        &desk,
        &["trace", "cases"],
        1,
        "Did you mean “liang-barsky”?",
    );
    ends(&desk, &["trace", "cases", "--refused-ok"], 0, "\"line\":2");
    let full = |args: &[&str]| {
        let full = fs::OpenOptions::new().write(true).open("/dev/full");
        let mut command = Command::new(env!("CARGO_BIN_EXE_clipscope"));
        command
            .args(args)
            .current_dir(desk.0.path())
            .stdin(Stdio::null());
        command
            .stdout(full.expect("a full disk"))
            .stderr(Stdio::null());
        command.status().expect("the program runs").code()
    };
    for args in [
        vec!["--help"],
        vec!["--version"],
        vec!["list"],
        vec!["trace", "--schema"],
    ] {
        assert_eq!(full(&args), Some(2), "{args:?}");
    }
    assert_eq!(full(&["trace", "cases"]), Some(2));
    assert_eq!(full(&["check"]), Some(2));
}

/// One outline with so many teeth, each longer than all teeth together are wide: upright, or lying.
fn comb(n_teeth: usize, is_lying: bool) -> String {
    let width = 2 * n_teeth;
    let mut points = vec![[0.0, -1.0], [width as f64, -1.0]];
    for i in (0..n_teeth).rev() {
        let [x, tip] = [2.0 * i as f64, width as f64 + 1.0];
        points.extend([
            [x + 1.6, 0.0],
            [x + 1.5, tip],
            [x + 0.6, tip],
            [x + 0.5, 0.0],
        ]);
    }
    if is_lying {
        points = points
            .iter()
            .rev()
            .map(|[x, y]| [y - 0.5, x + 0.1])
            .collect();
    }
    format!("{points:?}")
}

fn on_raster(algorithm: &str, size: [u32; 2], triangles: &str) -> String {
    format!(
        r#"{{"algorithm":"{algorithm}","size":{size:?},"frustum":{{"fov_y_deg":90,"aspect":1,"near":1,"far":100}},{triangles}}}"#
    )
}

/// Triangles that fill the picture, each behind the one before.
fn fills(n: usize) -> Vec<String> {
    let depth = |i: usize| -1.5 - 0.01 * i as f64;
    let fill = |z: f64| format!("[[-100,-100,{z}],[100,-100,{z}],[0,150,{z}]]");
    (0..n).map(|i| fill(depth(i))).collect()
}

#[test]
fn work_beyond_a_budget_is_refused_before_it_takes_long() {
    let desk = Desk::new();
    let (whole, many) = ([4096, 4096], fills(2000));
    let triangles = format!(r#""triangles":[{}]"#, many.join(","));
    let one = format!(r#""triangles":[{}]"#, many[0]);
    let objects = format!(r#""objects":[[{}]]"#, many.join("],["));
    let combs = |n: usize| {
        let (clip, polygon) = (comb(n, true), comb(n, false));
        format!(r#"{{"algorithm":"weiler-atherton","clip":{clip},"polygon":{polygon}}}"#)
    };
    let too_many = "The run would have more than";
    for (case, code, says) in [
        (
            on_raster("depth-buffer", [2048, 2048], &one),
            0,
            "\"depth\":[",
        ),
        (
            on_raster("ray-casting", [320, 240], &triangles),
            0,
            "\"counts\"",
        ),
        (on_raster("painter", whole, &triangles), 1, too_many),
        (
            on_raster("occlusion", whole, &objects),
            1,
            "The triangles cover 33,554,432,000 pixels",
        ),
        (
            format!(
                r#"{{"algorithm":"ear-clipping","polygon":{}}}"#,
                comb(12_500, false)
            ),
            0,
            "\"vertices\"",
        ),
        (combs(500), 0, "\"relation\":\"crossing\""),
        (combs(2000), 1, too_many),
    ] {
        desk.write("case", &case);
        let output = desk.run(&["trace", "case", "--events", "false"]);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(code), "{case:.200}: {said:.500}");
        assert!(said.contains(says), "{case:.200}: {said:.500}");
    }
}
