// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MATERIALS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MATERIALS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/IO/OBJ_material.h>
#include <CGAL/Texture_atlas/internal/files/text_lines.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Returns what is wrong with the materials, or an empty string. Line breaks would end a name, and blanks around it get
// lost.
inline std::string wrong_material(const std::vector<OBJ_material>& materials)
{
  const auto is_wrong = [](const std::string& name) {
    return name.find_first_of("\r\n") != name.npos ||
           (!name.empty() && std::string(" \t#").find(name.front()) != std::string::npos) ||
           (!name.empty() && std::string(" \t\\").find(name.back()) != std::string::npos);
  };
  for(std::size_t i = 0; i < materials.size(); ++i) {
    const OBJ_material& material = materials[i];
    const std::string begin = "material " + std::to_string(i);
    if(material.name.empty() || is_wrong(material.name))
      return begin + " has an empty name, or one that cannot be written";
    for(std::size_t j = 0; j < i; ++j)
      if(materials[j].name == material.name)
        return begin + " has the same name as material " + std::to_string(j);
    for(const std::string* image :
        {&material.color_image, &material.normal_image, &material.displacement_image})
      if(is_wrong(*image))
        return begin + " names a picture whose name cannot be written";
    for(const double number : material.color)
      if(!(number >= 0 && number <= 1))
        return begin + " has a colour outside of 0 to 1";
    if(!std::isfinite(material.least_displacement) || !std::isfinite(material.greatest_displacement))
      return begin + " has a displacement that is not finite";
  }
  return std::string();
}

// Some programs take the picture of normals from `norm`, others from `map_Bump`.
inline void write_obj_materials(std::ostream& out, const std::vector<OBJ_material>& materials)
{
  for(const OBJ_material& material : materials) {
    std::string text = "newmtl " + material.name + "\nKd";
    for(const double number : material.color)
      append_number(text += ' ', number);
    text += '\n';
    if(!material.color_image.empty())
      text += "map_Kd " + material.color_image + '\n';
    if(!material.normal_image.empty())
      text += "norm " + material.normal_image + "\nmap_Bump " + material.normal_image + '\n';
    if(!material.displacement_image.empty()) {
      append_number(text += "disp -mm ", material.least_displacement);
      append_number(text += ' ', material.greatest_displacement - material.least_displacement);
      text += ' ' + material.displacement_image + '\n';
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  }
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_WRITE_OBJ_MATERIALS_H
