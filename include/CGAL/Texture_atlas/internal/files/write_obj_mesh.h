// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/files/text_lines.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/IO/OBJ_material.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Returns what is wrong with the materials, or an empty string. Line breaks would end a name, and blanks around it get
// lost.
inline std::string wrong_material(const std::vector<OBJ_material>& materials)
{
  const auto is_wrong = [](const std::string& name) {
    return name.find_first_of("\r\n") != name.npos ||
           (!name.empty() && std::string(" \t#").find(name.front()) != std::string::npos) ||
           (!name.empty() && std::string(" \t\\").find(name.back()) != std::string::npos);
  };
  for(std::size_t i = 0; i < materials.size(); ++i) {
    const OBJ_material& material = materials[i];
    const std::string begin = "material " + std::to_string(i);
    if(material.name.empty() || is_wrong(material.name))
      return begin + " has an empty name, or one that cannot be written";
    for(std::size_t j = 0; j < i; ++j)
      if(materials[j].name == material.name)
        return begin + " has the same name as material " + std::to_string(j);
    for(const std::string* image :
        {&material.color_image, &material.normal_image, &material.displacement_image})
      if(is_wrong(*image))
        return begin + " names a picture whose name cannot be written";
    for(const double number : material.color)
      if(!(number >= 0 && number <= 1))
        return begin + " has a colour outside of 0 to 1";
    if(!std::isfinite(material.least_displacement) || !std::isfinite(material.greatest_displacement))
      return begin + " has a displacement that is not finite";
  }
  return std::string();
}

// Some programs take the picture of normals from `norm`, others from `map_Bump`.
inline void write_obj_materials(std::ostream& out, const std::vector<OBJ_material>& materials)
{
  for(const OBJ_material& material : materials) {
    std::string text = "newmtl " + material.name + "\nKd";
    for(const double number : material.color)
      append_number(text += ' ', number);
    text += '\n';
    if(!material.color_image.empty())
      text += "map_Kd " + material.color_image + '\n';
    if(!material.normal_image.empty())
      text += "norm " + material.normal_image + "\nmap_Bump " + material.normal_image + '\n';
    if(!material.displacement_image.empty()) {
      append_number(text += "disp -mm ", material.least_displacement);
      append_number(text += ' ', material.greatest_displacement - material.least_displacement);
      text += ' ' + material.displacement_image + '\n';
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  }
}

// Writes a mesh with texture coordinates. Corners at one vertex share those that are equal, within each patch.
template <typename PolygonMesh, typename UVMap, typename FaceMaterialMap, typename NamedParameters>
class Obj_mesh_writer
{
  typedef boost::graph_traits<PolygonMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  struct Corner
  {
    std::array<double, 2> uv;
    long patch;
    std::size_t number; // in the file

    // 0 and -0 differ, so that all bits are read back.
    bool is(const std::array<double, 2>& other, long other_patch) const
    {
      return std::memcmp(uv.data(), other.data(), sizeof(uv)) == 0 && patch == other_patch;
    }
  };

  static constexpr bool has_patches =
      !parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;
  static constexpr bool has_normals =
      !parameters::is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value;

public:
  Obj_mesh_writer(const PolygonMesh& mesh, UVMap uv, FaceMaterialMap face_materials,
                  const std::vector<OBJ_material>& materials, const NamedParameters& np)
      : m_mesh(mesh), m_coordinates(mesh, uv), m_face_materials(face_materials), m_materials(materials),
        m_np(np), m_precision(parameters::choose_parameter(
                      parameters::get_parameter(np, internal_np::stream_precision), 17)),
        m_number(get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh))
  {}

  // What is wrong, if anything. Nothing is written then.
  OBJ_report check()
  {
    if(m_precision < 1 || m_precision > 17)
      return obj_failure(Diagnosis::WRONG_OPTION, "the precision must be from 1 to 17");
    if(const std::string wrong = wrong_material(m_materials); !wrong.empty())
      return obj_failure(Diagnosis::WRONG_OPTION, wrong);
    OBJ_report report = check_vertices();
    std::size_t f = 0;
    for(const face_descriptor face : faces(m_mesh))
      if(report)
        check_face(face, f++, report);
    return report;
  }

  // `material_file` is empty if there are no materials.
  void write(std::ostream& out, const std::string& material_file)
  {
    m_out = &out;
    if(!material_file.empty())
      m_text += "mtllib " + material_file + '\n';
    write_vertices();
    for(const face_descriptor f : faces(m_mesh))
      write_face(f);
    flush();
  }

private:
  long patch(face_descriptor f) const
  {
    if constexpr(has_patches)
      return static_cast<long>(get(parameters::get_parameter(m_np, internal_np::face_patch), f));
    else {
      (void)f;
      return 0;
    }
  }

  auto points() const
  {
    return parameters::choose_parameter(parameters::get_parameter(m_np, internal_np::vertex_point),
                                        get_const_property_map(CGAL::vertex_point, m_mesh));
  }

  template <typename Triple>
  static std::array<double, 3> numbers(const Triple& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // A check for the pair or triple of a point or vector
  template <typename Numbers>
  static bool are_finite(const Numbers& numbers)
  {
    for(const double x : numbers)
      if(!std::isfinite(x))
        return false;
    return true;
  }

  OBJ_report check_vertices()
  {
    std::size_t number = 0;
    for(const auto v : vertices(m_mesh)) {
      const auto name = [&] { return vertex_text(static_cast<std::ptrdiff_t>(number), get(points(), v)); };
      if(!are_finite(numbers(get(points(), v))))
        return obj_failure(Diagnosis::NON_FINITE_POINT, name() + non_finite_text);
      if constexpr(has_normals)
        if(!are_finite(numbers(get(parameters::get_parameter(m_np, internal_np::vertex_normal_map), v))))
          return obj_failure(Diagnosis::WRONG_NORMAL, name() + " has a normal that is not finite");
      put(m_number, v, number++);
    }
    m_corners.resize(number);
    return OBJ_report();
  }

  void check_face(face_descriptor face, std::size_t f, OBJ_report& report) const
  {
    const std::string name = "face " + std::to_string(f);
    if(!m_materials.empty()) {
      const long material = static_cast<long>(get(m_face_materials, face));
      if(material < 0 || static_cast<std::size_t>(material) >= m_materials.size())
        report = obj_failure(Diagnosis::WRONG_OPTION,
                             name + " has material " + std::to_string(material) + ", but there are " +
                                 std::to_string(m_materials.size()) + " materials, numbered from 0");
    }
    if(patch(face) < 0) {
      ++report.number_of_faces_without_coordinates;
      return;
    }
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(face, m_mesh), m_mesh))
      if(!are_finite(uv(h)))
        report = obj_failure(Diagnosis::NON_FINITE_COORDINATE,
                             name + " has a texture coordinate that is not finite");
  }

  std::array<double, 2> uv(halfedge_descriptor h) const
  {
    const auto& p = m_coordinates[h];
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  }

  template <typename Numbers>
  void write_line(const char* keyword, const Numbers& numbers)
  {
    m_text += keyword;
    for(const double x : numbers)
      append_number(m_text += ' ', x, m_precision == 17 ? 0 : m_precision);
    m_text += '\n';
    if(m_text.size() > 1000000)
      flush();
  }

  void flush()
  {
    m_out->write(m_text.data(), static_cast<std::streamsize>(m_text.size()));
    m_text.clear();
  }

  void write_vertices()
  {
    for(const auto v : vertices(m_mesh))
      write_line("v", numbers(get(points(), v)));
    if constexpr(has_normals)
      for(const auto v : vertices(m_mesh))
        write_line("vn", numbers(get(parameters::get_parameter(m_np, internal_np::vertex_normal_map), v)));
  }

  // The number of the coordinates of a corner, which are written when they first occur
  std::size_t number_of(halfedge_descriptor h)
  {
    const std::array<double, 2> p = uv(h);
    const long face_patch = patch(face(h, m_mesh));
    std::vector<Corner>& corners = m_corners[get(m_number, target(h, m_mesh))];
    for(const Corner& corner : corners)
      if(corner.is(p, face_patch))
        return corner.number;
    write_line("vt", p);
    corners.push_back({p, face_patch, ++m_count});
    return m_count;
  }

  void write_face(face_descriptor f)
  {
    const long material = m_materials.empty() ? -1 : static_cast<long>(get(m_face_materials, f));
    if(material != m_material) {
      m_material = material;
      m_text += "usemtl " + m_materials[static_cast<std::size_t>(m_material)].name + '\n';
    }
    const bool has_uv = patch(f) >= 0;
    std::string line = "f";
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const std::string vertex = std::to_string(get(m_number, target(h, m_mesh)) + 1);
      line += ' ' + vertex;
      if(has_uv)
        line += '/' + std::to_string(number_of(h));
      if(has_normals)
        line += (has_uv ? "/" : "//") + vertex;
    }
    m_text += line + '\n';
  }

  const PolygonMesh& m_mesh;
  const Corner_coordinates<PolygonMesh, UVMap> m_coordinates;
  FaceMaterialMap m_face_materials;
  const std::vector<OBJ_material>& m_materials;
  const NamedParameters& m_np;
  const int m_precision;
  typename boost::property_map<PolygonMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type
      m_number;
  std::vector<std::vector<Corner>> m_corners; // of each vertex
  std::size_t m_count = 0;
  long m_material = -1; // that of the face before
  std::ostream* m_out = nullptr;
  std::string m_text;
};

