// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SILENCE_H
#define FLATTEN_MESH_SILENCE_H

#include <iostream>
#include <streambuf>

namespace flatten_mesh {

// As long as it lives, what goes to `std::cout` and `std::cerr` is lost.
class Silence
{
public:
  Silence() : m_cout(std::cout.rdbuf(&m_nowhere)), m_cerr(std::cerr.rdbuf(&m_nowhere)) {}

  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

  ~Silence()
  {
    std::cout.rdbuf(m_cout);
    std::cerr.rdbuf(m_cerr);
  }

private:
  struct Nowhere : public std::streambuf
  {
    int overflow(const int character) override { return traits_type::not_eof(character); }
  };

  Nowhere m_nowhere;
  std::streambuf* m_cout;
  std::streambuf* m_cerr;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SILENCE_H
