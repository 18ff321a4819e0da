// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FORMATS_H
#define FLATTEN_MESH_FORMATS_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// The formats of surfaces that this program reads, as built
inline const std::vector<std::string>& formats_read()
{
  static const std::vector<std::string> formats = {
      "off", "obj",  "ply", "stl", "ts",
#ifdef CGAL_USE_VTK
      "vtp",
#endif
#ifdef ABF_WITH_GLTF
      "glb", "gltf",
#endif
  };
  return formats;
}

inline bool is_format_read(const std::string& format)
{
  return std::find(formats_read().begin(), formats_read().end(), format) != formats_read().end();
}

inline bool is_gltf(const std::string& format)
{
  return format == "glb" || format == "gltf";
}

// Their names as a list
inline std::string formats_text(const std::string& separator, const std::string& last_separator)
{
  std::string text;
  for(std::size_t i = 0; i < formats_read().size(); ++i) {
    text += (i == 0 ? "" : i + 1 == formats_read().size() ? last_separator : separator) + formats_read()[i];
  }
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FORMATS_H
