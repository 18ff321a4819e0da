// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The user's classes may fail at any call: the solver by an error or a wrong solution, property maps by an exception.
// The sanitizers find leaks.

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/certify_flattening.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_fault_injection)

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_2 Point_2;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface_mesh;
typedef Surface_mesh::Vertex_index Vertex;
typedef SMP::ABF_plus_plus_options Options;
typedef SMP::ABF_plus_plus_report Report;

namespace {

// Counts calls, and decides which one fails.
struct Countdown
{
  int calls = 0, failing_call = 0;

  bool ends() { return ++calls == failing_call; }
  bool has_ended() const { return failing_call > 0 && calls >= failing_call; }
};

enum Fault
{
  RETURN_FALSE,
  ZEROS,
  NOT_A_NUMBER,
  INFINITE,
  RANDOM_NUMBERS,
  HUGE_NUMBERS
};

// Fails at a call of `factor()` or `linear_solver()`, or returns a wrong solution without an error.
class Faulty_traits : public CGAL::SuperLU_solver_traits<>
{
  typedef CGAL::SuperLU_solver_traits<> Base;

public:
  Faulty_traits(Fault fault, Countdown& countdown) : m_fault(fault), m_countdown(&countdown) {}

  bool factor(const Matrix& A, NT& D)
  {
    return m_fault == RETURN_FALSE && m_countdown->ends() ? false : Base::factor(A, D);
  }

  bool linear_solver(const Vector& B, Vector& X)
  {
    if(!m_countdown->ends())
      return Base::linear_solver(B, X);
    std::mt19937 random(static_cast<unsigned>(m_countdown->calls));
    for(int i = 0; i < X.dimension(); ++i)
      X[i] = wrong_number(random);
    return m_fault != RETURN_FALSE;
  }

private:
  double wrong_number(std::mt19937& random) const
  {
    const double any = random() / 2147483648. - 1;
    switch(m_fault) {
    case NOT_A_NUMBER:
      return std::numeric_limits<double>::quiet_NaN();
    case INFINITE:
      return std::numeric_limits<double>::infinity();
    case RANDOM_NUMBERS:
      return any;
    case HUGE_NUMBERS:
      return 1e300 * any;
    default:
      return 0;
    }
  }

  Fault m_fault;
  Countdown* m_countdown;
};

// As a counterpart of lower precision, fails at any of its own calls.
class Faulty_counterpart : public CGAL::SuperLU_solver_traits<float>
{
  typedef CGAL::SuperLU_solver_traits<float> Base;

public:
  explicit Faulty_counterpart(Countdown& countdown) : m_countdown(&countdown) {}

  bool factor(const Matrix& A, NT& D) { return !m_countdown->ends() && Base::factor(A, D); }
  bool linear_solver(const Vector& B, Vector& X) { return !m_countdown->ends() && Base::linear_solver(B, X); }

private:
  Countdown* m_countdown;
};

struct Traits_with_faulty_counterpart : CGAL::SuperLU_solver_traits<>
{
  Countdown* countdown;
  explicit Traits_with_faulty_counterpart(Countdown& c) : countdown(&c) {}
};

// A map of the user's that throws an exception at a call.
template <typename Map>
struct Throwing_map
{
  typedef typename boost::property_traits<Map>::key_type key_type;
  typedef typename boost::property_traits<Map>::value_type value_type;
  typedef value_type reference;
  typedef boost::read_write_property_map_tag category;

  Map map;
  Countdown* countdown;

  friend value_type get(const Throwing_map& m, const key_type& key)
  {
    if(m.countdown->ends())
      throw std::runtime_error("get");
    return get(m.map, key);
  }

  friend void put(const Throwing_map& m, const key_type& key, const value_type& value)
  {
    if(m.countdown->ends())
      throw std::runtime_error("put");
    put(m.map, key, value);
  }
};

struct Run
{
  Run()
      : mesh(test_meshes::bump<Surface_mesh>(6)),
        bhd(CGAL::Polygon_mesh_processing::longest_border(mesh).first)
  {
    uv = mesh.add_property_map<Vertex, Point_2>("v:uv", untouched).first;
    done = mesh.add_property_map<Vertex, bool>("v:done", false).first;
    for(Vertex v : mesh.vertices())
      points.push_back(mesh.point(v));
  }

  template <typename Parameterizer>
  SMP::Error_code parameterize(Parameterizer& parameterizer)
  {
    return parameterizer.parameterize(mesh, bhd, uv, get(boost::vertex_index, mesh), done);
  }

