#include "tests/solvers/random_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <atomic>

#include "core/parallel.h"
#include "core/read_choice.h"
#include "solvers/modules.h"
#include "tests/catch.h"

namespace ringlet {
namespace {

using Random = std::mt19937;
using Four = std::array<int, 4>;

Eigen::MatrixXd random_term(Random& random, int size, int rank) {
  std::normal_distribution<double> normal;
  const Eigen::MatrixXd factor =
      Eigen::MatrixXd::NullaryExpr(size, rank, [&](Eigen::Index) { return normal(random); });
  return factor * factor.transpose();
}

void add_dense(Eigen::MatrixXd& dense, const Four& vertices, const Eigen::MatrixXd& term) {
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      dense.block<3, 3>(3 * vertices[a], 3 * vertices[b]) += term.block<3, 3>(3 * a, 3 * b);
    }
  }
}

void add_to_bands(StrandBands& bands, const Four& vertices, const Eigen::MatrixXd& term) {
  const StrandGroups& groups = bands.groups();
  const int group = groups.group_of(vertices[0]);
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b <= a; ++b) {
      const auto [row, lane] = groups.slot(vertices[a]);
      Matrix3<Pack>& block = bands.group(group).block(row - groups[group].first_row, a - b);
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          block(r, c)[lane] = block(r, c)[lane] + term(3 * a + r, 3 * b + c);
        }
      }
    }
  }
}

void pin_dense(Eigen::MatrixXd& dense, int vertex) {
  dense.middleRows<3>(3 * vertex).setZero();
  dense.middleCols<3>(3 * vertex).setZero();
  dense.block<3, 3>(3 * vertex, 3 * vertex).setIdentity();
}

}  // namespace

Strands straight_strands(const std::vector<int>& vertex_counts) {
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t strand = 0; strand < vertex_counts.size(); ++strand) {
    for (int i = 0; i < vertex_counts[strand]; ++i) {
      positions.emplace_back(0.1 * static_cast<double>(strand), 0, -0.01 * i);
    }
  }
  return {vertex_counts, positions, Material{}};
}

RandomSystem::RandomSystem(const std::vector<int>& vertex_counts, int contacts, unsigned seed)
    : strands(straight_strands(vertex_counts)),
      groups(strands),
      free(groups.rows(), Pack(0)),
      matrix(groups),
      dense(Eigen::MatrixXd::Zero(3 * strands.vertex_count(), 3 * strands.vertex_count())) {
  INFO("seed " << seed);
  Random random(seed);
  matrix.keep_bands();
  add_masses();
  add_neighbours(random);
  dense_bands = dense;
  for (int contact = 0; contact < contacts; ++contact) add_contact(random);
  for (int tuple = 0; tuple < contacts / 2; ++tuple) add_tuple(random);
  matrix.couplings.finish(free);
  for (int g = 0; g < groups.count(); ++g) matrix.couplings.add_to_bands(g, matrix.bands.group(g));
  pin();
}

void RandomSystem::add_masses() {
  const double mass = 0.5;
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const auto [row, lane] = groups.slot(v);
    const int strand = strands.strand_of(v), group = groups.group_of(v);
    free[row][lane] = strand % 2 == 1 && v == strands.first(strand) ? 0 : 1;
    Matrix3<Pack>& diagonal = matrix.bands.group(group).block(row - groups[group].first_row, 0);
    for (int c = 0; c < 3; ++c) {
      diagonal(c, c)[lane] = mass;
      dense(3 * v + c, 3 * v + c) = mass;
    }
  }
}

void RandomSystem::add_neighbours(Random& random) {
  for (int strand = 0; strand < strands.count(); ++strand) {
    for (int i = strands.first(strand); i + 4 <= strands.first(strand + 1); ++i) {
      const Four vertices{i, i + 1, i + 2, i + 3};
      const Eigen::MatrixXd term = random_term(random, 12, 2);
      add_dense(dense, vertices, term);
      add_to_bands(matrix.bands, vertices, term);
    }
  }
}

void RandomSystem::add_contact(Random& random) {
  std::uniform_int_distribution<int> any_vertex(0, strands.vertex_count() - 1);
  std::normal_distribution<double> normal;
  const auto any_edge = [&] {
    int v = any_vertex(random);
    while (v + 1 == strands.first(strands.strand_of(v) + 1)) v = any_vertex(random);
    return v;
  };
  const int p = any_edge();
  int q = any_edge();
  while (std::abs(p - q) < 2) q = any_edge();
  const Four vertices{p, p + 1, q, q + 1};
  const std::array<double, 4> weights{normal(random), normal(random), normal(random),
                                      normal(random)};
  const Eigen::Matrix3d curvature = 20 * random_term(random, 3, 1);
  matrix.couplings.add(CouplingTerm{vertices, weights, Eigen::Vector3d::Zero(), curvature});

  Eigen::MatrixXd term(12, 12), in_bands = Eigen::MatrixXd::Zero(12, 12);
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) {
      term.block<3, 3>(3 * a, 3 * b) = weights[a] * weights[b] * curvature;
    }
  }
  const bool all_near =
      strands.strand_of(p) == strands.strand_of(q) && std::max(p, q) + 1 - std::min(p, q) <= 3;
  if (all_near) {
    in_bands = term;
  } else {
    in_bands.topLeftCorner<6, 6>() = term.topLeftCorner<6, 6>();
    in_bands.bottomRightCorner<6, 6>() = term.bottomRightCorner<6, 6>();
  }
  add_dense(dense, vertices, term);
  add_dense(dense_bands, vertices, in_bands);
}

