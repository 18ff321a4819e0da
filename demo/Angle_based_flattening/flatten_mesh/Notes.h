// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NOTES_H
#define FLATTEN_MESH_NOTES_H

#include <iostream>
#include <string>
#include <vector>

namespace flatten_mesh {

// Warnings to the user: printed on standard error at once, and kept for the report.
class Notes
{
public:
  void add(const std::string& text)
  {
    std::cerr << "flatten_mesh: note: " << text << std::endl;
    m_texts.push_back(text);
  }

  const std::vector<std::string>& texts() const { return m_texts; }

private:
  std::vector<std::string> m_texts;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NOTES_H