  bool is_untouched() const
  {
    for(Vertex v : mesh.vertices())
      if(uv[v] != untouched || done[v] || mesh.point(v) != points[v])
        return false;
    return true;
  }

  const Point_2 untouched{-17, 42};
  Surface_mesh mesh;
  Surface_mesh::Halfedge_index bhd;
  Surface_mesh::Property_map<Vertex, Point_2> uv;
  Surface_mesh::Property_map<Vertex, bool> done;
  std::vector<Point_3> points;
};

} // namespace

BOOST_AUTO_TEST_SUITE_END()

template <>
struct CGAL::Low_precision_solver_traits<test_fault_injection::Traits_with_faulty_counterpart>
{
  typedef test_fault_injection::Faulty_counterpart type;
  static type create(const test_fault_injection::Traits_with_faulty_counterpart& traits)
  {
    return type(*traits.countdown);
  }
};

BOOST_AUTO_TEST_SUITE(test_fault_injection)

namespace {

Options with_layout(Options::Layout_type layout)
{
  Options options;
  options.layout = layout;
  return options;
}

} // namespace

// An error at any call that the result depends on.
BOOST_AUTO_TEST_CASE(solver_that_fails)
{
  for(Options::Layout_type layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
    int failures = 0;
    bool failed = true;
    for(int call = 1; failed; ++call) {
      Run run;
      Countdown countdown{0, call};
      SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Faulty_traits> parameterizer(
          with_layout(layout), Faulty_traits(RETURN_FALSE, countdown));
      const SMP::Error_code code = run.parameterize(parameterizer);
      failed = countdown.has_ended();
      BOOST_TEST(error_code(parameterizer.report().status) == code);
      if(code == SMP::OK) { // the least squares layout does without its corrections
        BOOST_TEST((!failed || layout == Options::LEAST_SQUARES_LAYOUT));
        BOOST_TEST(SMP::is_locally_injective(run.mesh, run.uv));
      } else {
        ++failures;
        BOOST_TEST(code == SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
        BOOST_TEST(parameterizer.report().status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED);
        BOOST_TEST(!parameterizer.report().message.empty());
        BOOST_TEST(run.is_untouched());
      }
    }
    BOOST_TEST(failures >= 4);
  }
}

// If the counterpart fails, the traits themselves repeat the work, and this is reported.
BOOST_AUTO_TEST_CASE(counterpart_that_fails)
{
  bool failed = true;
  int repeated = 0, repeated_layouts = 0;
  for(int call = 1; failed; ++call) {
    Run run;
    Countdown countdown{0, call};
    const Traits_with_faulty_counterpart traits(countdown);
    SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Traits_with_faulty_counterpart> parameterizer(
        with_layout(Options::AUTOMATIC_LAYOUT), traits);
    BOOST_TEST(run.parameterize(parameterizer) == SMP::OK);
    failed = countdown.has_ended();
    const Report& report = parameterizer.report();
    BOOST_TEST(report.converged);
    int factored = 0, in_this_run = report.layout_repeated;
    for(const SMP::ABF_plus_plus_step& step : report.steps) {
      in_this_run += step.repeated_factorizations;
      factored += step.factorizations;
    }
    BOOST_TEST(in_this_run <= 1);
    BOOST_TEST(failed == (in_this_run > 0 || factored > 2)); // or whole systems were factored
    repeated += in_this_run;
    repeated_layouts += report.layout_repeated;
  }
  BOOST_TEST(repeated > repeated_layouts);
  BOOST_TEST(repeated_layouts > 1);
}

// A wrong solution still leads to a valid map, or to an error.
BOOST_AUTO_TEST_CASE(solver_that_lies)
{
  for(Fault fault : {ZEROS, NOT_A_NUMBER, INFINITE, RANDOM_NUMBERS, HUGE_NUMBERS})
    for(Options::Layout_type layout : {Options::EXACT_LAYOUT, Options::LEAST_SQUARES_LAYOUT}) {
      bool lied = true;
      for(int call = 1; lied; ++call) {
        BOOST_TEST_INFO_SCOPE("fault " << fault << ", layout " << layout << ", call " << call);
        Run run;
        Countdown countdown{0, call};
        SMP::ABF_plus_plus_parameterizer_3<Surface_mesh, Faulty_traits> parameterizer(
            with_layout(layout), Faulty_traits(fault, countdown));
        const SMP::Error_code code = run.parameterize(parameterizer);
        lied = countdown.has_ended();
        BOOST_TEST(error_code(parameterizer.report().status) == code);
        if(code == SMP::OK) {
          BOOST_TEST(SMP::is_locally_injective(run.mesh, run.uv));
        } else {
          BOOST_TEST(lied);
          BOOST_TEST(!parameterizer.report().message.empty());
          BOOST_TEST(run.is_untouched());
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(uv_map_that_throws)
{
  typedef Throwing_map<Surface_mesh::Property_map<Vertex, Point_2>> Map;
  bool thrown = true;
  int exceptions = 0;
  for(int call = 1; thrown; ++call) {
    Run run;
    Countdown countdown{0, call};
    const Map map{run.uv, &countdown};
    SMP::ABF_plus_plus_parameterizer_3<Surface_mesh> parameterizer;
    auto parameterize = [&] {
      return parameterizer.parameterize(run.mesh, run.bhd, map, get(boost::vertex_index, run.mesh), run.done);
    };
    try {
      BOOST_TEST(parameterize() == SMP::OK);
      thrown = false;
    } catch(const std::runtime_error&) {
      ++exceptions;
    }
    BOOST_TEST(thrown == countdown.has_ended());
  }
  BOOST_TEST(exceptions == 49); // as many as there are vertices
}

BOOST_AUTO_TEST_CASE(index_map_that_throws)
{
  typedef Throwing_map<boost::property_map<Surface_mesh, boost::vertex_index_t>::type> Map;
  bool thrown = true;
  for(int call = 1; thrown; ++call) {
    Run run;
    Countdown countdown{0, call};
    SMP::ABF_plus_plus_parameterizer_3<Surface_mesh> parameterizer;
    const Map map{get(boost::vertex_index, run.mesh), &countdown};
    thrown = false;
    try {
      BOOST_TEST(parameterizer.parameterize(run.mesh, run.bhd, run.uv, map, run.done) == SMP::OK);
    } catch(const std::runtime_error&) {
      thrown = true;
      BOOST_TEST(run.is_untouched());
    }
    BOOST_TEST(thrown == countdown.has_ended());
  }
}

namespace {

// Ends the run at its n-th call, by an exception or by returning `false`.
struct Stopping_visitor : SMP::Flattening_visitor
{
  int countdown;
  bool throws;

  Stopping_visitor(int calls, bool by_exception) : countdown(calls), throws(by_exception) {}

  bool start(Stage) override { return go_on(); }
  bool step(const SMP::ABF_plus_plus_step&) override { return go_on(); }
  bool level(int, int) override { return go_on(); }

  bool go_on()
  {
    if(--countdown != 0)
      return true;
    if(throws)
      throw std::runtime_error("visitor");
    return false;
  }
};

template <typename Parameterizer, typename Visited_options>
void check_stopping_visitor(int least_calls, Visited_options options)
{
  for(bool throws : {true, false}) {
    int calls = 1;
    for(;; ++calls) {
      Run run;
      Stopping_visitor visitor(calls, throws);
      options.visitor = &visitor;
      Parameterizer parameterizer(options);
      try {
        const SMP::Error_code code = run.parameterize(parameterizer);
        if(visitor.countdown > 0) {
          BOOST_TEST(code == SMP::OK);
          break;
        }
        BOOST_TEST(!throws);
        BOOST_TEST(code == SMP::ERROR_NO_1_TO_1_MAPPING);
        BOOST_TEST(parameterizer.report().status == SMP::Diagnosis::CANCELLED);
      } catch(const std::runtime_error&) {
        BOOST_TEST(throws);
      }
      BOOST_TEST(run.is_untouched());
    }
    BOOST_TEST(calls > least_calls);
  }
}

} // namespace

// Six stages, and at least two steps
BOOST_AUTO_TEST_CASE(visitor_that_stops_the_direct_method)
{
  check_stopping_visitor<SMP::ABF_plus_plus_parameterizer_3<Surface_mesh>>(8, Options());
}

BOOST_AUTO_TEST_CASE(visitor_that_stops_the_hierarchical_method)
{
  for(bool injective : {false, true})
    for(bool polish : {false, true}) {
      SMP::Hierarchical_options options;
      options.injective = injective;
      options.polish = polish;
      check_stopping_visitor<SMP::Hierarchical_ABF_plus_plus_parameterizer_3<Surface_mesh>>(6, options);
    }
}

BOOST_AUTO_TEST_SUITE_END()
