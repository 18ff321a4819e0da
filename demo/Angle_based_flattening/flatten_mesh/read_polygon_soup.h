// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_POLYGON_SOUP_H
#define FLATTEN_MESH_READ_POLYGON_SOUP_H

#include "Notes.h"
#include "Polygon_soup.h"
#include "explain_unreadable.h"
#include "file_names.h"
#include "read_obj.h"
#include "texts.h"

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

// Whether CGAL can read the file. Catches the exceptions of CGAL's readers, and hides what they print on standard
// error.
inline bool try_to_read(const std::string& name, Polygon_soup& soup)
{
  const boost::io::ios_rdbuf_saver no_output(std::cout, nullptr), no_errors(std::cerr, nullptr);
  const std::string format = file_format(name);
  try {
#ifdef CGAL_USE_VTK
    if(format == "vtp") {
      vtkObject::GlobalWarningDisplayOff();
      return CGAL::IO::read_VTP(name, soup.points, soup.polygons);
    }
#endif
    std::ifstream file;
    open_file(name, file);
    return format == "off"   ? CGAL::IO::read_OFF(file, soup.points, soup.polygons)
           : format == "ply" ? CGAL::IO::read_PLY(file, soup.points, soup.polygons)
           : format == "stl" ? CGAL::IO::read_STL(file, soup.points, soup.polygons)
                             : CGAL::IO::read_GOCAD(file, soup.points, soup.polygons);
  } catch(const std::bad_alloc&) {
    throw;
  } catch(const std::exception&) {
    return false;
  }
}

} // namespace internal

// Throws an `Input_error` if the file cannot be read. Does not check whether the polygons fit together.
inline Polygon_soup read_polygon_soup(const std::string& name, Notes& notes)
{
  internal::check_file_is_there(name);
  internal::check_file_format(name);
  Polygon_soup soup;
  soup.is_welded = file_format(name) == "stl";
  if(file_format(name) == "obj") {
    std::ifstream file;
    internal::open_file(name, file);
    read_obj(file, name, soup, notes);
  } else if(!internal::try_to_read(name, soup)) {
    throw Input_error(explain_unreadable_file(name));
  }
  return soup;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_POLYGON_SOUP_H
