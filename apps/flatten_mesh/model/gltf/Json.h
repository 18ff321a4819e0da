// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JSON_H
#define FLATTEN_MESH_JSON_H

#include <nlohmann/json.hpp>

namespace flatten_mesh {

// Members stay in their order.
using Json = nlohmann::ordered_json;

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JSON_H
