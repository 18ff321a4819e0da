// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_MODEL_H
#define FLATTEN_MESH_READ_MODEL_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/explain_unreadable.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/read_obj.h"
#include "flatten_mesh/model/read_ply.h"
#include "flatten_mesh/texts.h"

#include <CGAL/IO/polygon_soup_io.h>

#ifdef CGAL_USE_VTK
#include <vtkObject.h>
#endif

#include <boost/io/ios_state.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void check_file_is_there(const std::string& name)
{
  std::error_code ignored;
  if(!std::filesystem::exists(name, ignored)) {
    throw Input_error("there is no file '" + name + "': check its name and folder");
  }
  if(std::filesystem::is_directory(name, ignored)) {
    throw Input_error("'" + name + "' is a folder: name a mesh file");
  }
  if(!std::ifstream(name)) {
    throw Input_error("'" + name + "' cannot be read: check its permissions");
  }
  if(std::filesystem::is_regular_file(name, ignored) && std::filesystem::file_size(name, ignored) == 0) {
    throw Input_error("'" + name + "' is empty: export the mesh again");
  }
}

inline void check_file_format(const std::string& name)
{
  const std::array<const char*, 6> known = {"off", "obj", "ply", "stl", "ts", "vtp"};
  const std::string format = file_format(name);
  if(std::find(known.begin(), known.end(), format) == known.end()) {
    throw Input_error("cannot tell the format of '" + name +
                      "': its name must end with .off, .obj, .ply, .stl, .ts or .vtp");
  }
#ifndef CGAL_USE_VTK
  if(format == "vtp") {
    throw Input_error("cannot read '" + name +
                      "': this program was built without VTK; convert the file to PLY");
  }
#endif
}

// OFF: points, their normals and colours, polygons
inline bool read_off(std::istream& file, Model& model, std::vector<Polygon>& polygons)
{
  std::vector<CGAL::IO::Color> colors;
  const auto parameters = CGAL::parameters::vertex_normal_output_iterator(std::back_inserter(model.normals))
                              .vertex_color_output_iterator(std::back_inserter(colors))
                              .vertex_texture_output_iterator(std::back_inserter(model.texture));
  if(!CGAL::IO::read_OFF(file, model.points, polygons, parameters)) {
    return false;
  }
  for(const CGAL::IO::Color& color : colors) {
    model.colors.push_back({color.red() / 255., color.green() / 255., color.blue() / 255., 1});
  }
  model.has_point_normals = !model.normals.empty();
  model.has_point_texture = !model.texture.empty();
  return true;
}

// What CGAL reads into separate polygons
inline bool read_polygons(std::istream& file, const std::string& format, Model& model)
{
  std::vector<Polygon> polygons;
  const bool is_right =
#ifdef CGAL_USE_VTK
      format == "vtp" ? CGAL::IO::read_VTP(model.file, model.points, polygons) :
#endif
      format == "off"   ? read_off(file, model, polygons)
      : format == "stl" ? CGAL::IO::read_STL(file, model.points, polygons)
                        : CGAL::IO::read_GOCAD(file, model.points, polygons);
  for(const Polygon& polygon : polygons) {
    for(const std::size_t v : polygon) {
      model.vertices.push_back(v < no_index ? static_cast<Index>(v) : no_index);
    }
    model.end_polygon();
  }
  return is_right;
}

// Whether CGAL can read the file. Catches the exceptions of CGAL's readers, and hides what they print on standard
// error.
inline bool try_to_read(const std::string& format, Model& model)
{
  const boost::io::ios_rdbuf_saver no_output(std::cout, nullptr), no_errors(std::cerr, nullptr);
  try {
#ifdef CGAL_USE_VTK
    vtkObject::GlobalWarningDisplayOff();
#endif
    std::ifstream file;
    open_file(model.file, file);
    return format == "ply" ? read_ply(file, model) : read_polygons(file, format, model);
  } catch(const std::bad_alloc&) {
    throw;
  } catch(const Input_error&) {
    throw;
  } catch(const std::exception&) {
    return false;
  }
}

} // namespace internal

// Reads a file with everything that can be written again. Throws an `Input_error` if it cannot be read. Does not check
// whether the polygons fit together; of an OBJ file, degenerate faces are refused at once if they are not kept,
// because then their line is known.
inline Model read_model(const std::string& name, const Degenerate_faces degenerate, Notes& notes)
{
  internal::check_file_is_there(name);
  internal::check_file_format(name);
  const std::string format = file_format(name);
  Model model;
  model.file = name;
  model.is_welded = format == "stl";
  if(format == "obj") {
    std::ifstream file;
    internal::open_file(name, file);
    read_obj(file, model, degenerate, notes);
  } else if(!internal::try_to_read(format, model)) {
    throw Input_error(explain_unreadable_file(name));
  }
  return model;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_MODEL_H
