// XDMF 3 text: Polyvertex grids whose arrays lie in HDF5 files. Readers tested: docs/files.md.
#include "scree/output/xdmf.h"

#include <fmt/format.h>

namespace scree {
namespace {

const char* number_type(Element element) {
  if (is_floating(element)) return "Float";
  if (element == Element::uint8) return "UChar";
  return element == Element::uint32 || element == Element::uint64 ? "UInt" : "Int";
}

/// A reference to a dataset with a number of rows, "file:dataset".
std::string data_item(const std::string& place, std::uint64_t rows, Element element, std::uint64_t components) {
  const std::string columns = components == 1 ? "" : fmt::format(" {}", components);
  return fmt::format(R"(<DataItem Format="HDF" NumberType="{}" Precision="{}" Dimensions="{}{}">{}</DataItem>)",
                     number_type(element), element_size(element), rows, columns, place);
}

const char* attribute_type(std::uint64_t components) {
  switch (components) {
    case 1:
      return "Scalar";
    case 3:
      return "Vector";
    case 9:
      return "Tensor";
    default:
      return "Matrix";
  }
}

std::string cell_attribute(const std::string& file, const XdmfField& field, std::uint64_t cells) {
  return fmt::format("    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Cell\">{}</Attribute>\n", field.name,
                     attribute_type(field.components),
                     data_item(file + ":/fields/" + field.name, cells, field.element, field.components));
}

}  // namespace

std::string xdmf_grid(const XdmfFrame& frame) {
  std::string text = fmt::format(
      "   <Grid Name=\"{}\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
      "    <Topology TopologyType=\"Polyvertex\" NodesPerElement=\"1\" NumberOfElements=\"{}\">{}</Topology>\n",
      frame.group, frame.time, frame.points, data_item(frame.file + ":/vertices", frame.points, Element::int32, 1));
  for (const XdmfField& field : frame.fields) {
    const std::string place = fmt::format("{}:/{}/{}", frame.file, frame.group, field.name);
    const std::string item = data_item(place, frame.points, field.element, field.components);
    if (field.name == "position")
      text += fmt::format("    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n", item);
    else
      text += fmt::format("    <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                          field.name, attribute_type(field.components), item);
  }
  return text + "   </Grid>\n";
}

std::string xdmf_surface(const XdmfSurface& s) {
  return fmt::format(
      "   <Grid Name=\"walls\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
      "    <Topology TopologyType=\"Triangle\" NumberOfElements=\"{}\">{}</Topology>\n"
      "    <Geometry GeometryType=\"XYZ\">{}</Geometry>\n"
      "    <Attribute Name=\"wall\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute>\n   </Grid>\n",
      s.time, s.triangles, data_item(s.triangles_file + ":/triangles", s.triangles, Element::int32, 3),
      data_item(s.points_file + ":/points", s.points, Element::float64, 3),
      data_item(s.triangles_file + ":/wall", s.triangles, Element::int32, 1));
}

std::string xdmf_grid(const XdmfCells& c) {
  std::string text = fmt::format(
      "   <Grid Name=\"averages\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
      "    <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
      "    <Geometry GeometryType=\"ORIGIN_DXDYDZ\">"
      "<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">{} {} {}</DataItem>"
      "<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"3\">{} {} {}</DataItem></Geometry>\n",
      c.time, c.cells[2] + 1, c.cells[1] + 1, c.cells[0] + 1, c.min[2], c.min[1], c.min[0], c.spacing[2], c.spacing[1],
      c.spacing[0]);
  const auto rows = static_cast<std::uint64_t>(c.cells[0] * c.cells[1] * c.cells[2]);
  for (const XdmfField& field : c.fields) text += cell_attribute(c.file, field, rows);
  return text + "   </Grid>\n";
}

std::string xdmf_grid(const XdmfRectilinear& c) {
  std::string text = fmt::format(
      "   <Grid Name=\"fluid\" GridType=\"Uniform\">\n    <Time Value=\"{}\"/>\n"
      "    <Topology TopologyType=\"3DRectMesh\" Dimensions=\"{} {} {}\"/>\n    <Geometry GeometryType=\"VXVYVZ\">",
      c.time, c.cells[2] + 1, c.cells[1] + 1, c.cells[0] + 1);
  for (int a = 0; a < 3; ++a)
    text += data_item(fmt::format("{}:/faces/{}", c.file, "xyz"[a]), static_cast<std::uint64_t>(c.cells[a] + 1),
                      Element::float64, 1);
  text += "</Geometry>\n";
  const auto rows = static_cast<std::uint64_t>(c.cells[0] * c.cells[1] * c.cells[2]);
  for (const XdmfField& field : c.fields) text += cell_attribute(c.file, field, rows);
  return text + "   </Grid>\n";
}

std::string xdmf_document(const std::string& grids) {
  return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n"
         "  <Grid Name=\"frames\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" +
         grids + "  </Grid>\n </Domain>\n</Xdmf>\n";
}

}  // namespace scree
