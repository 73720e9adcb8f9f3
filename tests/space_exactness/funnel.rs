//! Nothing that can be seen is left out, and the levels only lose what they should.

use clipscope::{
    algo::{
        cull::{
            Containment, Funnel, FunnelInput, FunnelObject, SphereCull, SphereCullInput,
            faulty::{AroundOrigin, Clockwise, ConstantView, OneAngle, TurnsSign},
        },
        surface::{Cull, MeshRef, Viewport, assemble, draw_rows},
    },
    geom::{Camera, Matrix, Mesh, Solid, ViewVolume},
    trace::{laws, silent},
};
use proptest::prelude::*;

const SIZE: [u32; 2] = [48, 32];

fn camera(position: [f64; 3]) -> Camera {
    let volume = ViewVolume::perspective(50.0, 1.5, 0.5, 12.0).expect("a volume");
    Camera::new(position, [0.0, 0.5, 0.0], [0.0, 1.0, 0.0], volume).expect("a camera")
}

fn placed() -> impl Strategy<Value = (Solid, Matrix)> {
    let solid = prop::sample::select(Solid::ALL.to_vec());
    let at = prop::array::uniform3(-6.0..6.0_f64);
    (solid, at, prop::array::uniform3(0.0..6.0_f64), 0.2..1.5_f64).prop_map(
        |(solid, at, turn, size)| {
            let turned = Matrix::rotation(turn).after(&Matrix::scale(size));
            (solid, Matrix::translation(at).after(&turned))
        },
    )
}

/// Has it a pixel, of all that a camera sees if there is nothing else?
fn has_a_pixel(mesh: &Mesh, world_from_model: &Matrix, camera: &Camera) -> bool {
    let attributes = vec![[]; mesh.positions().len()];
    let mesh = MeshRef {
        positions: mesh.positions(),
        attributes: &attributes,
        faces: mesh.faces(),
        first_id: 0,
    };
    let viewport = Viewport::new(SIZE, Viewport::PICTURE_BITS).expect("a small picture");
    let clip_from_model = camera.clip_from_world().after(world_from_model);
    let mut triangles: Vec<clipscope::algo::surface::ScreenTriangle<0>> = Vec::new();
    assemble(
        &mesh,
        &clip_from_model,
        &viewport,
        Cull::Nothing,
        &mut triangles,
    );
    let mut depths = vec![f32::INFINITY; (SIZE[0] * SIZE[1]) as usize];
    let mut is_seen = false;
    draw_rows(&triangles, &viewport, 0..SIZE[1], &mut depths, |_, _, _| {
        is_seen = true;
    });
    is_seen
}

proptest! {
    #[test]
    fn the_laws_and_the_levels(solids in prop::collection::vec(placed(), 1..4), x in -4.0..4.0_f64) {
        let camera = camera([x, 2.0, 5.0]);
        let objects = solids.iter().map(|(solid, world_from_model)| {
            FunnelObject::new(&solid.mesh(), world_from_model).expect("finite")
        });
        let input = FunnelInput { camera, objects: objects.collect() };
        laws::check::<Funnel>(&input);
        laws::check::<Funnel<OneAngle>>(&input);
        laws::check::<Funnel<ConstantView>>(&input);
        laws::check::<Funnel<TurnsSign>>(&input);
        laws::check::<Funnel<AroundOrigin>>(&input);
        laws::check::<Funnel<Clockwise>>(&input);
        let levels = silent::<Funnel>(&input);
        prop_assert!(levels.scene.triangles >= levels.spheres.triangles);
        prop_assert!(levels.spheres.triangles >= levels.vertices.triangles);
        prop_assert!(levels.cuts.triangles >= levels.facing.triangles);
        let objects = [levels.scene, levels.spheres, levels.vertices, levels.cuts, levels.facing].map(|level| level.objects);
        prop_assert!(objects.is_sorted_by(|a, b| a >= b), "{objects:?}");
    }

    /// A closed solid that lies wholly ahead of the near plane shows a front wherever it shows anything; one that the near
    /// plane cuts may show nothing but its inside.
    #[test]
    fn no_object_with_a_visible_pixel_is_culled((solid, world_from_model) in placed(), x in -4.0..4.0_f64) {
        let camera = camera([x, 2.0, 5.0]);
        let mesh = solid.mesh();
        let object = FunnelObject::new(&mesh, &world_from_model).expect("finite");
        let planes = camera.planes_in_world().to_vec();
        let class = silent::<SphereCull>(&SphereCullInput { planes, sphere: object.sphere }).class;
        if has_a_pixel(&mesh, &world_from_model, &camera) {
            prop_assert_ne!(class, Containment::Outside);
            let is_whole = is_ahead_of_near(&mesh, &world_from_model, &camera);
            let levels = silent::<Funnel>(&FunnelInput { camera, objects: vec![object] });
            prop_assert!(levels.cuts.triangles > 0);
            prop_assert!(!is_whole || levels.facing.triangles > 0);
        }
    }
}

fn is_ahead_of_near(mesh: &Mesh, world_from_model: &Matrix, camera: &Camera) -> bool {
    let clip_from_model = camera.clip_from_world().after(world_from_model);
    mesh.positions().iter().all(|position| {
        let [x, y, z] = position.map(f64::from);
        let [_, _, z, w] = clip_from_model.times([x, y, z, 1.0]);
        z > -w
    })
}

/// Found by the property above before it asked where the near plane is: the eye stands inside this ball.
#[test]
fn from_inside_a_ball_only_backs_are_seen() {
    let camera = camera([-3.125, 2.0, 5.0]);
    let at = [-2.625, 1.25, 4.75];
    let world_from_model = Matrix::translation(at).after(&Matrix::scale(0.9375));
    let mesh = Solid::Sphere.mesh();
    assert!(has_a_pixel(&mesh, &world_from_model, &camera));
    assert!(!is_ahead_of_near(&mesh, &world_from_model, &camera));
    let object = FunnelObject::new(&mesh, &world_from_model).expect("finite");
    let levels = silent::<Funnel>(&FunnelInput {
        camera,
        objects: vec![object],
    });
    assert!(levels.cuts.triangles > 0);
    assert_eq!(levels.facing.triangles, 0);
}
