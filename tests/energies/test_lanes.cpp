#include "tests/catch.h"
#include "tests/energies/probe.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

const std::vector<int> counts{5, 2, 9, 3, 4, 7, 2, 2, 6, 11};
constexpr int vertices = 51;

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).norm() / b.norm();
}

}  // namespace

TEST_CASE("strands in lanes are computed as one after the other") {
  std::mt19937 random(1);
  const Points rest = random_points(random, vertices), x = random_points(random, vertices);
  for (const std::string& name : elastic_names) {
    for (const char* filter : {"tight", "exact"}) {
      const Json in_lanes{{"type", name}, {"filter", filter}};
      const Json one_by_one{{"type", name}, {"filter", filter}, {"evaluation", "scalar"}};
      const Probe lanes = Bound(make_energy(in_lanes), counts, rest).at(x);
      const Probe scalar = Bound(make_energy(one_by_one), counts, rest).at(x);
      INFO(name << ", " << filter);
      CHECK(lanes.value == Approx(scalar.value).epsilon(1e-13));
      CHECK(difference(lanes.gradient, scalar.gradient) < 1e-12);
      CHECK(difference(lanes.hessian, scalar.hessian) < 1e-12);
    }
  }
}

TEST_CASE("strands of all lengths are the sums of their elements") {
  std::mt19937 random(2);
  const Points rest = random_points(random, vertices), x = random_points(random, vertices);
  for (const std::string& name : elastic_names) {
    const int size = vertices_of(name);
    const Probe all = Bound(make_energy({{"type", name}, {"filter", "exact"}}), counts, rest).at(x);
    Probe sum{0, Eigen::VectorXd::Zero(x.size()), Eigen::MatrixXd::Zero(x.size(), x.size())};
    for (int first = 0; const int count : counts) {
      for (int i = first; i + size <= first + count; ++i) {
        const Probe element = Bound(name, rest.middleCols(i, size)).at(x.middleCols(i, size));
        sum.value += element.value;
        sum.gradient.segment(3 * i, 3 * size) += element.gradient;
        sum.hessian.block(3 * i, 3 * i, 3 * size, 3 * size) += element.hessian;
      }
      first += count;
    }
    INFO(name);
    CHECK(all.value == Approx(sum.value).epsilon(1e-12));
    CHECK(difference(all.gradient, sum.gradient) < 1e-12);
    CHECK(difference(all.hessian, sum.hessian) < 1e-12);
  }
}

TEST_CASE("energies leave pads alone") {
  std::mt19937 random(3);
  const Points rest = random_points(random, vertices), x = random_points(random, vertices);
  for (const std::string& name : elastic_names) {
    const Strands strands(counts, columns(rest), plain_material());
    const StrandGroups groups(strands);
    const auto energy = make_energy(name);
    energy->bind(strands, groups);
    const VertexField field = positions_with_pads(groups, columns(x));
    VertexField gradient(groups);
    StrandBands bands(groups);
    for (int g = 0; g < groups.count(); ++g) {
      energy->add(g, field.group(g), {gradient.group(g), bands.group(g)});
    }
    for (int row = 0; row < groups.rows(); ++row) {
      for (int lane = 0; lane < lane_count; ++lane) {
        if (groups.vertex_at(row, lane) >= 0) continue;
        const Vector3<Pack>& slope = gradient.rows()[row];
        REQUIRE((slope.x[lane] == 0 && slope.y[lane] == 0 && slope.z[lane] == 0));
        for (int k = 0; k < band_blocks; ++k) {
          for (const Pack& entry : bands.block(row, k).m) REQUIRE(entry[lane] == 0);
        }
      }
    }
  }
}

TEST_CASE("gradient and Hessian can be asked for one without the other") {
  std::mt19937 random(4);
  const Points rest = random_points(random, vertices), x = random_points(random, vertices);
  for (const std::string& name : elastic_names) {
    const Strands strands(counts, columns(rest), plain_material());
    const StrandGroups groups(strands);
    const auto energy = make_energy(name);
    energy->bind(strands, groups);
    const VertexField field = positions_with_pads(groups, columns(x));
    VertexField both(groups), alone(groups);
    StrandBands bands(groups), bands_alone(groups);
    for (int g = 0; g < groups.count(); ++g) {
      energy->add(g, field.group(g), {both.group(g), bands.group(g)});
      energy->add(g, field.group(g), {alone.group(g), {}});
      energy->add(g, field.group(g), {{}, bands_alone.group(g)});
    }
    CHECK(both.matrix() == alone.matrix());
    CHECK(all_of(bands.block(0, 0).m[0] == bands_alone.block(0, 0).m[0]));
    CHECK(all_of(bands.block(3, 1).m[5] == bands_alone.block(3, 1).m[5]));
  }
}
