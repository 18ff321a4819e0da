// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BASE64_H
#define FLATTEN_MESH_BASE64_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A number of four bytes in the order that pages expect
template <class Number>
std::uint32_t little_endian_bits(const Number number)
{
  static_assert(sizeof(Number) == sizeof(std::uint32_t), "arrays of pages have numbers of four bytes");
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return boost::endian::native_to_little(bits);
}

} // namespace internal

// Appends numbers of four bytes as base64.
template <class Number>
void append_base64(std::string& text, const std::vector<Number>& numbers)
{
  namespace iterators = boost::archive::iterators;
  using Letters = iterators::base64_from_binary<iterators::transform_width<const char*, 6, 8>>;
  std::vector<std::uint32_t> bits;
  bits.reserve(numbers.size() + 1); // so that there is a place behind the last byte, which the letters read
  for(const Number number : numbers) {
    bits.push_back(internal::little_endian_bits(number));
  }
  const std::size_t bytes = sizeof(std::uint32_t) * bits.size();
  const std::size_t padding = (3 - bytes % 3) % 3;
  bits.push_back(0);
  const char* const begin = reinterpret_cast<const char*>(bits.data());
  text.reserve(text.size() + (bytes + padding) / 3 * 4);
  text.append(Letters(begin), Letters(begin + bytes));
  text.append(padding, '=');
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BASE64_H
