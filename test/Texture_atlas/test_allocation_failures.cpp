// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Memory that runs out at any place. The program's own `operator new`, and its own `malloc()` for what the program
// itself calls, fail when told to. Blocks of the former, and of SuperLU, are counted, so that no leak is unseen.

#include <boost/test/unit_test.hpp>

#include "scenes.h"
#include "seam_surfaces.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/flatten_surface.h>
#include <CGAL/Texture_atlas/flatten_with_cones.h>
#include <CGAL/Texture_atlas/make_atlas.h>
#include <CGAL/Texture_atlas/select_seams.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <random>
#include <utility>
#include <vector>

namespace {

std::atomic<bool> is_counting{false}, is_lasting{false};
std::atomic<long> allocations{0}, failing_allocation{0};
std::atomic<long> living_blocks{0};

// Counts an allocation, and returns whether it is to fail.
bool is_to_fail()
{
  if(!is_counting)
    return false;
  const long number = ++allocations, failing = failing_allocation;
  return number == failing || (number > failing && failing > 0 && is_lasting);
}

void* counted(void* block)
{
  living_blocks += block != nullptr;
  return block;
}

} // namespace

#ifdef ABF_HAS_LIBC_MALLOC
extern "C" {
void* __libc_malloc(std::size_t) noexcept;
void* __libc_calloc(std::size_t, std::size_t) noexcept;
void* __libc_realloc(void*, std::size_t) noexcept;
extern const char __executable_start, etext;

// Libraries such as GMP and SuperLU end the program where memory runs out: only calls of the program's own code fail.
#define IS_OWN_CALL() is_own(__builtin_return_address(0))
static bool is_own(const void* address)
{
  return address >= &__executable_start && address < &etext;
}

void* malloc(std::size_t size) noexcept
{
  return IS_OWN_CALL() && is_to_fail() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) noexcept
{
  return IS_OWN_CALL() && is_to_fail() ? nullptr : __libc_calloc(number, size);
}

void* realloc(void* old, std::size_t size) noexcept
{
  return IS_OWN_CALL() && is_to_fail() ? nullptr : __libc_realloc(old, size);
}

// SuperLU's allocator, which the program's own code also calls
void* superlu_malloc(std::size_t size)
{
  return IS_OWN_CALL() && is_to_fail() ? nullptr : counted(__libc_malloc(size));
}

void superlu_free(void* block)
{
  living_blocks -= block != nullptr;
  std::free(block);
}
}

#define UNFAILING_MALLOC __libc_malloc
#else
#define UNFAILING_MALLOC std::malloc
#endif

void* operator new(std::size_t size)
{
  void* const block = is_to_fail() ? nullptr : counted(UNFAILING_MALLOC(size > 0 ? size : 1));
  if(block == nullptr)
    throw std::bad_alloc();
  return block;
}

void operator delete(void* block) noexcept
{
  living_blocks -= block != nullptr;
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}

BOOST_AUTO_TEST_SUITE(test_allocation_failures)

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using scenes::Mesh;
using scenes::Scene;

typedef std::function<SMP::Diagnosis(Scene&)> Call;

enum End
{
  DONE,
  FAILED, // with a diagnosis
  OUT_OF_MEMORY
};

// Calls the function while one allocation fails, and those after it if that is to last.
End end_of_call(const Call& call, Scene& scene, long failing, bool lasts)
{
  allocations = 0;
  failing_allocation = failing;
  is_lasting = lasts;
  is_counting = true;
  End end;
  try {
    end = call(scene) == SMP::Diagnosis::NOTHING_WRONG ? DONE : FAILED;
  } catch(const std::bad_alloc&) {
    end = OUT_OF_MEMORY;
  }
  is_counting = false;
  return end;
}

// All allocations if there are at most `most`, and otherwise the last ones and about so many others, chosen at random
std::vector<long> numbers_of_allocations(long all, long most)
{
  std::vector<long> result;
  std::mt19937 random(static_cast<unsigned>(all));
  for(long number = 1; number <= all; ++number)
    if(static_cast<long>(random() % static_cast<unsigned long>(all)) < most || number > all - 10)
      result.push_back(number);
  return result;
}

// Returns how often memory ran out, and the number of blocks that were lost. Where a function can do without what it
// asked for, as a sort does without a buffer, the result is the same.
std::pair<std::size_t, long> fail(const std::vector<long>& numbers, bool lasts, const Call& call,
                                  Scene& scene, const Scene::Output& expected)
{
  std::size_t lacks = 0;
  long lost = 0;
  for(long number : numbers) {
    BOOST_TEST_INFO_SCOPE("allocation " << number << (lasts ? " and all after it" : ""));
    const long living = living_blocks;
    const End end = end_of_call(call, scene, number, lasts);
    lost += living_blocks - living;
    BOOST_TEST(end != FAILED);
    lacks += end == OUT_OF_MEMORY;
    if(end == DONE) {
      BOOST_TEST((scene.output() == expected));
      scene.clear();
    }
    BOOST_TEST((scene.state() == scene.before));
  }
  return {lacks, lost};
}

