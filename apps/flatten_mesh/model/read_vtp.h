// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_VTP_H
#define FLATTEN_MESH_READ_VTP_H

#ifdef CGAL_USE_VTK

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/texts.h"

#include <CGAL/IO/VTK.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <vtkObject.h>

#include <boost/io/ios_state.hpp>

#include <cstddef>
#include <iostream>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Reads a VTP file, by means of VTK. Hides what is printed about errors.
inline void read_vtp(Model& model)
{
  const boost::io::ios_rdbuf_saver no_output(std::cout, nullptr), no_errors(std::cerr, nullptr);
  vtkObject::GlobalWarningDisplayOff();
  std::vector<Polygon> polygons;
  if(!CGAL::IO::read_VTP(model.name, model.points, polygons)) {
    throw Input_error("cannot read '" + model.name + "': it is damaged or cut short; export the mesh again");
  }
  for(const Polygon& polygon : polygons) {
    for(const std::size_t v : polygon) {
      model.vertices.push_back(v < no_index ? static_cast<Index>(v) : no_index);
    }
    model.end_polygon();
  }
}

} // namespace flatten_mesh

#endif // CGAL_USE_VTK

#endif // FLATTEN_MESH_READ_VTP_H
