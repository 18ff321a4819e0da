// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_DATA_H
#define TEST_DATA_H

// Meshes that are not part of the repository. The suites that need them, `of_CGAL_meshes` and `of_reference_disks`, are
// tests of their own to ctest, which reports them as skipped where the meshes are missing.

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace test_data {

// CMake says where the folders are.
struct Folder
{
  const char* variable;

  std::string path() const
  {
    const char* value = std::getenv(variable);
    return value != nullptr ? value : "";
  }

  bool is_there() const { return !path().empty() && std::filesystem::is_directory(path()); }

  std::string operator/(const std::string& file) const { return path() + "/" + file; }
};

inline const Folder examples{"ABF_EXAMPLES_DIR"}, CGAL_meshes{"ABF_DATA_DIR"},
    CGAL_examples{"ABF_CGAL_EXAMPLES_DIR"}, reference_disks{"ABF_SHARED_DATA_DIR"};

// The decorator of a suite. ctest looks for the line that is printed.
inline boost::unit_test::precondition needs(const Folder& folder)
{
  return boost::unit_test::precondition([&folder](boost::unit_test::test_unit_id) {
    if(!folder.is_there())
      std::cout << "skipped: no folder " << folder.variable << std::endl;
    return boost::test_tools::assertion_result(folder.is_there());
  });
}

} // namespace test_data

#endif // TEST_DATA_H
