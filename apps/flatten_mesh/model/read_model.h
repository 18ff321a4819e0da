// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_MODEL_H
#define FLATTEN_MESH_READ_MODEL_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Degenerate_faces.h"
#include "flatten_mesh/model/Gltf_options.h"
#include "flatten_mesh/model/Model.h"

#include <string>
#include <string_view>

namespace flatten_mesh {

// Reads the content of a file with everything that can be written again, into a model that has the name of the
// file. Throws an `Input_error` if it cannot be read. Does not check whether the polygons fit together; of
// an OBJ file, degenerate faces are refused at once if they are not kept, because then their line is known.
void read_content(std::string_view content, const std::string& format, Degenerate_faces degenerate,
                  Model& model, Notes& notes, const Gltf_options& gltf = Gltf_options());

// Reads a file. Its name tells the format; of standard input, "-", and of pipes, `format` does.
Model read_model(const std::string& name, Degenerate_faces degenerate, Notes& notes,
                 const std::string& format_of_pipe = "", const Gltf_options& gltf = Gltf_options());

} // namespace flatten_mesh

#ifndef FLATTEN_MESH_COMPILED
#include "flatten_mesh/model/read_model_impl.h"
#endif

#endif // FLATTEN_MESH_READ_MODEL_H
