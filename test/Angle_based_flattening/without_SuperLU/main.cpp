// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <iostream>

static int faults = 0;

void without_superlu::expect(bool done, const std::string& what, const std::string& message)
{
  std::cout << what << ": " << (done ? "done" : message) << "\n";
  faults += !done;
}

int main()
{
  without_superlu::flatten_charts();
  without_superlu::make_atlases();
  return faults;
}
