// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_H
#define FLATTEN_MESH_WRITE_MODEL_H

#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Model_style.h"

#include <string>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Writes a model with its texture in the format that the name of the file tells: PLY, binary glTF, or else OBJ.
void write_model(Output_file& file, const std::string& name, const Model& model, const Model_texture& texture,
                 const Model_style& style = Model_style());

} // namespace flatten_mesh

#ifndef FLATTEN_MESH_COMPILED
#include "flatten_mesh/model/write_model_impl.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>
#endif

#endif // FLATTEN_MESH_WRITE_MODEL_H
