// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BINARY_DATA_H
#define FLATTEN_MESH_BINARY_DATA_H

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace flatten_mesh {

// The numbers in the bytes of a file
class Binary_data
{
public:
  Binary_data(const std::string_view bytes, const boost::endian::order order)
      : m_bytes(bytes), m_is_turned(order != boost::endian::order::native)
  {}

  std::size_t size() const { return m_bytes.size(); } // of what is left

  void skip(const std::size_t bytes) { m_bytes.remove_prefix((std::min)(bytes, m_bytes.size())); }

  // False at the end
  template <class Number>
  bool read(Number& number)
  {
    std::array<char, sizeof(Number)> bytes;
    if(m_bytes.size() < bytes.size()) {
      return false;
    }
    std::copy_n(m_bytes.begin(), bytes.size(), bytes.begin());
    if(m_is_turned) {
      std::reverse(bytes.begin(), bytes.end());
    }
    std::memcpy(&number, bytes.data(), bytes.size());
    skip(bytes.size());
    return true;
  }

private:
  std::string_view m_bytes;
  bool m_is_turned;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BINARY_DATA_H
