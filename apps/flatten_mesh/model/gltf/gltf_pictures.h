// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_PICTURES_H
#define FLATTEN_MESH_GLTF_PICTURES_H

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/read_uri.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The type of a whole picture, or an empty string
inline std::string type_of_picture(const std::string_view bytes)
{
  const auto begins = [bytes](const std::string_view mark, const std::size_t place = 0) {
    return bytes.size() >= place + mark.size() && bytes.substr(place, mark.size()) == mark;
  };
  if(begins("\x89PNG\r\n\x1A\n")) {
    return bytes.find("IEND", bytes.size() < 1000 ? 0 : bytes.size() - 1000) != bytes.npos ? "image/png" : "";
  }
  if(begins("\xFF\xD8\xFF")) {
    return bytes.rfind("\xFF\xD9") != bytes.npos ? "image/jpeg" : "";
  }
  return begins("RIFF") && begins("WEBP", 8)  ? "image/webp"
         : begins("\xABKTX 20\xBB\r\n\x1A\n") ? "image/ktx2"
         : begins("DDS ")                     ? "image/vnd-ms.dds"
                                              : "";
}

// Moves pictures that are files, or texts, into buffers. Those that are not there, or damaged, stay as they are named.
inline void take_pictures(Gltf_file& file, std::vector<std::string>& remarks)
{
  const std::vector<Json*> images = objects_in(file, file.json, "images");
  for(std::size_t i = 0; i < images.size(); ++i) {
    Json& image = *images[i];
    const std::string uri = text_in(image, "uri"),
                      known = uri.empty() || is_data(uri) ? text_in(image, "name") : uri;
    const std::string text =
        "picture " + std::to_string(i) + (known.empty() ? "" : " ('" + in_one_line(known) + "')");
    int view = number_in(file, image, "bufferView", text);
    if(view < 0) {
      std::vector<unsigned char> bytes;
      if(!read_uri(file, uri, bytes) || bytes.empty()) {
        remarks.push_back(text + " cannot be read: " +
                          (is_data(uri) ? "it is no data" : "there is no such file, or it is empty"));
        continue;
      }
      view = static_cast<int>(file.model.bufferViews.size());
      file.model.bufferViews.emplace_back();
      file.model.bufferViews.back().buffer = static_cast<int>(file.bytes.size());
      file.model.bufferViews.back().byteLength = bytes.size();
      file.bytes.push_back(std::move(bytes));
    }
    const auto [first, size] = Gltf_accessors(file).view(view, text);
    const std::string type = type_of_picture({reinterpret_cast<const char*>(first), size});
    if(type.empty()) {
      remarks.push_back(text + " is damaged, or neither PNG, JPEG, WebP, KTX2 nor DDS");
      continue;
    }
    image.erase("uri");
    image["bufferView"] = view;
    image["mimeType"] = type;
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_PICTURES_H
