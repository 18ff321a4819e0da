// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PROGRESS_H
#define FLATTEN_MESH_PROGRESS_H

#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

#include <iostream>
#include <string>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

// The progress that `--verbose` prints on standard error: a line for every stage and for every Newton step.
class Progress : public SMP::Flattening_visitor
{
public:
  explicit Progress(const bool is_on) : m_is_on(is_on) {}

  bool is_on() const { return m_is_on; }

  void stage(const std::string& name, const double seconds, const std::string& remark = "") const
  {
    if(m_is_on) {
      std::cerr << name << ": " << format_number("%.3f s", seconds) << (remark.empty() ? "" : ", ") << remark
                << std::endl;
    }
  }

  // Seams are added to a map with this stretch.
  void round(const double stretch) const
  {
    if(m_is_on) {
      std::cerr << "scale stretch " << format_number("%.4g", stretch) << " misses the bound: more seams"
                << std::endl;
    }
  }

  bool step(const SMP::ABF_plus_plus_step& step) override
  {
    if(m_is_on) {
      std::cerr << "step " << step.iteration << ": energy " << format_number("%.9g", step.energy)
                << ", constraints within " << format_number("%.2e", step.constraint_residual)
                << ", step length " << format_number("%.3g", step.step_length) << ", promised decrease "
                << format_number("%.2e", step.predicted_decrease) << std::endl;
    }
    return true;
  }

private:
  bool m_is_on;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PROGRESS_H
