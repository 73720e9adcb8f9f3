//! A vertex on its way to the screen.

use crate::{
    algo::pipeline::{
        BresenhamInput, LineToPixels, LineToPixelsInput, ViewingPipeline, ViewingPipelineInput,
        ViewingPipelineOutput,
    },
    case::{
        Code, Detail, Field, Fields, Given, Node, Path, Refusal, SolveTold, Told,
        picture::read_picture,
        volume::{VOLUME_FIELDS, read_volume_of, refused},
    },
    geom::{Camera, Matrix},
    text::{Formula, Message, Value},
};

use super::reader::Reader;

impl SolveTold for ViewingPipeline {
    const FIELDS: &'static [Field] = &[
        Field::required("point"),
        Field::optional("model"),
        Field::required("camera"),
        Field::required("size"),
    ];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let point = reader.point()?;
        let world_from_model = match fields.get("model") {
            Some(node) => told(&mut reader, model(&node)?),
            None => Matrix::IDENTITY,
        };
        let camera = camera(&fields.need("camera")?, fields.detail(), &mut reader)?;
        let viewport = told(&mut reader, read_picture(&fields.need("size")?)?);
        let input = ViewingPipelineInput {
            point,
            world_from_model,
            camera,
            viewport,
        };
        Ok((input, reader.told()))
    }

    fn verdict(output: &ViewingPipelineOutput) -> Message {
        let key = match (output.inside, output.screen) {
            (_, None) => "case-pipeline-behind",
            (true, Some(_)) => "case-pipeline-inside",
            (false, Some(_)) => "case-pipeline-outside",
        };
        Message::new(key).with("screen", output.screen.unwrap_or_default())
    }
}

impl SolveTold for LineToPixels {
    const FIELDS: &'static [Field] = &[Field::required("from"), Field::required("to")];

    fn read(fields: &Fields<'_>) -> Result<(Self::Input, Told), Refusal> {
        let mut reader = Reader::new(fields);
        let mut pixel = |name, key| {
            let at: [i64; 2] = fields.need(name)?.wholes()?;
            let place = format!("[{}, {}]", at[0], at[1]).replace('-', "−");
            let given = Given::new(key, [Value::Name(place)].into_iter());
            Ok(told(&mut reader, (at, given)))
        };
        let (from, to) = (pixel("from", "object-from")?, pixel("to", "object-to")?);
        let ends = BresenhamInput::new(from, to).map_err(|error| {
            let problem = Message::new("case-too-many-pixels")
                .with("found", error.n_pixels.to_string())
                .with("max", BresenhamInput::MOST_PIXELS.to_string());
            Refusal::at(Code::TooLarge, &Path::Field("to"), problem)
        })?;
        Ok((LineToPixelsInput::Pixels(ends), reader.told()))
    }

    fn verdict(output: &Vec<[i64; 2]>) -> Message {
        Message::new("case-pixels").with("count", output.len())
    }
}

/// What was read, once the reader has been told of it.
fn told<T>(reader: &mut Reader<'_>, (read, given): (T, Given)) -> T {
    reader.tell(given);
    read
}

fn model(node: &Node<'_>) -> Result<(Matrix, Given), Refusal> {
    let rows: [[f64; 4]; 4] = node.rows()?;
    let last = Path::Index(&node.path, 3);
    let matrix = Matrix::affine(rows).map_err(|error| Refusal::space(&last, error))?;
    let told = rows.map(|row| Value::Formula(Formula::decimals().sym("(").list(&row).sym(")")));
    let given = Given::new("object-model-matrix", told.into_iter());
    Ok((matrix, given))
}

const PLACES: [Field; 3] = [
    Field::required("position"),
    Field::required("target"),
    Field::required("up"),
];

/// Its places, then those of its volume.
const CAMERA_FIELDS: [Field; 8] = {
    let [fov, height, aspect, near, far] = VOLUME_FIELDS;
    let [position, target, up] = PLACES;
    [position, target, up, fov, height, aspect, near, far]
};

fn camera(node: &Node<'_>, detail: Detail, reader: &mut Reader<'_>) -> Result<Camera, Refusal> {
    let fields = Fields::of(node, "object-camera", &CAMERA_FIELDS, detail)?;
    let mut places = [[0.0; 3]; 3];
    for (at, field) in places.iter_mut().zip(PLACES) {
        *at = fields.need(field.name)?.numbers()?;
    }
    let (volume, numbers) = read_volume_of(&fields, &node.path)?;
    let [position, target, up] = places;
    let camera = Camera::new(position, target, up, volume);
    let camera = camera.map_err(|error| refused(&node.path, error))?;
    let formulas = places.iter().zip(PLACES).map(|(&at, field)| {
        let formula = Formula::default().sym(field.name).sym(" = ");
        Value::Formula(formula.place(at))
    });
    let values: Vec<Value> = formulas.chain(numbers).collect();
    let given = Given::new("object-camera", values.into_iter());
    Ok(told(reader, (camera, given)))
}
