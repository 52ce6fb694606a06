//! What is measured as one: a net, or nets that join.

use cyclide::{
    Error, Result,
    error::{PartError, PatchError},
    surface::{CyclidicNet, NetLayout},
    topology::Shell,
};

/// A surface of panels.
#[derive(Debug, Clone)]
pub(super) enum Skin {
    Net(CyclidicNet),
    /// Nets that share nodes and edges.
    Layout(NetLayout),
}

impl Skin {
    pub(super) fn nets(&self) -> &[CyclidicNet] {
        match self {
            Self::Net(net) => std::slice::from_ref(net),
            Self::Layout(layout) => layout.nets(),
        }
    }

    /// What its nets are called: as it, if it is one net.
    pub(super) fn piece_names(&self, name: &str) -> Vec<String> {
        match self.nets().len() {
            1 => vec![name.to_owned()],
            count => (0..count).map(|piece| format!("{name}.{piece}")).collect(),
        }
    }

    /// All panels, in the order of the nets and of the patches of each.
    pub(super) fn to_shell(&self) -> Result<Shell> {
        match self {
            Self::Net(net) => net.to_shell(),
            Self::Layout(layout) => layout.to_shell(),
        }
    }

    /// The other side of its panels, refused where no panel can be so thick.
    pub(super) fn other_side(&self, h: f64) -> Result<Self> {
        for net in self.nets() {
            let Some(quad) = net.patches().position(|patch| !patch.offset_is_regular(h)) else { continue };
            return match net.thick(h) {
                Err(error) => Err(error),
                Ok(_) => Err(PartError::InQuad {
                    quad,
                    cause: Box::new(Error::Patch(PatchError::OffsetNotRegular { distance: h, limit: 0.0 })),
                }
                .into()),
            };
        }
        match self {
            Self::Net(net) => net.offset(h).map(Self::Net),
            Self::Layout(layout) => layout.offset(h).map(Self::Layout),
        }
    }
}
