//! What the canvas shows, as elements that are read and not seen: each node of egui's accessible tree is one. The canvas keeps the
//! focus and names the element that has it in egui; a click on an element, as screen readers do it, is one on its widget.

use std::collections::{BTreeMap, HashMap};

use egui::accesskit::{Live, Node, NodeId, Role, Toggled, TreeUpdate};
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{Document, Element, Event, HtmlCanvasElement};

pub struct Mirror {
    document: Document,
    place: Element,
    canvas: HtmlCanvasElement,
    shown: HashMap<NodeId, (Told, Element)>,
    focus: Option<NodeId>,
}

/// What an element says.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
struct Told {
    attributes: BTreeMap<&'static str, String>,
    text: String,
    children: Vec<NodeId>,
}

fn name_of(id: NodeId) -> String {
    format!("n{}", id.0)
}

impl Mirror {
    pub fn new(
        place: Element,
        canvas: HtmlCanvasElement,
        clicked: impl Fn(NodeId) + 'static,
    ) -> Result<Self, JsValue> {
        let heard = Closure::<dyn Fn(Event)>::new(move |event: Event| {
            let target = event.target().and_then(|it| it.dyn_into::<Element>().ok());
            let id = target.and_then(|target| target.id().strip_prefix('n')?.parse().ok());
            if let Some(id) = id {
                clicked(NodeId(id));
            }
        });
        place.add_event_listener_with_callback("click", heard.into_js_value().unchecked_ref())?;
        Ok(Self {
            document: place.owner_document().ok_or(JsValue::NULL)?,
            place,
            canvas,
            shown: HashMap::new(),
            focus: None,
        })
    }

    /// Where the page lets itself not be written, nothing is read there.
    pub fn show(&mut self, update: TreeUpdate) {
        let root = update.tree.as_ref().map(|tree| tree.root);
        let focus = Some(update.focus).filter(|focus| Some(*focus) != root);
        let _ = self
            .write(update.nodes, root)
            .and_then(|()| self.point(focus));
    }

    /// What is new or says something else is written, what is gone is taken away; all else is not touched.
    fn write(&mut self, nodes: Vec<(NodeId, Node)>, root: Option<NodeId>) -> Result<(), JsValue> {
        let mut before = std::mem::take(&mut self.shown);
        let mut moved = Vec::new();
        for (id, node) in nodes {
            if node.role() == Role::TextRun {
                continue;
            }
            let told = told(&node);
            let (old, element) = match before.remove(&id) {
                Some((old, element)) => (old, element),
                None => {
                    let element = self.document.create_element("div")?;
                    element.set_id(&name_of(id));
                    (Told::default(), element)
                }
            };
            old.write_over(&told, &element)?;
            if old.children != told.children {
                moved.push(id);
            }
            self.shown.insert(id, (told, element));
        }
        for (_, element) in before.into_values() {
            element.remove();
        }
        for id in moved {
            let (told, element) = &self.shown[&id];
            for (_, child) in told
                .children
                .iter()
                .filter_map(|child| self.shown.get(child))
            {
                element.append_child(child)?;
            }
        }
        let root = root.and_then(|root| self.shown.get(&root));
        if let Some((_, root)) = root
            && root.parent_element().is_none()
        {
            self.place.append_child(root)?;
        }
        Ok(())
    }

    fn point(&mut self, focus: Option<NodeId>) -> Result<(), JsValue> {
        if std::mem::replace(&mut self.focus, focus) == focus {
            return Ok(());
        }
        let active = "aria-activedescendant";
        match focus {
            Some(focus) => self.canvas.set_attribute(active, &name_of(focus)),
            None => self.canvas.remove_attribute(active),
        }
    }
}

