// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_IMPL_H
#define FLATTEN_MESH_WRITE_MODEL_IMPL_H

#include "flatten_mesh/compiled.h"
#include "flatten_mesh/model/write_model.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/write_model_obj.h"
#include "flatten_mesh/model/write_model_ply.h"

#ifdef ABF_WITH_GLTF
#include "flatten_mesh/model/write_model_glb.h"
#include "flatten_mesh/model/write_model_into_gltf.h"
#endif

#include <string>

namespace flatten_mesh {

FLATTEN_MESH_INLINE void write_model(Output_file& file, const std::string& name, const Model& model,
                                     const Model_texture& texture, const Model_style& style)
{
  const std::string format = file_format(name);
  if(format == "ply") {
    write_model_ply(file, model, texture, style);
#ifdef ABF_WITH_GLTF
  } else if(format == "glb" && model.gltf.file != nullptr && !texture.has_pictures()) {
    write_model_into_gltf(file, name, model, texture, style);
  } else if(format == "glb") {
    write_model_glb(file, name, model, texture, style);
#endif
  } else {
    write_model_obj(file, name, model, texture);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_MODEL_IMPL_H
