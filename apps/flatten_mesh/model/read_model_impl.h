// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_MODEL_IMPL_H
#define FLATTEN_MESH_READ_MODEL_IMPL_H

#include "flatten_mesh/compiled.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/file_content.h"
#include "flatten_mesh/model/formats.h"
#include "flatten_mesh/model/read_obj.h"
#include "flatten_mesh/model/read_off.h"
#include "flatten_mesh/model/read_ply.h"
#include "flatten_mesh/model/read_stl.h"
#include "flatten_mesh/model/read_ts.h"
#include "flatten_mesh/model/read_vtp.h"
#include "flatten_mesh/texts.h"

#ifdef ABF_WITH_GLTF
#include "flatten_mesh/model/read_gltf.h"
#endif

#include <boost/algorithm/string/case_conv.hpp>

#include <string>
#include <string_view>

namespace flatten_mesh {

namespace internal {

inline void check_format(const std::string& name, const std::string& format)
{
  if(is_format_read(format)) {
    return;
  }
  if(format == "vtp") {
    throw Input_error("cannot read '" + name +
                      "': this program was built without VTK; convert the file to PLY");
  }
  if(is_gltf(format)) {
    throw Input_error(
        "cannot read '" + name +
        "': this program was built without tinygltf: install libtinygltf-dev and build it again");
  }
  throw Input_error("cannot tell the format of '" + name + "': its name must end with ." +
                    formats_text(", .", " or .") + (is_other_file(name) ? ", or --format must tell it" : ""));
}

inline void check_surface(const Model& model)
{
  if(model.points.empty() || model.number_of_polygons() == 0) {
    throw Input_error("'" + model.name + "': the file has " +
                      (model.points.empty()
                           ? "no vertices; export the mesh again"
                           : "vertices but no faces; a point cloud has to be made into a surface first"));
  }
}

} // namespace internal

FLATTEN_MESH_INLINE void read_content(const std::string_view content, const std::string& format,
                                      const Degenerate_faces degenerate, Model& model, Notes& notes,
                                      [[maybe_unused]] const Gltf_options& gltf)
{
  const std::string_view text = without_byte_order_mark(content);
  try {
    if(format == "obj") {
      read_obj(text, model, degenerate, notes);
    } else if(format == "off") {
      read_off(text, model, degenerate, notes);
    } else if(format == "ply") {
      read_ply(text, model, degenerate, notes);
    } else if(format == "stl") {
      read_stl(text, model, degenerate, notes);
    } else if(format == "ts") {
      read_ts(text, model, degenerate);
#ifdef ABF_WITH_GLTF
    } else if(is_gltf(format)) {
      read_gltf(text, model, gltf, notes);
#endif
    }
    internal::check_surface(model);
  } catch(const Input_error& error) {
    const std::string kind = kind_of_content(text);
    if(kind.empty() || boost::algorithm::to_lower_copy(kind) == format) {
      throw;
    }
    throw Input_error(std::string(error.what()) + " (its content looks " + kind + ", not " +
                      boost::algorithm::to_upper_copy(format) + ")");
  }
}

FLATTEN_MESH_INLINE Model read_model(const std::string& name, const Degenerate_faces degenerate, Notes& notes,
                                     const std::string& format_of_pipe, const Gltf_options& gltf)
{
  Model model;
  model.name = name;
  const bool is_pipe = name == standard_input || is_other_file(name);
  const std::string format = is_pipe && !format_of_pipe.empty() ? format_of_pipe : file_format(name);
  internal::check_file_is_there(name);
  internal::check_format(name, format);
#ifdef CGAL_USE_VTK
  if(format == "vtp") { // VTK opens the file itself
    if(is_pipe) {
      throw Input_error("'" + name + "' is a pipe, and VTP is read from files only: convert it to PLY");
    }
    read_vtp(model);
    internal::check_surface(model);
    return model;
  }
#endif
  read_content(content_of_file(name), format, degenerate, model, notes, gltf);
  model.shrink_to_fit();
  return model;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_MODEL_IMPL_H
