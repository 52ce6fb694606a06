//! VTK XML multi-block files: several files as the named blocks of one model.

use crate::text::xml::escaped_in_quotes;

/// The text of a `.vtm` file, which ParaView and VTK read as blocks with names, from these names and the files beside it that hold them.
///
/// ```
/// let index = cyclide_io::formats::vtk_multi_block(&[("duct".to_owned(), "model-duct.vtu".to_owned())]);
/// let text = String::from_utf8(index)?;
/// assert!(text.contains("<DataSet index=\"0\" name=\"duct\" file=\"model-duct.vtu\"/>"));
/// # Ok::<(), std::string::FromUtf8Error>(())
/// ```
#[must_use]
pub fn vtk_multi_block(blocks: &[(String, String)]) -> Vec<u8> {
    let mut out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<vtkMultiBlockDataSet>\n".to_owned();
    for (index, (name, file)) in blocks.iter().enumerate() {
        let [name, file] = [name, file].map(|text| escaped_in_quotes(text));
        out.push_str(&format!("<DataSet index=\"{index}\" name=\"{name}\" file=\"{file}\"/>\n"));
    }
    out.push_str("</vtkMultiBlockDataSet>\n</VTKFile>\n");
    out.into_bytes()
}
