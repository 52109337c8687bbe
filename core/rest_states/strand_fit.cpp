#include "core/rest_states/strand_fit.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace ringlet {

StrandFit::StrandFit(Model& model, int strand, const VertexField& x)
    : strand_(strand), root_(model.strands.first(strand)) {
  const int size = model.strands.size(strand);
  for (int i = 0; i < size; ++i) {
    const auto [row, lane] = model.groups.slot(root_ + i);
    const bool is_pinned = model.free[row][lane] == 0;
    free_index_.push_back(is_pinned ? -1 : free_count_++);
    if (!is_pinned) masses_.push_back(model.strands.mass(root_ + i));
  }
  for (const auto& energy : model.energies) {
    HoldingElements* holding = energy->holding_elements();
    if (holding == nullptr) continue;
    const int vertices = holding->vertices();
    for (int first = 0; first + vertices <= size; ++first) {
      Element element{holding, first, Eigen::Matrix3Xd(3, vertices)};
      for (int n = 0; n < vertices; ++n) element.x.col(n) = x.get(root_ + first + n);
      elements_.push_back(std::move(element));
    }
  }
  // By their last vertices, on which the forces of an edge, a hinge and a dihedral point in three
  // directions: the columns are then nearly triangular, each far from dependent on those before it.
  std::stable_sort(elements_.begin(), elements_.end(), [](const Element& a, const Element& b) {
    return a.first + a.x.cols() < b.first + b.x.cols();
  });
  pulls_ = pulls();
  slopes_.assign(pulls_.size(), 0);
  if (!pulls_.empty()) factorise();
}

template <class See>
void StrandFit::for_free_rows(const Element& element, const See& see) const {
  for (int i = 0; i < element.x.size(); ++i) {
    const int index = free_index_[element.first + i / 3];
    if (index >= 0) see(3 * index + i % 3, i);
  }
}

Eigen::VectorXd StrandFit::weighted_pull(const Element& element) const {
  constexpr double trial = 0.1;  // far from rounding, and from where a rest state would wrap
  const int vertex = root_ + element.first;
  if (element.energy->hold(vertex, element.x, trial) == Hold::impossible) return {};
  Eigen::VectorXd pull = element.energy->derivatives(vertex, element.x).gradient / trial;
  element.energy->hold(vertex, element.x, 0);
  Eigen::VectorXd weighted = Eigen::VectorXd::Zero(pull.size());
  for_free_rows(element, [&](int row, int i) { weighted[i] = pull[i] / std::sqrt(mass(row)); });
  return weighted;
}

std::vector<StrandFit::Pull> StrandFit::pulls() const {
  std::vector<Pull> pulls;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const Eigen::VectorXd pull = weighted_pull(elements_[i]);
    const double length = pull.norm();
    if (length > 0) pulls.push_back({i, pull / length, length});
  }
  return pulls;
}

void StrandFit::factorise() {
  std::vector<Eigen::Triplet<double>> entries;
  for (int n = 0; const Pull& pull : pulls_) {
    for_free_rows(elements_[pull.element],
                  [&](int row, int i) { entries.emplace_back(row, n, pull.direction[i]); });
    ++n;
  }
  Eigen::SparseMatrix<double> matrix(3 * free_count_, static_cast<int>(pulls_.size()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_ = std::make_unique<decltype(factors_)::element_type>(matrix);
}

Eigen::VectorXd StrandFit::weighted(const VertexField& gradient) const {
  Eigen::VectorXd result(3 * free_count_);
  for (std::size_t i = 0; i < free_index_.size(); ++i) {
    const int index = free_index_[i];
    if (index < 0) continue;
    const int vertex = root_ + static_cast<int>(i);
    result.segment<3>(3 * index) = gradient.get(vertex) / std::sqrt(masses_[index]);
  }
  return result;
}

int StrandFit::hold(const VertexField& gradient) {
  if (!factors_) return 0;
  const Eigen::VectorXd solution = factors_->solve(-weighted(gradient));
  int without_rest = 0;
  for (std::size_t n = 0; n < pulls_.size(); ++n) {
    const Element& element = elements_[pulls_[n].element];
    slopes_[n] += solution[static_cast<Eigen::Index>(n)] / pulls_[n].length;
    const Hold held = element.energy->hold(root_ + element.first, element.x, slopes_[n]);
    without_rest += held == Hold::without_rest ? 1 : 0;
  }
  return without_rest;
}

bool StrandFit::is_stable() const {
  std::vector<Eigen::Triplet<double>> entries;
  // Stable where H + rate^2 M has no negative eigenvalue.
  constexpr double rate = 1;  // 1/s
  for (int row = 0; row < 3 * free_count_; ++row) {
    entries.emplace_back(row, row, rate * rate * mass(row));
  }
  for (const Element& element : elements_) {
    const Eigen::MatrixXd hessian =
        element.energy->derivatives(root_ + element.first, element.x).hessian;
    for_free_rows(element, [&](int row, int i) {
      for_free_rows(element,
                    [&](int column, int j) { entries.emplace_back(row, column, hessian(i, j)); });
    });
  }
  Eigen::SparseMatrix<double> hessian(3 * free_count_, 3 * free_count_);
  hessian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(hessian);
  return factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0;
}

}  // namespace ringlet