// Writes a mesh and its materials to files.
template <typename PolygonMesh, typename UVMap, typename FaceMaterialMap, typename NamedParameters>
OBJ_report write_obj_files(const std::string& fname, const PolygonMesh& mesh, UVMap uv,
                           FaceMaterialMap face_materials, const std::vector<OBJ_material>& materials,
                           const NamedParameters& np)
{
  Obj_mesh_writer<PolygonMesh, UVMap, FaceMaterialMap, NamedParameters> writer(mesh, uv, face_materials,
                                                                               materials, np);
  OBJ_report report = writer.check();
  if(!report) {
    report.message = fname + ": " + report.message;
    return report;
  }
  const std::filesystem::path material_file = std::filesystem::path(fname).replace_extension(".mtl");
  if(!materials.empty() && material_file == std::filesystem::path(fname))
    return obj_failure(Diagnosis::WRONG_OPTION, fname + ": this is the name of the file of materials");
  std::ofstream out(fname, std::ios::binary), materials_out;
  if(!out)
    return obj_failure(Diagnosis::CANNOT_OPEN, "cannot open " + fname);
  if(!materials.empty()) {
    materials_out.open(material_file, std::ios::binary);
    if(!materials_out)
      return obj_failure(Diagnosis::CANNOT_OPEN, "cannot open " + material_file.string());
    write_obj_materials(materials_out, materials);
  }
  writer.write(out, materials.empty() ? std::string() : material_file.filename().string());
  if(!out.flush())
    return obj_failure(Diagnosis::CANNOT_WRITE, fname + ": writing failed");
  if(!materials.empty() && !materials_out.flush())
    return obj_failure(Diagnosis::CANNOT_WRITE, material_file.string() + ": writing failed");
  return report;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MESH_H
