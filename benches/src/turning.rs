//! Both views of a space while the eye goes round: what is projected, rasterised, coloured and laid out in a frame.

use std::{sync::Arc, time::Instant};

use clipscope::{
    figure::{Body, Edge3, Edging, Facet, Link, Mark3, Role, Seer, Shape3, Space, View},
    geom::{Camera, Matrix, Mesh, Orbit, Solid, ViewVolume},
    paint::{Theme, ThemeKind, fonts, theme},
    text::{Catalog, Lang},
    widgets::{self, Look},
};
use egui::{Context, Event, Modifiers, PointerButton, RawInput, Rect, pos2, vec2};

use crate::{
    harness::{Target, median, quantile},
    plot,
};

const N_FRAMES: usize = 60;
/// About so many triangles.
const GROWTH: [usize; 6] = [1_000, 3_000, 10_000, 30_000, MANY, 300_000];
const MANY: usize = 100_000;
/// Milliseconds: what a screen with 60 pictures a second leaves.
const TARGET: Target = Target::AtMost(16.0);
/// Of five solids, as a lesson has them.
const LESSON_TARGET: Target = Target::AtMost(4.0);
/// Of a window of 1280 × 720: the observer's view, and the camera's in it.
const STAGE: [f32; 2] = [776.0, 464.0];
const INSET: Rect = Rect::from_min_max(pos2(560.0, 320.0), pos2(760.0, 445.0));

/// Runs everything and prints the section.
pub fn run() {
    println!("## A space, while the eye goes round\n");
    println!(
        "Both views, {} × {} points and a pixel a point, nothing painted; milliseconds of {N_FRAMES} frames.\n",
        STAGE[0], STAGE[1]
    );
    println!("| triangles | edges | median | 95 % | target | |\n|--:|--:|--:|--:|--:|---|");
    row(&five(), LESSON_TARGET);
    let (mut sizes, mut curves) = (Vec::new(), [Vec::new(), Vec::new()]);
    for n in GROWTH {
        let target = if n == MANY { TARGET } else { Target::None };
        let facets = rings(n);
        sizes.push(facets.len() as f64);
        for (curve, millis) in curves.iter_mut().zip(row(&facets, target)) {
            curve.push(1e3 * millis);
        }
    }
    let panel = plot::Panel {
        title: "A frame while the eye goes round",
        of: "triangles",
        curves: ["median", "95 % under"].into_iter().zip(curves).collect(),
    };
    plot::save("turning.svg", &sizes, &[panel]);
}

/// The median and what 95 % are under, in milliseconds.
fn row(facets: &[Facet], target: Target) -> [f64; 2] {
    let mut edges = Edge3::of(facets);
    let n = (facets.len(), edges.len());
    let mut facets = facets.to_vec();
    // As the app does where they are too many.
    if edges.len() > 3_000 {
        edges.clear();
        let edging = Edging::Samples { is_open: false };
        facets.iter_mut().for_each(|facet| facet.edging = edging);
    }
    let millis = frames(facets.into(), edges.into());
    let [half, most] = [median(millis.clone()), quantile(millis, 0.95)];
    println!(
        "| {} | {} | {half:.1} | {most:.1} | {}",
        n.0,
        n.1,
        target.cells(half)
    );
    [half, most]
}

