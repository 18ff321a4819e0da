// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_PICTURES_H
#define FLATTEN_MESH_GLTF_PICTURES_H

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// For tinygltf: pictures stay as they are. Those in buffers are there already, and not yet known to be.
inline bool keep_picture(tinygltf::Image* const image, int, std::string*, std::string*, int, int,
                         const unsigned char* const bytes, const int size, void*)
{
  if(image->bufferView < 0 && size > 0) {
    image->image.assign(bytes, bytes + size);
  }
  return true;
}

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

// Moves pictures that are files, or texts, into buffers. Throws if one is no picture.
inline void take_pictures(Gltf_file& file)
{
  for(std::size_t i = 0; i < file.model.images.size(); ++i) {
    tinygltf::Image& image = file.model.images[i];
    const std::string& known = image.uri.empty() ? image.name : image.uri;
    const std::string text = "picture " + std::to_string(i) + (known.empty() ? "" : " ('" + known + "')");
    if(image.bufferView < 0) {
      if(image.image.empty()) {
        refuse_gltf(file.name, text + " cannot be read: there is no such file, or it is empty");
      }
      tinygltf::BufferView view;
      view.buffer = static_cast<int>(file.bytes.size());
      view.byteLength = image.image.size();
      file.bytes.push_back(std::move(image.image));
      image.image.clear();
      image.uri.clear();
      image.bufferView = static_cast<int>(file.model.bufferViews.size());
      file.model.bufferViews.push_back(view);
    }
    const auto [first, size] = Gltf_accessors(file).view(image.bufferView, text);
    image.mimeType = type_of_picture({reinterpret_cast<const char*>(first), size});
    if(image.mimeType.empty()) {
      refuse_gltf(file.name, text + " is damaged, or neither PNG, JPEG, WebP, KTX2 nor DDS");
    }
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_PICTURES_H
