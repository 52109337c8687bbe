#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/batch_energy.h"
#include "core/coupling_energy.h"

namespace ringlet {

/// What a kernel sees of one tuple of vertices in the rest state.
template <int K>
struct TupleRest {
  std::array<int, K> vertices;
  Stencil<double, K> positions;  ///< m
  const Strands& strands;
};

/// An energy of tuples of vertices of any strands: `tuples` picks them from the rest shape, all
/// vertices of one different, and `rest` computes the rest data of one.
template <class Kernel>
concept TupleKernel = ValueKernel<Kernel> &&
    requires(const Kernel& kernel, const TupleRest<Kernel::vertices>& tuple,
             const Strands& strands) {
  { kernel.tuples(strands) } -> std::same_as<std::vector<std::array<int, Kernel::vertices>>>;
  { kernel.rest(tuple) } -> std::same_as<typename Kernel::template Rest<double>>;
};

/// Makes a CouplingEnergy of a kernel: evaluates its tuples in lanes, side by side. The author
/// writes the kernel only; derivatives and filters are those of BatchEnergy.
template <TupleKernel Kernel>
class BatchCoupling final : public CouplingEnergy {
 public:
  static constexpr int K = Kernel::vertices;

  BatchCoupling(Kernel kernel, Filter filter) : element_(std::move(kernel), filter) {}

  void bind(const Strands& strands, const StrandGroups&) override {
    tuples_ = element_.kernel().tuples(strands);
    // The lanes behind the last tuple repeat it, without stiffness.
    batches_.resize((tuples_.size() + lane_count - 1) / lane_count);
    for (std::size_t n = 0; n < batches_.size() * lane_count; ++n) {
      TupleRest<K> tuple{tuples_[std::min(n, tuples_.size() - 1)], {}, strands};
      for (int i = 0; i < K; ++i) {
        tuple.positions[i] = from_eigen(strands.rest_position(tuple.vertices[i]));
      }
      Rest<double> rest = element_.kernel().rest(tuple);
      if (n >= tuples_.size()) rest.stiffness = 0;
      RestLanes<Kernel>::set(batches_[n / lane_count], static_cast<int>(n % lane_count), rest);
    }
  }

  bool vanishes() const override { return tuples_.empty(); }
  std::size_t bytes() const override { return bytes_of(tuples_) + bytes_of(batches_); }

  void begin_step(const StepStart& start) override {
    if constexpr (UpdatedKernel<Kernel>) {
      const StepTime time{start.end(), start.dt};
      parallel_for_each(batch_count(), [&](int b) {
        batches_[b] = element_.kernel().update(gather(b, start.state.positions), batches_[b], time);
      });
    }
  }

  std::span<std::byte> changing_data() override {
    if constexpr (UpdatedKernel<Kernel>) return std::as_writable_bytes(std::span(batches_));
    return {};
  }

  double add(const VertexField& x, Couplings* couplings) const override {
    std::vector<TupleTerm> terms(couplings != nullptr ? tuples_.size() : 0);
    std::vector<Pack> values(batches_.size());
    parallel_for_each(batch_count(), [&](int b) {
      const Stencil<Pack, K> positions = gather(b, x);
      if (couplings == nullptr) {
        values[b] = element_.kernel().value(positions, batches_[b]);
        return;
      }
      Derivatives<Pack, K> derivatives;
      values[b] = element_.evaluate(positions, batches_[b], derivatives);
      for (int lane = 0; lane < lanes_of(b); ++lane) {
        terms[b * lane_count + lane] = term(tuple(b, lane), lane_of(derivatives, lane));
      }
    });
    for (const TupleTerm& term : terms) couplings->add(term);
    double sum = 0;
    for (const Pack& value : values) sum += sum_lanes(value);
    return sum;
  }

 private:
  template <class S>
  using Rest = typename Kernel::template Rest<S>;

  int batch_count() const { return static_cast<int>(batches_.size()); }
  int lanes_of(int batch) const {
    return std::min(lane_count, static_cast<int>(tuples_.size()) - batch * lane_count);
  }
  const std::array<int, K>& tuple(int batch, int lane) const {
    return tuples_[batch * lane_count + std::min(lane, lanes_of(batch) - 1)];
  }
  Stencil<Pack, K> gather(int batch, const VertexField& x) const {
    Stencil<Pack, K> positions;
    for (int lane = 0; lane < lane_count; ++lane) {
      for (int i = 0; i < K; ++i) {
        const Eigen::Vector3d position = x.get(tuple(batch, lane)[i]);
        positions[i].x[lane] = position.x();
        positions[i].y[lane] = position.y();
        positions[i].z[lane] = position.z();
      }
    }
    return positions;
  }
  /// From derivatives with respect to the differences x_{i+1} - x_i to those with respect to the
  /// vertices.
  static TupleTerm term(const std::array<int, K>& vertices,
                        const Derivatives<double, K>& derivatives) {
    const auto differences = edge_differences<K>();
    const Eigen::Vector<double, 3 * K> g = differences.transpose() * dense_gradient(derivatives);
    const Eigen::Matrix<double, 3 * K, 3 * K> h =
        differences.transpose() * dense_hessian(derivatives) * differences;
    TupleTerm term{K, {}, {}, {}};
    for (int i = 0; i < K; ++i) {
      term.vertices[i] = vertices[i];
      term.gradient[i] = g.template segment<3>(3 * i);
      for (int j = 0; j < K; ++j) term.hessian[i][j] = h.template block<3, 3>(3 * i, 3 * j);
    }
    return term;
  }

  KernelDerivatives<Kernel> element_;
  std::vector<std::array<int, K>> tuples_;
  StreamedVector<Rest<Pack>> batches_;
};

/// The parameters of a kernel and its filter, one flat object in a scene.
template <class Kernel>
struct CouplingParameters {
  typename Kernel::Parameters kernel;
  FilterChoice<Kernel> filter;

  static Schema<CouplingParameters> schema() {
    return Schema<CouplingParameters>()
        .include(&CouplingParameters::kernel)
        .include(&CouplingParameters::filter);
  }
};

/// Registers the coupling that a kernel defines.
template <TupleKernel Kernel>
void register_coupling(Registry& registry, const std::string& name, Description description) {
  using Parameters = CouplingParameters<Kernel>;
  registry.of<CouplingEnergy>().add<Parameters>(
      name, std::move(description), [](const Parameters& parameters) {
        return std::make_unique<BatchCoupling<Kernel>>(Kernel{parameters.kernel},
                                                       parameters.filter.filter);
      });
}

}  // namespace ringlet
