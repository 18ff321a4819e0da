// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_POLYGON_SOUP_H
#define FLATTEN_MESH_READ_POLYGON_SOUP_H

#include "Input_error.h"
#include "Polygon_soup.h"
#include "Silence.h"
#include "explain_unreadable_file.h"

#include <CGAL/IO/polygon_soup_io.h>

#ifdef CGAL_USE_VTK
#include <vtkObject.h>
#endif

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <string>

namespace flatten_mesh {

namespace internal {

inline std::string file_format(const std::string& name)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  return boost::algorithm::to_lower_copy(extension.empty() ? extension : extension.substr(1));
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

// Whether CGAL can read the file. Its readers may throw, and talk to standard error: neither gets out of
// here.
inline bool try_to_read(const std::string& name, Polygon_soup& soup)
{
  const Silence silence;
  try {
#ifdef CGAL_USE_VTK
    // CGAL 5.5 forgets this format in the function below.
    if(file_format(name) == "vtp") {
      vtkObject::GlobalWarningDisplayOff();
      return CGAL::IO::read_VTP(name, soup.points, soup.polygons);
    }
#endif
    return CGAL::IO::read_polygon_soup(name, soup.points, soup.polygons);
  } catch(const std::exception&) {
    return false;
  }
}

} // namespace internal

// Throws an `Input_error` if the file cannot be read. The content is not looked at.
inline Polygon_soup read_polygon_soup(const std::string& name)
{
  check_file_is_there(name);
  internal::check_file_format(name);
  Polygon_soup soup;
  if(!internal::try_to_read(name, soup)) {
    throw Input_error(explain_unreadable_file(name));
  }
  return soup;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_POLYGON_SOUP_H
