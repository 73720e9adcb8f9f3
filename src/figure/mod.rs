//! What a picture of a step says, with no colours, no pixels, no language: those are chosen when it is drawn.

mod code_links;
mod comparison;
mod extent;
mod eye;
mod facet;
mod facets;
mod frame;
mod graph;
mod layout;
mod lens;
mod mark;
mod moment;
mod over;
mod project;
mod role;
mod run;
mod said;
mod small_pictures;
mod solid_mesh;
mod solids;
mod space;
mod values;
mod view;
mod watch;
mod words;

pub use code_links::CodeLinks;
pub use comparison::Comparison;
pub use extent::{Need, Stand, needs, sentences, watches};
#[cfg(all(test, feature = "gui"))]
pub(crate) use eye::judged;
pub use eye::{AROUND, Eyes, Prospect};
pub use facet::{Edging, Facet, Skin};
pub use facets::Facets;
pub use frame::{Caption, Chip, ChipFate, Choice, Decides, Frame, Glimpse, Shown};
pub use graph::{
    ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Spot, Stands, layers, size_of,
    spread,
};
pub use layout::{Boundary, ColumnLayout, Layout, Sheet, Slot, Spacing};
pub use lens::Lens;
pub use mark::{Mark, Shape, Texel, Weight};
pub use moment::{Moment, MomentError};
pub use project::{Projected, project};
pub(crate) use project::{between, complement, inside};
pub use role::{Label, Link, Role};
pub use run::{Run, Tick};
pub use said::{notation, said};
pub use small_pictures::{
    CellStage, Multiples, Pixel, Raster, RasterMark, RasterShape, Ribbon, RibbonStage,
    SmallDrawing, SpaceCell, SpaceRow, Story, StoryCard, StoryFate, Tiles,
};
pub use solid_mesh::SolidMesh;
pub use solids::{SolidPicture, SolidScreen, Solids};
pub use space::{Edge3, Mark3, Seer, Shape3, Space};
pub use values::{
    BitRow, Bits, Cell, Costs, Gauge, Gauges, ItemMarker, ListColumn, ListLink, ListRow, Lists,
    MatrixProduct, MatrixRow, Measured, Product, Products, Table, TableNote, TableRow, Vector,
};
pub use view::{
    Body, ClipperBox, ClipperRow, Fate, LineTick, NumberLine, Side, Traveller, View, ViewId,
};
pub use watch::{ListPart, Watch, WatchRow, WatchSection, mark_changes, unseen};
pub use words::Words;
