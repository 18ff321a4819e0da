// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_ACCESSORS_H
#define FLATTEN_MESH_GLTF_ACCESSORS_H

#include "flatten_mesh/model/gltf/Gltf_elements.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

namespace flatten_mesh {

// An accessor, and what it is used for
struct Gltf_accessor_name
{
  int number = -1;
  std::string use; // such as "POSITION of mesh 'wheel'"

  std::string text() const { return "accessor " + std::to_string(number) + " (" + use + ")"; }
};

// Reads the elements of accessors. All that they name is checked.
class Gltf_accessors
{
public:
  explicit Gltf_accessors(const Gltf_file& file) : m_file(file) {}

  Gltf_elements read(const Gltf_accessor_name& name) const
  {
    const tinygltf::Accessor& accessor =
        gltf_element(m_file, m_file.model.accessors, name.number, name.use, "accessor");
    Gltf_elements elements;
    elements.component_type = accessor.componentType;
    elements.type = accessor.type;
    elements.is_normalized = accessor.normalized;
    elements.count = accessor.count;
    if(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) < 0) {
      refuse_gltf(m_file.name,
                  name.text() + " has the unknown type of numbers " + std::to_string(accessor.componentType));
    }
    if(accessor.bufferView >= 0) {
      read_view(name, accessor.bufferView, accessor.byteOffset, elements);
    } else {
      read_zeros(name, elements);
    }
    if(accessor.sparse.isSparse) {
      replace_sparse(name, accessor, elements);
    }
    return elements;
  }

  // The bytes of a buffer view
  std::pair<const unsigned char*, std::size_t> view(const int number, const std::string& from) const
  {
    const tinygltf::BufferView& view =
        gltf_element(m_file, m_file.model.bufferViews, number, from, "buffer view");
    const std::string text = "buffer view " + std::to_string(number);
    const auto& bytes = gltf_element(m_file, m_file.bytes, view.buffer, text, "buffer");
    if(view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
      refuse_gltf(m_file.name, from + ": " + text + " lies outside of buffer " + std::to_string(view.buffer) +
                                   ", which has " + count_text(bytes.size(), "byte"));
    }
    return {bytes.data() + view.byteOffset, view.byteLength};
  }

private:
  // Appends elements of a view.
  void read_view(const Gltf_accessor_name& name, const int number, const std::size_t offset,
                 Gltf_elements& elements) const
  {
    const auto [first, length] = view(number, name.text());
    const std::size_t given = m_file.model.bufferViews[static_cast<std::size_t>(number)].byteStride,
                      size = elements.element_size(), stride = given == 0 ? size : given;
    if(stride < size) {
      refuse_gltf(m_file.name, name.text() + " has elements of " + count_text(size, "byte") +
                                   ", but buffer view " + std::to_string(number) + " has room for " +
                                   std::to_string(stride) + " each");
    }
    if(elements.count == 0) {
      return;
    }
    if(offset > length || size > length - offset || elements.count - 1 > (length - offset - size) / stride) {
      refuse_gltf(m_file.name, name.text() + " lies outside of buffer view " + std::to_string(number) +
                                   ": it promises " + count_text(elements.count, "element") + " of " +
                                   count_text(size, "byte") + " from byte " + std::to_string(offset) +
                                   " on, and the view has " + std::to_string(length));
    }
    elements.bytes.resize(elements.count * size);
    for(std::size_t i = 0; i < elements.count; ++i) {
      std::memcpy(elements.bytes.data() + i * size, first + offset + i * stride, size);
    }
  }

  // Without a view, all elements are zero at first. A count alone is not believed.
  void read_zeros(const Gltf_accessor_name& name, Gltf_elements& elements) const
  {
    std::size_t most = 0;
    for(const tinygltf::Accessor& other : m_file.model.accessors) {
      most = other.bufferView >= 0 ? (std::max)(most, other.count) : most;
    }
    std::size_t bytes = 0;
    for(const auto& buffer : m_file.bytes) {
      bytes += buffer.size();
    }
    if(elements.count > (std::min)(most, bytes)) {
      refuse_gltf(m_file.name, name.text() + " promises " + count_text(elements.count, "element") +
                                   ", and has no buffer view");
    }
    elements.bytes.assign(elements.count * elements.element_size(), 0);
  }

  void replace_sparse(const Gltf_accessor_name& name, const tinygltf::Accessor& accessor,
                      Gltf_elements& elements) const
  {
    const auto& sparse = accessor.sparse;
    // These numbers have signs before version 2.9 of tinygltf only.
    const auto is_negative = [](const long long number) { return number < 0; };
    if(is_negative(sparse.count) || is_negative(sparse.indices.byteOffset) ||
       is_negative(sparse.values.byteOffset) ||
       (sparse.indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
        sparse.indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        sparse.indices.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
      refuse_gltf(m_file.name, name.text() + " has wrong sparse elements");
    }
    Gltf_elements indices, values = elements;
    indices.component_type = sparse.indices.componentType;
    indices.type = TINYGLTF_TYPE_SCALAR;
    indices.count = values.count = static_cast<std::size_t>(sparse.count);
    read_view(name, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), indices);
    read_view(name, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), values);
    const std::size_t size = elements.element_size();
    for(std::size_t i = 0; i < indices.count; ++i) {
      const auto place = static_cast<std::size_t>(indices.raw_number(i));
      if(place >= elements.count) {
        refuse_gltf(m_file.name, name.text() + " has the sparse element " + std::to_string(place) + " of " +
                                     std::to_string(elements.count));
      }
      std::memcpy(elements.bytes.data() + place * size, values.bytes.data() + i * size, size);
    }
  }

  const Gltf_file& m_file;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_ACCESSORS_H
