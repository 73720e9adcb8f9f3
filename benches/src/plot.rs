//! A plain plot of times against sizes, both logarithmic, as SVG.

use std::{fmt::Write as _, fs, path::Path};

/// One plot: the same sizes for every curve.
pub struct Panel {
    pub title: &'static str,
    /// What the sizes are.
    pub of: &'static str,
    /// Name and microseconds.
    pub curves: Vec<(&'static str, Vec<f64>)>,
}

const WIDTH: f64 = 330.0;
const HEIGHT: f64 = 300.0;
const MARGIN: [f64; 2] = [52.0, 44.0];
/// Told apart by dash and marker, not by colour alone.
const STYLES: [(&str, &str, char); 4] = [
    ("#0b62c4", "none", '●'),
    ("#0b62c4", "5 3", '○'),
    ("#b3541e", "none", '■'),
    ("#3b7d23", "2 3", '▲'),
];

/// Draws panels side by side into a file beside the benchmarks' manifest.
pub fn save(name: &str, sizes: &[f64], panels: &[Panel]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    match fs::write(&path, growth(sizes, panels)) {
        Ok(()) => println!("\nDrawn in `benches/{name}`.\n"),
        Err(error) => eprintln!("{}: {error}", path.display()),
    }
}

fn growth(sizes: &[f64], panels: &[Panel]) -> String {
    let all = || {
        panels
            .iter()
            .flat_map(|panel| &panel.curves)
            .flat_map(|(_, curve)| curve)
            .copied()
    };
    let low = all().fold(f64::INFINITY, f64::min).log10().floor();
    let high = all().fold(0.0, f64::max).log10().ceil();
    let mut svg = String::new();
    let width = WIDTH * panels.len() as f64;
    let _ = writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{HEIGHT}" viewBox="0 0 {width} {HEIGHT}" font-family="sans-serif" font-size="11"><rect width="100%" height="100%" fill="white"/>"#
    );
    for (i, panel) in panels.iter().enumerate() {
        draw(&mut svg, sizes, panel, i as f64 * WIDTH, [low, high]);
    }
    svg.push_str("</svg>\n");
    svg
}

fn draw(svg: &mut String, sizes: &[f64], panel: &Panel, left: f64, [low, high]: [f64; 2]) {
    let [x0, x1] = [sizes[0], sizes[sizes.len() - 1]].map(f64::log10);
    let x_at =
        |n: f64| left + MARGIN[0] + (n.log10() - x0) / (x1 - x0) * (WIDTH - MARGIN[0] - 22.0);
    let y_at = |us: f64| {
        HEIGHT - MARGIN[1] - (us.log10() - low) / (high - low) * (HEIGHT - MARGIN[1] - 30.0)
    };
    let _ = writeln!(
        svg,
        r#"<text x="{:.1}" y="16" font-weight="bold">{}</text>"#,
        left + MARGIN[0],
        panel.title
    );
    for decade in low as i32..=high as i32 {
        let y = y_at(10f64.powi(decade));
        let label = match decade {
            ..0 => format!("{} ns", 10_i32.pow((decade + 3).max(0) as u32)),
            0..3 => format!("{} µs", 10_i32.pow(decade as u32)),
            3..6 => format!("{} ms", 10_i32.pow(decade as u32 - 3)),
            _ => format!("{} s", 10_i32.pow(decade as u32 - 6)),
        };
        let [from, to] = [x_at(sizes[0]), x_at(sizes[sizes.len() - 1])];
        let _ = writeln!(
            svg,
            r##"<path d="M{from:.1} {y:.1}H{to:.1}" stroke="#ddd"/><text x="{:.1}" y="{:.1}" text-anchor="end">{label}</text>"##,
            from - 6.0,
            y + 4.0
        );
    }
    for &n in sizes {
        let _ = writeln!(
            svg,
            r#"<text x="{:.1}" y="{:.1}" text-anchor="middle">{n}</text>"#,
            x_at(n),
            HEIGHT - 26.0
        );
    }
    let _ = writeln!(
        svg,
        r#"<text x="{:.1}" y="{:.1}" text-anchor="middle">{}</text>"#,
        left + WIDTH / 2.0,
        HEIGHT - 8.0,
        panel.of
    );
    for (k, ((name, curve), (colour, dash, marker))) in panel.curves.iter().zip(STYLES).enumerate()
    {
        let points: Vec<String> = sizes
            .iter()
            .zip(curve)
            .map(|(&n, &us)| format!("{:.1},{:.1}", x_at(n), y_at(us)))
            .collect();
        let _ = writeln!(
            svg,
            r#"<polyline points="{}" fill="none" stroke="{colour}" stroke-width="1.6" stroke-dasharray="{dash}"/>"#,
            points.join(" ")
        );
        for (&n, &us) in sizes.iter().zip(curve) {
            let _ = writeln!(
                svg,
                r#"<text x="{:.1}" y="{:.1}" text-anchor="middle" fill="{colour}">{marker}</text>"#,
                x_at(n),
                y_at(us) + 4.0
            );
        }
        let y = 34.0 + 14.0 * k as f64;
        let _ = writeln!(
            svg,
            r#"<text x="{:.1}" y="{y}" fill="{colour}">{marker} {name}</text>"#,
            left + MARGIN[0] + 8.0
        );
    }
}
