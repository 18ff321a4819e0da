// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_ELEMENTS_H
#define FLATTEN_MESH_GLTF_ELEMENTS_H

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace flatten_mesh {

// Elements one after the other
struct Gltf_elements
{
  int component_type = 0;
  int type = 0;
  bool is_normalized = false;
  std::size_t count = 0;
  std::vector<unsigned char> bytes;

  std::size_t component_size() const
  {
    return static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
  }

  std::size_t width() const // the number of components
  {
    return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
  }

  std::size_t element_size() const { return component_size() * width(); }

  // As it is in the file
  double raw_number(const std::size_t i) const
  {
    const unsigned char* const place = bytes.data() + i * component_size();
    switch(component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return number_at<std::int8_t>(place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return number_at<std::uint8_t>(place);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return number_at<std::int16_t>(place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return number_at<std::uint16_t>(place);
    case TINYGLTF_COMPONENT_TYPE_INT:
      return number_at<std::int32_t>(place);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return number_at<std::uint32_t>(place);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return number_at<float>(place);
    default:
      return number_at<double>(place);
    }
  }

  std::vector<double> numbers() const
  {
    static const std::vector<double> largest = {127, 255, 32767, 65535, 2147483647, 4294967295};
    const auto kind = static_cast<std::size_t>(component_type - TINYGLTF_COMPONENT_TYPE_BYTE);
    const bool is_scaled = is_normalized && kind < largest.size();
    std::vector<double> result(count * width());
    for(std::size_t i = 0; i < result.size(); ++i) {
      result[i] = is_scaled ? (std::max)(raw_number(i) / largest[kind], -1.) : raw_number(i);
    }
    return result;
  }

private:
  template <class Number>
  static double
  number_at(const unsigned char* const place) // little endian, as this program's other binary files
  {
    Number number;
    std::memcpy(&number, place, sizeof(number));
    return static_cast<double>(number);
  }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_ELEMENTS_H