// A first call fills caches. With several threads, the number of allocations is not always the same. The last ones are
// where functions write.
void check(Scene& scene, const Call& call, long most = 4000, long lost_by_CGAL = 0)
{
  BOOST_TEST_REQUIRE(end_of_call(call, scene, 0, false) == DONE);
  scene.clear();
  BOOST_TEST_REQUIRE(end_of_call(call, scene, 0, false) == DONE);
  const Scene::Output expected = scene.output();
  scene.clear();
  const std::vector<long> numbers = numbers_of_allocations(allocations, most);
  BOOST_TEST_REQUIRE(numbers.size() > 10);
  for(bool lasts : {false, true}) {
    const auto [lacks, lost] = fail(numbers, lasts, call, scene, expected);
    BOOST_TEST(2 * lacks > numbers.size());
    BOOST_TEST(lost <= lost_by_CGAL);
    BOOST_TEST_MESSAGE(lacks << " of " << numbers.size() << " calls lacked memory, " << lost
                             << " blocks lost");
  }
  BOOST_TEST((end_of_call(call, scene, 0, false) == DONE));
  BOOST_TEST((scene.output() == expected));
}

template <typename Parameterizer, typename Options>
Call flattening(const Options& options)
{
  return [options](Scene& scene) {
    return SMP::flatten_surface(scene.mesh, scene.uv, Parameterizer(options)).status;
  };
}

Call direct(const SMP::ABF_plus_plus_options& options = SMP::ABF_plus_plus_options())
{
  return flattening<SMP::ABF_plus_plus_parameterizer_3<Mesh>>(options);
}

Call hierarchical(const SMP::Hierarchical_options& options)
{
  return flattening<SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Mesh>>(options);
}

Call atlas(const TA::Atlas_options& options)
{
  return [options](Scene& scene) {
    return TA::make_atlas(scene.mesh, scene.seams, scene.corner_uv, scene.charts, options).status;
  };
}

} // namespace

BOOST_AUTO_TEST_CASE(direct_method)
{
  Scene tiny(test_meshes::bump<Mesh>(2));
  check(tiny, direct());
  SMP::ABF_plus_plus_options options;
  options.linear_solver = SMP::ABF_plus_plus_options::DIRECT;
  options.layout = SMP::ABF_plus_plus_options::LEAST_SQUARES_LAYOUT;
  check(tiny, direct(options));
  Scene scene(test_meshes::bump<Mesh>(10));
  check(scene, direct(), 200);
}

// `Surface_mesh` loses arrays of properties if memory runs out while it adds them: 12 here, in all.
BOOST_AUTO_TEST_CASE(hierarchical_method)
{
  Scene scene(test_meshes::bump<Mesh>(14));
  SMP::Hierarchical_options options;
  options.angle_sweeps = 1;
  options.polish = true;
  check(scene, hierarchical(options), 300, 12);
}

BOOST_AUTO_TEST_CASE(injective_maps)
{
  Scene scene(test_meshes::bump<Mesh>(8));
  SMP::Hierarchical_options options;
  options.injective = true;
  options.polish = true;
  check(scene, hierarchical(options), 200);
}

BOOST_AUTO_TEST_CASE(seams)
{
  Scene scene(scenes::sphere_and_torus());
  check(
      scene, [](Scene& s) { return TA::select_seams(s.mesh, s.seams).status; }, 600);
}

BOOST_AUTO_TEST_CASE(cones)
{
  Scene scene(seam_surfaces::sphere(1).mesh<Mesh>());
  check(
      scene, [](Scene& s) { return TA::flatten_with_cones(s.mesh, 4, s.seams, s.corner_uv).status; }, 2000);
}

BOOST_AUTO_TEST_CASE(atlases)
{
  Scene scene(scenes::sphere_and_torus());
  TA::Atlas_options options(TA::Atlas_options::FEW_CHARTS);
  options.resolution = 64;
  for(int threads : {1, 2}) {
    options.threads = threads;
    check(scene, atlas(options), 100);
  }
  TA::Atlas_options texture(TA::Atlas_options::TEXTURE);
  texture.threads = 1; // or else the number of its many allocations varies
  texture.resolution = 64;
  check(scene, atlas(texture), 10);
}

// What fails for the second mesh changes nothing of the first.
BOOST_AUTO_TEST_CASE(common_atlases)
{
  Scene scene(seam_surfaces::sphere(1).mesh<Mesh>()), second(seam_surfaces::sphere(1).mesh<Mesh>());
  const std::vector<Mesh> meshes = {scene.mesh, second.mesh};
  const std::vector seams = {scene.seams, second.seams};
  const std::vector uv = {scene.corner_uv, second.corner_uv};
  const std::vector charts = {scene.charts, second.charts};
  TA::Atlas_options options(TA::Atlas_options::FEW_CHARTS);
  options.threads = 1;
  options.resolution = 64;
  const Call call = [&](Scene&) {
    second.clear();
    return TA::make_common_atlas(meshes, seams, uv, charts, options).status;
  };
  check(scene, call, 40);
}

BOOST_AUTO_TEST_SUITE_END()
