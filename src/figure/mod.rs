//! What a picture of a step says: views with roles, a caption, a watch table, a place in the pseudocode. No
//! colours, no pixels, no language: those are chosen when it is drawn.

mod bits;
mod code_links;
mod extent;
mod frame;
mod gauges;
mod graph;
mod label;
mod layout;
mod lens;
mod lists;
mod mark;
mod matrix;
mod moment;
mod multiples;
mod products;
mod project;
mod raster;
mod ribbon;
mod role;
mod run;
mod screens;
mod shown;
mod solids;
mod space;
mod space_row;
mod story;
mod table;
mod view;
mod watch;
mod words;

pub use bits::{BitRow, Bits};
pub use code_links::CodeLinks;
pub use extent::{Need, Stand, needs, sentences, watches};
pub use frame::{Caption, Frame};
pub use gauges::{Gauge, Gauges};
pub use graph::{
    ArrowKind, Graph, GraphArrow, GraphNode, NodeStage, Places, Spot, Stands, layers, spread,
};
pub use label::Label;
pub use layout::{ColumnLayout, Layout, Sheet, Slot};
pub use lens::Lens;
pub use lists::{ItemMarker, ListColumn, ListLink, ListRow, Lists};
pub use mark::{Mark, Shape, Texel, Weight};
pub use matrix::{MatrixProduct, MatrixRow};
pub use moment::{Moment, MomentError};
pub use multiples::{Multiples, SmallDrawing};
pub use products::{Measured, Product, Products, Vector};
pub use project::{Projected, project};
pub(crate) use project::{between, complement, inside};
pub use raster::{Pixel, Raster, RasterMark, RasterShape};
pub use ribbon::{Ribbon, RibbonStage};
pub use role::{Link, Role};
pub use run::{Run, Tick};
pub use screens::{Screen, Screens};
pub use shown::{Choice, Decides, Shown};
pub use solids::{SolidMesh, SolidPicture, Solids};
pub use space::{Edge3, Facet, Mark3, Seer, Shape3, Skin, Space};
pub use space_row::{CellStage, SpaceCell, SpaceRow};
pub use story::{Story, StoryCard, StoryFate};
pub use table::{Cell, Table, TableNote, TableRow};
pub use view::{
    Body, ClipperBox, ClipperRow, Fate, LineTick, NumberLine, Side, Traveller, View, ViewId,
};
pub use watch::{ListPart, Watch, WatchRow, WatchSection, mark_changes, unseen};
pub use words::Words;
