//! A file that was made, beside the model that it was made of.

use crate::check::deviation::{MeshForm, View, curves_deviation, mesh_deviation};
use crate::check::file_content::FileContent;
use crate::check::labels::Named;
use crate::check::read_error::ReadError;
use crate::export::exported::Exported;
use crate::export::ready::ReadyModel;

/// A file with the model that it was made of: what is compared.
#[derive(Clone, Copy)]
pub(crate) struct Made<'a> {
    pub(crate) ready: &'a ReadyModel<'a>,
    pub(crate) file: &'a Exported,
}

impl<'a> Made<'a> {
    /// What the file is called by.
    pub(crate) fn named(&self) -> Named<'a> {
        Named { model: self.ready.model, title: &self.file.title }
    }

    /// How far the curves read are from those of the model.
    ///
    /// # Errors
    /// Those of [`curves_deviation`].
    pub(crate) fn curves(&self, content: &FileContent, view: View) -> Result<Vec<f64>, ReadError> {
        curves_deviation(self.ready.model, &content.curves, &self.file.written.curves, view)
    }

    /// How far the meshes read are from the bodies of the model.
    ///
    /// # Errors
    /// Those of [`mesh_deviation`].
    pub(crate) fn meshes(&self, content: &FileContent, form: MeshForm) -> Result<Vec<f64>, ReadError> {
        mesh_deviation(form, &self.ready.bodies, &content.meshes, &self.file.written.mesh)
    }
}