void RandomSystem::add_tuple(Random& random) {
  std::uniform_int_distribution<int> any_vertex(0, strands.vertex_count() - 1), any_count(2, 4);
  TupleTerm tuple{any_count(random), {}, {}, {}};
  for (int i = 0; i < tuple.count; ++i) {
    const auto known = [&] {
      return std::count(tuple.vertices.begin(), tuple.vertices.begin() + i, tuple.vertices[i]) > 0;
    };
    // Half of them near each other, so that parts of all sizes occur.
    do {
      tuple.vertices[i] = i > 0 && random() % 2 == 0
                              ? std::min(tuple.vertices[0] + static_cast<int>(random() % 5),
                                         strands.vertex_count() - 1)
                              : any_vertex(random);
    } while (known());
  }
  const Eigen::MatrixXd term = 5 * random_term(random, 3 * tuple.count, 4);
  const auto are_near = [&](int i, int j) {
    return strands.strand_of(tuple.vertices[i]) == strands.strand_of(tuple.vertices[j]) &&
           std::abs(tuple.vertices[i] - tuple.vertices[j]) <= 3;
  };
  std::array<int, 4> part{0, 1, 2, 3};
  for (int i = 0; i < tuple.count; ++i) {
    for (int p = 0; p < i && part[i] == i; ++p) {
      bool near_all = part[p] == p;
      for (int j = p; j < i; ++j) near_all = near_all && (part[j] != p || are_near(i, j));
      if (near_all) part[i] = p;
    }
  }
  for (int i = 0; i < tuple.count; ++i) {
    for (int j = 0; j < tuple.count; ++j) {
      tuple.hessian[i][j] = term.block<3, 3>(3 * i, 3 * j);
      const int row = 3 * tuple.vertices[i], column = 3 * tuple.vertices[j];
      dense.block<3, 3>(row, column) += tuple.hessian[i][j];
      if (part[i] == part[j]) dense_bands.block<3, 3>(row, column) += tuple.hessian[i][j];
    }
  }
  matrix.couplings.add(tuple);
}

void RandomSystem::pin() {
  std::vector<char> has_pins(groups.rows(), false);
  for (int strand = 1; strand < strands.count(); strand += 2) {
    has_pins[groups.slot(strands.first(strand)).row] = true;
  }
  for (int g = 0; g < groups.count(); ++g) {
    const auto rows_of = [&](const auto& all) {
      return std::span(all).subspan(groups[g].first_row, groups[g].vertices);
    };
    pin_rows(matrix.bands.group(g), {0, groups[g].vertices}, {rows_of(free), rows_of(has_pins)});
  }
  for (int strand = 1; strand < strands.count(); strand += 2) {
    pin_dense(dense, strands.first(strand));
    pin_dense(dense_bands, strands.first(strand));
  }
}

VertexField RandomSystem::right_hand_side(unsigned seed) const {
  Random random(seed);
  std::normal_distribution<double> normal;
  VertexField b(groups);
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const auto [row, lane] = groups.slot(v);
    const Eigen::Vector3d value(normal(random), normal(random), normal(random));
    b.set(v, free[row][lane] * value);
  }
  return b;
}

Eigen::Matrix3Xd RandomSystem::dense_solution(const Eigen::MatrixXd& a, const VertexField& b) {
  const Eigen::VectorXd x = a.llt().solve(b.matrix().reshaped());
  return x.reshaped(3, x.size() / 3);
}

double relative_difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).colwise().norm().maxCoeff() / b.colwise().norm().maxCoeff();
}

std::unique_ptr<LinearSolver> make_solver(const Json& json) {
  Registry registry;
  register_solvers(registry);
  return make_chosen<LinearSolver>(registry, json);
}

Prepared::Prepared(LinearSolver& solver, const SystemMatrix& a, VertexField b)
    : solver_(solver), matrix_(a), b_(std::move(b)), solution_(a.groups()) {
  for (auto& row : solution_.rows()) row = {Pack(3), Pack(4), Pack(5)};  // an old solution
  solver.bind(a.groups());
  std::atomic<bool> usable = true;
  parallel_for_each(a.groups().count(), [&](int g) {
    const bool coupled = matrix_.couplings.touches(g);
    const GroupSystem system{g, matrix_.bands.group(g), b_.group(g), coupled};
    constexpr int at_a_time = 3;
    for (int first = 0; first < system.bands.rows(); first += at_a_time) {
      const RowRange rows{first, std::min(first + at_a_time, system.bands.rows())};
      if (!solver.prepare_rows(system, rows, solution_.group(g))) {
        usable = false;
        return;
      }
    }
  });
  accepted_ = usable && solver.prepare(matrix_);
}

}  // namespace ringlet
