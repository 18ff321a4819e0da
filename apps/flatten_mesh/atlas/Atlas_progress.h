// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_PROGRESS_H
#define FLATTEN_MESH_ATLAS_PROGRESS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress_bar.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Real_timer.h>
#include <CGAL/Texture_atlas/Atlas_visitor.h>

#include <iostream>
#include <string>

#include <unistd.h>

namespace flatten_mesh {

// Tells on standard error what is being done: in a progress bar if that is a terminal, or with `--verbose` in a line
// for every stage when it is over.
class Atlas_progress : public TA::Atlas_visitor
{
public:
  explicit Atlas_progress(const Command_line& command)
      : m_tells_stages(command.verbose),
        m_bar(!command.quiet && !command.verbose && ::isatty(STDERR_FILENO) == 1)
  {}

  void stage(const std::string& name)
  {
    end_stage();
    m_stage = name;
    m_timer.reset();
    m_timer.start();
    m_bar.stage(name);
  }

  bool start(const Stage stage) override
  {
    this->stage(name_of(stage));
    return true;
  }

  bool progress(const double share) override
  {
    m_bar.share(share);
    return true;
  }

  // Makes room for a line of another text.
  void clear_line() { m_bar.clear_line(); }

  // Nothing goes on any more.
  void end()
  {
    end_stage();
    m_bar.clear();
  }

private:
  static std::string name_of(const Stage stage)
  {
    switch(stage) {
    case READ:
      return "checking the surface";
    case CHARTS:
      return "cutting and flattening";
    case PACK:
      return "packing";
    case CERTIFY:
      return "checking the atlas";
    case MEASURE:
      return "measuring";
    default:
      return "collecting";
    }
  }

  void end_stage()
  {
    if(m_timer.is_running()) {
      m_timer.stop();
    }
    if(m_tells_stages && !m_stage.empty()) {
      std::cerr << m_stage << ": " << format_number("%.3f s", m_timer.time()) << std::endl;
    }
    m_stage.clear();
  }

  bool m_tells_stages;
  std::string m_stage;
  CGAL::Real_timer m_timer;
  Progress_bar m_bar;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ATLAS_PROGRESS_H
