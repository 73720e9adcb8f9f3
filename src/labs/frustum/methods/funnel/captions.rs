//! The sentences of the funnel, with the numbers of their step.

use crate::{
    algo::{
        cull::{
            Containment, CullRules, FunnelEvent as Event, FunnelInput, FunnelObject,
            FunnelState as State, TriangleFate, asked_camera, asked_sphere,
        },
        volume::SideCode,
    },
    figure::Caption,
    geom::VolumeSide,
    text::{Formula, Message},
};

use super::super::{
    super::stage::side_name,
    sphere_cull::{plane_key, sphere_formula},
};

pub fn opening(input: &FunnelInput) -> Caption {
    let triangles = input.objects.iter().map(|object| object.triangles.len());
    Caption::new(
        Message::new("funnel-opening")
            .with("objects", input.objects.len())
            .with("triangles", triangles.sum::<usize>()),
    )
}

pub fn caption<L: CullRules>(event: &Event, before: &State, input: &FunnelInput) -> Caption {
    let object_idx = before.object_idx.unwrap_or_default();
    let object = input.objects.get(object_idx);
    let n_triangles = object.map_or(0, |object| object.triangles.len());
    let say = |key: &'static str| {
        Message::new(key)
            .with("object", object_idx + 1)
            .with("triangles", n_triangles)
    };
    match *event {
        Event::Object {
            object_idx,
            n_triangles,
            ..
        } => {
            let message = Message::new("funnel-object")
                .with("object", object_idx + 1)
                .with("triangles", n_triangles);
            let sphere = input.objects.get(object_idx).map(asked_sphere::<L>);
            let caption = Caption::new(message);
            match sphere {
                Some(sphere) => caption
                    .so(super::super::planes::triple("c", sphere.center()))
                    .so(Formula::default().sym("r").equals(sphere.radius())),
                None => caption,
            }
        }
        Event::Plane {
            side,
            distance,
            class,
        } => plane_caption::<L>(side, distance, class, object, input),
        Event::Sphere { class, .. } => Caption::new(say(match class {
            Containment::Inside => "funnel-sphere-inside",
            Containment::Straddles => "funnel-sphere-straddles",
            Containment::Outside => "funnel-sphere-outside",
        })),
        Event::Triangle {
            triangle_idx,
            codes,
            fate,
            n_pieces,
            ..
        } => triangle_caption(triangle_idx, codes, fate, n_pieces),
        Event::Face {
            triangle_idx,
            dot,
            front,
            ..
        } => {
            let (key, relation) = if front {
                ("funnel-face-front", " > 0")
            } else if dot == 0.0 {
                ("funnel-face-edge-on", "")
            } else {
                ("funnel-face-back", " < 0")
            };
            Caption::new(say(key).with("triangle", triangle_idx + 1))
                .so(Formula::default().sym("n·e").equals(dot).sym(relation))
        }
        Event::Done => Caption::new(
            Message::new("funnel-done")
                .with("facing", before.levels.facing.triangles)
                .with("triangles", before.levels.scene.triangles)
                .with("objects", before.levels.scene.objects)
                .with("kept", before.levels.facing.objects),
        ),
    }
}

fn plane_caption<L: CullRules>(
    side: VolumeSide,
    distance: f64,
    class: Containment,
    object: Option<&FunnelObject>,
    input: &FunnelInput,
) -> Caption {
    let caption = Caption::new(Message::new(plane_key(class)).with("plane", side_name(side)));
    let Some(object) = object else {
        return caption;
    };
    let plane = &asked_camera::<L>(&input.camera).planes_in_world()[side as usize];
    let formula = if L::TURNS_SIGN {
        let r = asked_sphere::<L>(object).radius();
        let d = super::super::planes::distance_formula(
            ["d", "c"],
            plane,
            object.sphere.center(),
            distance,
        );
        match class {
            Containment::Outside => d.sym(" > r").equals(r),
            Containment::Straddles => d.sym(",  −r < d ≤ r").equals(r),
            Containment::Inside => d.sym(" ≤ −r").equals(-r),
        }
    } else {
        sphere_formula(plane, &asked_sphere::<L>(object), distance, class)
    };
    caption.so(formula)
}

fn triangle_caption(
    triangle_idx: usize,
    codes: [SideCode; 3],
    fate: TriangleFate,
    n_pieces: usize,
) -> Caption {
    let [a, b, c] = codes;
    let n_inside = codes.iter().filter(|code| code.is_inside()).count();
    let key = match (fate, n_pieces) {
        (TriangleFate::Inside, _) => "funnel-triangle-inside",
        (TriangleFate::Outside, _) => "funnel-triangle-outside",
        (TriangleFate::Cut, 0) => "funnel-triangle-nothing",
        (TriangleFate::Cut, _) if n_inside == 0 => "funnel-triangle-across",
        (TriangleFate::Cut, _) => "funnel-triangle-cut",
    };
    let message = Message::new(key)
        .with("triangle", triangle_idx + 1)
        .with("inside", n_inside)
        .with("pieces", n_pieces);
    let formula = |formula: String| Formula::default().sym(formula);
    let and = format!("{a} AND {b} AND {c} = {}", a.and(b).and(c));
    let or = format!("{a} OR {b} OR {c} = {}", a.or(b).or(c));
    let caption = Caption::new(message);
    match fate {
        TriangleFate::Outside => caption.so(formula(and + " ≠ 000000")),
        // What all lie beyond would decide; here it is nothing.
        TriangleFate::Cut if n_inside == 0 => caption.so(formula(and)).so(formula(or)),
        TriangleFate::Inside | TriangleFate::Cut => caption.so(formula(or)),
    }
}
