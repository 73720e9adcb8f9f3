//! What a picture of a step says: views with roles, a caption, a watch table, a place in the pseudocode. No
//! colours, no pixels, no language: those are chosen when it is drawn.

mod code_links;
mod extent;
mod frame;
mod graph;
mod layout;
mod lens;
mod lists;
mod mark;
mod moment;
mod project;
mod raster;
mod role;
mod run;
mod shown;
mod small_pictures;
mod solids;
mod space;
mod values;
mod view;
mod watch;
mod words;

pub use code_links::CodeLinks;
pub use extent::{Need, Stand, needs, sentences, watches};
pub use frame::{Caption, Frame};
pub use graph::{
    ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Spot, Stands, layers, spread,
};
pub use layout::{ColumnLayout, Layout, Sheet, Slot};
pub use lens::Lens;
pub use lists::{ItemMarker, ListColumn, ListLink, ListRow, Lists};
pub use mark::{Mark, Shape, Texel, Weight};
pub use moment::{Moment, MomentError};
pub use project::{Projected, project};
pub(crate) use project::{between, complement, inside};
pub use raster::{Pixel, Raster, RasterMark, RasterShape};
pub use role::{Label, Link, Role};
pub use run::{Run, Tick};
pub use shown::{Choice, Decides, Shown};
pub use small_pictures::{
    CellStage, Multiples, Ribbon, RibbonStage, Screen, Screens, SmallDrawing, SpaceCell, SpaceRow,
    Story, StoryCard, StoryFate,
};
pub use solids::{SolidMesh, SolidPicture, Solids};
pub use space::{Edge3, Facet, Mark3, Seer, Shape3, Skin, Space};
pub use values::{
    BitRow, Bits, Cell, Gauge, Gauges, MatrixProduct, MatrixRow, Measured, Product, Products,
    Table, TableNote, TableRow, Vector,
};
pub use view::{
    Body, ClipperBox, ClipperRow, Fate, LineTick, NumberLine, Side, Traveller, View, ViewId,
};
pub use watch::{ListPart, Watch, WatchRow, WatchSection, mark_changes, unseen};
pub use words::Words;
