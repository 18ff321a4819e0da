// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Method.h"
#include "Relaxed_map.h"
#include "linear_abf.h"
#include "logarithmic_abf.h"
#include "original_abf.h"
#include "paper_abf_plus_plus.h"

namespace ABF_benchmark {

std::vector<Method> own_methods()
{
  return {make_method<Original_ABF>("abf", "ABF (2001)"),
          make_method<Paper_ABF_plus_plus>("paper-abf++", "ABF++ to the letter (2005)"),
          make_method<Logarithmic_ABF>("log-abf", "ABF in logarithms (Zayer et al. 2005)"),
          make_method<Linear_ABF>("linear-abf", "linear ABF (2007)"),
          make_method<MIPS>("mips", "MIPS"),
          make_method<Stretch_minimizer>("stretch", "stretch minimization")};
}

} // namespace ABF_benchmark