/// Milliseconds of each frame, the pointer being down.
fn frames(facets: Arc<[Facet]>, edges: Arc<[Edge3]>) -> Vec<f64> {
    let ctx = Context::default();
    ctx.set_fonts(fonts::definitions());
    theme::install(&ctx, Theme::of(ThemeKind::Light));
    let look = Look::new(Theme::of(ThemeKind::Light), Catalog::of(Lang::En));
    let stage = Rect::from_min_size(pos2(0.0, 0.0), STAGE.into());
    let volume = ViewVolume::perspective(40.0, 1.6, 1.0, 30.0).expect("a volume");
    let camera =
        Camera::new([-6.0, 5.0, 8.0], [0.0; 3], [0.0, 1.0, 0.0], volume).expect("a camera");
    let view = |id, seer| {
        let corners = volume
            .corners()
            .map(|corner| camera.world_from_view(corner));
        let edges_of_volume = (0..4).map(|i| [corners[i], corners[i + 4]]);
        let lines = edges_of_volume.map(|ends| Mark3::new(Role::Accent, Shape3::Segment(ends)));
        let space = Space {
            title: None,
            seer,
            facets: facets.to_vec().into(),
            edges: edges.clone(),
            marks: lines.map(Mark3::fine).collect(),
        };
        View::new(id, Body::Space(space))
    };
    let eye = Orbit::new([0.0, 0.5, 0.0], [10.0, 30.0], 20.0, 24.0);
    let mut millis = Vec::with_capacity(N_FRAMES);
    for frame in 0..N_FRAMES + 3 {
        let observer = view("observer", Seer::Eye(eye.turned([frame as f64, 0.0])));
        let seen = view("camera", Seer::Camera(camera));
        let at = pos2(10.0, 10.0);
        let press = Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: true,
            modifiers: Modifiers::NONE,
        };
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 720.0))),
            events: if frame == 1 {
                vec![Event::PointerMoved(at), press]
            } else {
                Vec::new()
            },
            ..RawInput::default()
        };
        let start = Instant::now();
        let mut output = ctx.run_ui(input, |ui| {
            widgets::view(ui, look, stage, &observer, None);
            widgets::view(ui, look, INSET, &seen, None);
        });
        output.textures_delta.set.clear();
        if frame >= 3 {
            millis.push(1e3 * start.elapsed().as_secs_f64());
        }
    }
    millis
}

/// Five solids.
fn five() -> Vec<Facet> {
    let mut facets = Vec::new();
    for (nth, solid) in Solid::ALL.into_iter().take(5).enumerate() {
        let at = [2.5 * nth as f64 - 5.0, 0.5, (nth % 2) as f64];
        put(
            &mut facets,
            &solid.mesh(),
            &Matrix::translation(at).after(&Matrix::rotation([0.3, 0.4, 0.0])),
        );
    }
    facets
}

/// About so many triangles, in four rings.
fn rings(n: usize) -> Vec<Facet> {
    let side = (n as f64 / 16.0).sqrt() as usize;
    let (n_round, n_across) = (2 * side, side);
    let mut facets = Vec::new();
    let place = |i: usize, j: usize| {
        let angle = |i: usize, n: usize| (i % n) as f64 / n as f64 * std::f64::consts::TAU;
        let (sin, cos) = angle(i, n_round).sin_cos();
        let (up, out) = angle(j, n_across).sin_cos();
        let radius = 1.0 + 0.4 * out;
        [radius * cos, 0.4 * up, -radius * sin].map(|x| x as f32)
    };
    let mut positions = Vec::new();
    let mut faces = Vec::new();
    for i in 0..n_round {
        for j in 0..n_across {
            positions.push(place(i, j));
            let at = |i: usize, j: usize| ((i % n_round) * n_across + j % n_across) as u32;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    let ring = Mesh::new(positions, Vec::new(), faces).expect("a mesh");
    for nth in 0..4 {
        let at = [
            3.0 * f64::from(nth % 2) - 1.5,
            0.5 * f64::from(nth),
            3.0 * f64::from(nth / 2) - 1.5,
        ];
        put(&mut facets, &ring, &Matrix::translation(at));
    }
    facets
}

fn put(facets: &mut Vec<Facet>, mesh: &Mesh, world_from_model: &Matrix) {
    let link = Some(Link::nth("object", facets.len()));
    facets.extend(mesh.faces().iter().map(|&face| {
        Facet {
            corners: mesh
                .corners(face)
                .map(|at| world_from_model.point(at))
                .to_vec(),
            role: Role::Accent,
            link,
            skin: None,
            edging: Edging::Lines,
            opacity: 1.0,
        }
    }));
}