impl Told {
    fn write_over(&self, now: &Self, element: &Element) -> Result<(), JsValue> {
        for (name, value) in &now.attributes {
            if self.attributes.get(name) != Some(value) {
                element.set_attribute(name, value)?;
            }
        }
        let gone = |name: &&&str| !now.attributes.contains_key(**name);
        for name in self.attributes.keys().filter(gone) {
            element.remove_attribute(name)?;
        }
        if self.text != now.text {
            // Before the children, in a node of its own, so that these stay.
            match element
                .first_child()
                .filter(|first| first.node_type() == web_sys::Node::TEXT_NODE)
            {
                Some(first) => first.set_node_value(Some(&now.text)),
                None => element.prepend_with_str_1(&now.text)?,
            }
        }
        Ok(())
    }
}

/// What is chosen, by the name that this has for such a node.
fn toggled(node: &Node) -> (&'static str, Option<&'static str>) {
    let state = match node.role() {
        Role::CheckBox | Role::RadioButton | Role::Switch => "aria-checked",
        Role::Button => "aria-pressed",
        _ => "aria-selected",
    };
    let toggled = node.toggled().map(|toggled| match toggled {
        Toggled::False => "false",
        Toggled::True => "true",
        Toggled::Mixed => "mixed",
    });
    (state, toggled)
}

fn told(node: &Node) -> Told {
    let mut attributes = BTreeMap::new();
    let mut say = |name, value: Option<String>| {
        if let Some(value) = value {
            attributes.insert(name, value);
        }
    };
    let yes = |is: bool| is.then(|| "true".to_owned());
    let role = role_of(node.role());
    say("role", role.map(str::to_owned));
    say("aria-label", node.label().map(str::to_owned));
    let names = node.labelled_by().iter().map(|id| name_of(*id));
    let names = names.collect::<Vec<_>>().join(" ");
    say(
        "aria-labelledby",
        Some(names).filter(|names| !names.is_empty()),
    );
    say("data-name", node.author_id().map(str::to_owned));
    say("aria-disabled", yes(node.is_disabled()));
    let (state, toggled) = toggled(node);
    say(state, toggled.map(str::to_owned));
    say(
        "aria-valuenow",
        node.numeric_value().map(|it| it.to_string()),
    );
    say(
        "aria-valuemin",
        node.min_numeric_value().map(|it| it.to_string()),
    );
    say(
        "aria-valuemax",
        node.max_numeric_value().map(|it| it.to_string()),
    );
    let live = node.live().and_then(|live| match live {
        Live::Off => None,
        Live::Polite => Some("polite"),
        Live::Assertive => Some("assertive"),
    });
    say("aria-live", live.map(str::to_owned));
    say("aria-modal", yes(node.is_modal()));
    // What a field or a slider says is its value; of all else it is there to be read.
    let value = node.value().unwrap_or_default().to_owned();
    let is_set = matches!(node.role(), Role::Slider | Role::SpinButton);
    say(
        "aria-valuetext",
        Some(value.clone()).filter(|it| is_set && !it.is_empty()),
    );
    Told {
        attributes,
        text: value,
        children: node.children().to_vec(),
    }
}

/// None where an element is only what is written in it, or what holds others.
fn role_of(role: Role) -> Option<&'static str> {
    Some(match role {
        Role::Button | Role::DefaultButton | Role::ColorWell => "button",
        Role::CheckBox => "checkbox",
        Role::Switch => "switch",
        Role::RadioButton => "radio",
        Role::RadioGroup => "radiogroup",
        Role::Link => "link",
        Role::Slider => "slider",
        Role::SpinButton => "spinbutton",
        Role::ComboBox => "combobox",
        Role::TextInput | Role::MultilineTextInput => "textbox",
        Role::Tab => "tab",
        Role::ListItem => "listitem",
        Role::Splitter => "separator",
        Role::ProgressIndicator => "progressbar",
        Role::Image => "img",
        Role::Canvas => "group",
        Role::Heading => "heading",
        Role::Dialog => "dialog",
        Role::Menu => "menu",
        Role::MenuItem => "menuitem",
        Role::ScrollBar => "scrollbar",
        _ => return None,
    })
}
