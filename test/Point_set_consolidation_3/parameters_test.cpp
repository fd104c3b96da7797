// The package's pack of named parameters: every mix with CGAL's own packs, on every kind of range.
#undef NDEBUG
#include <CGAL/Point_set_consolidation_3/parameters.h>
#include <CGAL/Point_set_consolidation_3/version.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/property_map.h>

#include <cassert>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace psc = CGAL::Point_set_consolidation_3;
namespace params = CGAL::Point_set_consolidation_3::parameters;

// What a public function of the package looks like from the inside.
struct Seen {
  double angle = 0;
  double radius = 0;
  unsigned int seed = 0;
  bool has_normals = false;
  double sum_of_x = 0;
  double spacing = 0;
};

template <typename PointRange, typename NP>
Seen look_impl(const PointRange& points, const NP& np)
{
  using Helper = CGAL::Point_set_processing_3_np_helper<PointRange, NP>;
  const typename Helper::Const_point_map point_map = Helper::get_const_point_map(points, np);

  Seen seen;
  seen.angle = psc::internal::parameter_or(np, psc::internal_np::collision_angle, 45.);
  seen.radius = psc::internal::parameter_or(np, psc::internal_np::neighbor_radius, -1.);
  seen.seed = psc::internal::parameter_or(np, psc::internal_np::random_seed, 0u);
  seen.has_normals = psc::internal::has_parameter<NP, CGAL::internal_np::normal_t>;
  for(const auto& key : points)
    seen.sum_of_x += CGAL::to_double(get(point_map, key).x());
  // The unwrapped pack goes to CGAL's functions as it is.
  seen.spacing
      = CGAL::to_double(CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, 3, np));
  return seen;
}

template <typename PointRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Seen look(const PointRange& points, const NamedParameters& np = CGAL::parameters::default_values())
{
  return look_impl(points, psc::internal::cgal_np(np));
}

void check(const Seen& seen, double angle, double radius, unsigned int seed, bool has_normals)
{
  assert(seen.angle == angle);
  assert(seen.radius == radius);
  assert(seen.seed == seed);
  assert(seen.has_normals == has_normals);
  assert(seen.sum_of_x == 6);
  assert(seen.spacing > 0.99 && seen.spacing < 2.01);
}

template <typename Kernel>
void test_ranges()
{
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Point_with_normal = std::pair<Point, Vector>;
  using Point_map = CGAL::First_of_pair_property_map<Point_with_normal>;
  using Normal_map = CGAL::Second_of_pair_property_map<Point_with_normal>;

  std::vector<Point> points;
  std::vector<Point_with_normal> pairs;
  CGAL::Point_set_3<Point, Vector> set;
  set.add_normal_map();
  for(int i = 0; i < 4; ++i) {
    points.emplace_back(i, 0, 0);
    pairs.emplace_back(points.back(), Vector(0, 0, 1));
    set.insert(points.back(), Vector(0, 0, 1));
  }
  const Point_map point_map{};
  const Normal_map normal_map{};

  // Nothing given.
  check(look(points), 45, -1, 0, false);
  check(look(points, params::default_values()), 45, -1, 0, false);
  check(look(set), 45, -1, 0, false);

  // Only CGAL's parameters, from CGAL and from us.
  check(look(points, CGAL::parameters::neighbor_radius(2.).random_seed(7)), 45, 2, 7, false);
  check(look(points, params::neighbor_radius(2.).random_seed(7)), 45, 2, 7, false);
  check(look(pairs, CGAL::parameters::point_map(point_map).normal_map(normal_map)), 45, -1, 0,
        true);
  check(look(set, set.parameters()), 45, -1, 0, true);

  // Ours first, in the middle, last; the type of the argument need not be the parameter's.
  check(look(points, params::collision_angle(30)), 30, -1, 0, false);
  check(look(pairs, params::collision_angle(30).point_map(point_map).random_seed(7)), 30, -1, 7,
        false);
  check(look(pairs, params::point_map(point_map)
                        .collision_angle(30.f)
                        .normal_map(normal_map)
                        .neighbor_radius(2)),
        30, 2, 0, true);
  check(look(pairs,
             params::point_map(point_map).normal_map(normal_map).prior_map(0).collision_angle(30)),
        30, -1, 0, true);

  // A pack of CGAL continued with ours and then with CGAL's again.
  check(look(set, params::from(set.parameters()).collision_angle(30).random_seed(7)), 30, -1, 7,
        true);
  check(look(pairs, params::from(CGAL::parameters::point_map(point_map))
                        .collision_angle(30)
                        .neighbor_radius(2)),
        30, 2, 0, false);
  check(look(points, params::default_values().collision_angle(30).geom_traits(Kernel())), 30, -1, 0,
        false);
}

// The arguments that are not numbers: functions, references, objects that cannot be copied.
void test_kinds_of_argument()
{
  int calls = 0;
  const std::function<bool(double)> function = [&calls](double) {
    ++calls;
    return true;
  };
  const auto with_function = params::callback(function).verbose(true);
  const auto with_lambda = params::callback([&calls](double) {
    ++calls;
    return true;
  });
  using Callback = std::function<bool(double)>;
  const Callback from_function = psc::internal::parameter_or(
      with_function.cgal_parameters(), psc::internal_np::callback, Callback());
  const Callback from_lambda = psc::internal::parameter_or(with_lambda.cgal_parameters(),
                                                           psc::internal_np::callback, Callback());
  const Callback absent = psc::internal::parameter_or(CGAL::parameters::default_values(),
                                                      psc::internal_np::callback, Callback());
  from_function(0.5);
  from_lambda(0.5);
  assert(calls == 2);
  assert(!absent);

  std::vector<std::string> names;
  const auto with_reference = params::stage_times(std::ref(names));
  CGAL::parameters::get_parameter_reference(with_reference.cgal_parameters(),
                                            psc::internal_np::stage_times)
      .push_back("sinking");
  assert(names.size() == 1);

  const std::unique_ptr<int> not_copyable(new int(3));
  const auto with_unique = params::random_seed(1).visitor(not_copyable);
  const std::unique_ptr<int>& seen = CGAL::parameters::get_parameter_reference(
      with_unique.cgal_parameters(), psc::internal_np::visitor);
  assert(seen.get() == not_copyable.get());
}

// The names that CGAL has too lead to CGAL's tags.
void test_tags()
{
  static_assert(std::is_same_v<psc::internal_np::point_t, CGAL::internal_np::point_t>);
  const auto ours = params::number_of_iterations(3).select_percentage(20.);
  assert(CGAL::parameters::get_parameter(ours.cgal_parameters(),
                                         CGAL::internal_np::number_of_iterations)
         == 3);
  assert(
      CGAL::parameters::get_parameter(ours.cgal_parameters(), CGAL::internal_np::select_percentage)
      == 20.);
  static_assert(std::is_same_v<psc::internal::Cgal_np<decltype(ours)>,
                               std::decay_t<decltype(ours.cgal_parameters())>>);
}

int main()
{
  static_assert(CGAL_POINT_SET_CONSOLIDATION_3_VERSION_NR
                >= CGAL_POINT_SET_CONSOLIDATION_3_VERSION_NUMBER(0, 1, 0));
  test_ranges<CGAL::Simple_cartesian<double>>();
  test_ranges<CGAL::Simple_cartesian<float>>();
  test_ranges<CGAL::Exact_predicates_inexact_constructions_kernel>();
  test_kinds_of_argument();
  test_tags();
  return EXIT_SUCCESS;
}
