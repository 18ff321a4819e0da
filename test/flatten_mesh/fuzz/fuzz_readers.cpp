// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A target of libFuzzer: reads bytes as a file in one of the formats of flatten_mesh, and makes surfaces of its
// polygons. The result must be a consistent model, or an error with a message, which JSON can hold.

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/model/read_model.h"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

using namespace flatten_mesh;

void require(bool condition, const char* what)
{
  if(condition)
    return;
  std::cerr << "FAULT: " << what << std::endl;
  std::abort();
}

void require_attributes(const std::vector<Index>& corners, std::size_t corners_of_model,
                        std::size_t attributes)
{
  require(corners.empty() || corners.size() == corners_of_model, "attributes of some corners only");
  for(const Index index : corners)
    require(index == no_index || index < attributes, "an attribute that does not exist");
}

void require_consistent(const Model& model)
{
  const std::size_t points = model.points.size(), corners = model.vertices.size();
  require(points > 0 && model.number_of_polygons() > 0, "a surface without vertices or faces");
  require(model.first_corners.back() == corners, "corners without a polygon");
  for(std::size_t p = 0; p < model.number_of_polygons(); ++p)
    require(model.first_corners[p] < model.first_corners[p + 1], "a polygon without corners");
  require(model.colors.empty() || model.colors.size() == points, "colours of some points only");
  require(!model.has_point_normals || model.normals.size() == points, "normals of some points only");
  require(!model.has_point_texture || model.texture.size() == points, "texture of some points only");
  require_attributes(model.corner_texture, corners, model.texture.size());
  require_attributes(model.corner_normals, corners, model.normals.size());
  require(model.materials.empty() || model.materials.size() == model.number_of_polygons(),
          "too few materials");
}

void require_utf_8(const std::string& text)
{
  namespace utf = boost::locale::utf;
  for(auto c = text.begin(); c != text.end();) {
    const utf::code_point code = utf::utf_traits<char>::decode(c, text.end());
    require(code != utf::illegal && code != utf::incomplete && code >= 0x20, "JSON that is none");
  }
}

void read(std::string_view content, const std::string& format, bool repair)
{
  Command_line command;
  command.quiet = true;
  Notes notes = notes_of(command);
  Model model;
  model.name = "fuzz." + format;
  try {
    read_content(content, format, Degenerate_faces::KEPT, model, notes);
    require_consistent(model);
    const Atlas_input input = atlas_input_of(model, repair, notes);
    std::vector<Index> polygons = polygons_of_faces(input.model, input.mesh, input.origins);
    std::sort(polygons.begin(), polygons.end());
    std::size_t found =
        static_cast<std::size_t>(std::unique(polygons.begin(), polygons.end()) - polygons.begin());
    for(const TA::Atlas_report::Skipped& part : input.set_aside)
      found += part.number_of_faces;
    const std::vector<bool>& has_no_area = input.origins.has_no_area; // which is told with the atlas
    found += static_cast<std::size_t>(std::count(has_no_area.begin(), has_no_area.end(), true));
    require(found == model.number_of_polygons(), "a lost polygon");
  } catch(const Input_error& error) {
    require(*error.what() != '\0', "an error without a message");
    require_utf_8(internal::json_text(error.what()));
  }
  for(const std::string& note : notes.texts())
    require_utf_8(internal::json_text(note));
}

} // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  std::vector<std::string> formats = {"off", "obj", "ply", "stl", "ts"};
#ifdef ABF_WITH_GLTF
  formats.emplace_back("gltf");
#endif
  if(size == 0)
    return 0;
  const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  fuzz::read(content, formats[data[0] % formats.size()], data[0] < 128);
  return 0;
}
