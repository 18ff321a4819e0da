// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NOTES_H
#define FLATTEN_MESH_NOTES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/texts.h"

#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// Warnings to the user: printed on standard error at once, and kept for the report.
class Notes
{
public:
  // `make_room` is called before a text is printed.
  explicit Notes(
      const Command_line& command, std::function<void()> make_room = [] {})
      : m_command(command), m_make_room(std::move(make_room))
  {}

  // Names what the next texts are about, unless they do: a file in quotes, or nothing.
  void set_subject(const std::string& subject) { m_subject = subject; }

  void add(std::string text)
  {
    text = with_title(m_command, text);
    if(!m_subject.empty() && text.compare(0, m_subject.size(), m_subject) != 0) {
      text = m_subject + ": " + text;
    }
    if(!m_command.quiet) {
      m_make_room();
      std::cerr << "flatten_mesh: note: " << in_one_line(text) << std::endl;
    }
    m_texts.push_back(text);
  }

  const std::vector<std::string>& texts() const { return m_texts; }

private:
  const Command_line& m_command;
  std::function<void()> m_make_room;
  std::string m_subject;
  std::vector<std::string> m_texts;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NOTES_H
