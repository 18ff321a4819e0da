// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef WITHOUT_SUPERLU_CHECKS_H
#define WITHOUT_SUPERLU_CHECKS_H

#include <string>

#ifdef CGAL_SUPERLU_ENABLED
#error "This is about programs without SuperLU."
#endif

namespace without_superlu {

void flatten_charts();
void make_atlases();

void expect(bool done, const std::string& what, const std::string& message);

} // namespace without_superlu

#endif // WITHOUT_SUPERLU_CHECKS_H
