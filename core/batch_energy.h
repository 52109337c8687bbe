#pragma once

#include <algorithm>
#include <bit>
#include <memory>
#include <string>
#include <vector>

#include "core/counted.h"
#include "core/elements_along.h"
#include "core/energy.h"
#include "core/kernel_derivatives.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {

/// How the elements of a batch are computed: strands side by side in lanes, or one after the other
/// with plain doubles (slow; the oracle of the lanes).
enum class Evaluation { lanes, scalar };

template <>
struct EnumNames<Evaluation> {
  static constexpr std::pair<Evaluation, const char*> names[] = {{Evaluation::lanes, "lanes"},
                                                                 {Evaluation::scalar, "scalar"}};
};

/// Makes an Energy of a kernel: loops over the elements of a group, fills the lanes, and assembles
/// gradient and bands. The author of an energy writes the kernel only.
template <ElementKernel Kernel>
class BatchEnergy final : public Energy, public ElementFunction, public HoldingElements {
 public:
  static constexpr int K = Kernel::vertices;

  BatchEnergy(Kernel kernel, Filter filter, Evaluation evaluation)
      : element_(std::move(kernel), filter), evaluation_(evaluation) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    rest_.assign(groups.rows(), Rest<Pack>{});
    std::vector<Eigen::Vector3d> positions(strands.vertex_count());
    for (int v = 0; v < strands.vertex_count(); ++v) positions[v] = strands.rest_position(v);
    const VertexField field = positions_with_pads(groups, positions);
    for (int g = 0; g < groups.count(); ++g) {
      for (int i = 0; i + K <= groups[g].vertices; ++i) {
        for (int lane = 0; lane < lane_count; ++lane) bind_element(strands, field, g, i, lane);
      }
    }
  }

  bool vanishes() const override {
    if constexpr (UpdatedKernel<Kernel>) return false;
    for (int g = 0; g < groups_->count(); ++g) {
      for (int i = 0; i + K <= (*groups_)[g].vertices; ++i) {
        const Pack& stiffness = rest_[(*groups_)[g].first_row + i].stiffness;
        if (std::experimental::any_of(stiffness != 0)) return false;
      }
    }
    return true;
  }
  std::size_t bytes() const override { return bytes_of(rest_); }

  void begin_step(const StepStart& start) override {
    if constexpr (UpdatedKernel<Kernel>) {
      const StepTime time{start.end(), start.dt};
      parallel_for_each(groups_->count(), [&](int g) {
        Rest<Pack>* rest = &rest_[(*groups_)[g].first_row];
        const auto x = start.state.positions.group(g);
        for (int i = 0; i + K <= static_cast<int>(x.size()); ++i) {
          update(window(x, i), rest[i], time);
        }
      });
    }
  }

  std::span<std::byte> changing_data() override {
    if constexpr (UpdatedKernel<Kernel>) return std::as_writable_bytes(std::span(rest_));
    return {};
  }

  double add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const override {
    return evaluation_ == Evaluation::lanes ? add_in_lanes(group, x, outputs)
                                            : add_one_by_one(group, x, outputs);
  }

  const ElementFunction* element_function() const override {
    return MeasureKernel<Kernel> ? this : nullptr;
  }
  int vertices() const override { return K; }
  ElementDerivatives evaluate(const Eigen::Matrix3Xd& positions, double stiffness,
                              double rest) const override {
    if constexpr (MeasureKernel<Kernel>) {
      return dense(element_, positions, kernel().rest_of(stiffness, rest));
    }
    return {0, Eigen::VectorXd(3 * K), Eigen::MatrixXd(3 * K, 3 * K)};
  }
  ElementCost cost(const Eigen::Matrix3Xd& positions, double stiffness,
                   double rest) const override {
    ElementCost cost{0, sizeof(Rest<double>)};
    if constexpr (MeasureKernel<Kernel>) {
      const auto count = [&cost](double value) { return Counted(value, cost.operations); };
      Stencil<Counted, K> x;
      for (int n = 0; n < K; ++n) {
        x[n] = {count(positions(0, n)), count(positions(1, n)), count(positions(2, n))};
      }
      using Numbers = std::array<double, Lanes::size>;
      const auto numbers = std::bit_cast<Numbers>(kernel().rest_of(stiffness, rest));
      std::array<Counted, Lanes::size> counted;
      std::transform(numbers.begin(), numbers.end(), counted.begin(), count);
      Derivatives<Counted, K> derivatives;
      element_.with_kernel_filter([&]<Filter filter>() {
        return element_.template evaluate_kernel<filter>(x, std::bit_cast<Rest<Counted>>(counted),
                                                         derivatives.outputs());
      });
    }
    return cost;
  }

  HoldingElements* holding_elements() override { return HoldingKernel<Kernel> ? this : nullptr; }
  Hold hold(int first_vertex, const Eigen::Matrix3Xd& x, double slope) override {
    if constexpr (HoldingKernel<Kernel>) {
      const auto [row, lane] = groups_->slot(first_vertex);
      Rest<double> rest = Lanes::get(rest_[row], lane);
      const Hold held = kernel().hold(stencil_of(x), slope, rest);
      Lanes::set(rest_[row], lane, rest);
      return held;
    }
    return Hold::impossible;
  }
  ElementDerivatives derivatives(int first_vertex, const Eigen::Matrix3Xd& x) const override {
    const auto [row, lane] = groups_->slot(first_vertex);
    return dense({kernel(), Filter::exact}, x, Lanes::get(rest_[row], lane));
  }

 private:
  template <class S>
  using Rest = typename Kernel::template Rest<S>;
  using Lanes = RestLanes<Kernel>;

  static Stencil<double, K> stencil_of(const Eigen::Matrix3Xd& positions) {
    Stencil<double, K> x;
    for (int n = 0; n < K; ++n) x[n] = from_eigen(positions.col(n));
    return x;
  }
  static ElementDerivatives dense(const KernelDerivatives<Kernel>& element,
                                  const Eigen::Matrix3Xd& positions, const Rest<double>& rest) {
    Derivatives<double, K> derivatives;
    const double value = element.evaluate(stencil_of(positions), rest, derivatives);
    const auto differences = edge_differences<K>();
    return {value, differences.transpose() * dense_gradient(derivatives),
            differences.transpose() * dense_hessian(derivatives) * differences};
  }

  const Kernel& kernel() const { return element_.kernel(); }

  void bind_element(const Strands& strands, const VertexField& field, int g, int i, int lane) {
    const StrandGroup& group = (*groups_)[g];
    const int strand = group.strands[lane];
    const bool is_element = strand >= 0 && i + K <= strands.size(strand);
    ElementRest<K> element{{}, {}, {}, {}, strands, {}};
    element.radii.fill(1);
    for (int n = 0; n < K; ++n) {
      // What reaches into the pads has no stiffness, but its rest data must be benign all the same:
      // it is bound to the helix that the pads form.
      element.positions[n] =
          is_element ? lane_of(field.group(g)[i + n], lane) : pad_position(i + n);
      if (is_element) element.vertices[n] = strands.first(strand) + i + n;
      if (is_element) element.radii[n] = strands.radius(element.vertices[n]);
      if (n > 0) element.lengths[n - 1] = norm(element.positions[n] - element.positions[n - 1]);
    }
    element.material = strands.material().between_vertices(strands, element.vertices[(K - 1) / 2],
                                                           element.vertices[K / 2]);
    Rest<double> rest = kernel().rest(element);
    if (!is_element) rest.stiffness = 0;
    Lanes::set(rest_[group.first_row + i], lane, rest);
  }

  static Vector3<double> lane_of(const Vector3<Pack>& p, int lane) {
    return {p.x[lane], p.y[lane], p.z[lane]};
  }

  double add_in_lanes(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const {
    const StrandGroup& strands = (*groups_)[group];
    const Rest<Pack>* rest = &rest_[strands.first_row];
    const bool value_only = outputs.gradient.empty() && outputs.hessian.empty();
    const bool are_few =
        lane_count - std::count(strands.strands.begin(), strands.strands.end(), -1) <= few_strands;
    if (value_only) return are_few ? add_values_along(strands, x) : sum_lanes(add_values(rest, x));
    if (element_.filters_numerically() || outputs.gradient.empty() || outputs.hessian.empty()) {
      return sum_lanes(add_apart(rest, x, outputs));
    }
    return element_.with_kernel_filter([&]<Filter filter>() {
      return are_few ? add_derivatives_along<filter>(strands, x, outputs)
                     : sum_lanes(add_derivatives<filter>(rest, x, outputs));
    });
  }

  /// So few strands leave most lanes to pads: consecutive elements of each of them fill the lanes
  /// instead.
  static constexpr int few_strands = lane_count / 4;

  // The loops over them stand here twice: handed to one function as a lambda, a kernel is not
  // flattened, and takes longer.
  [[gnu::flatten]] double add_values_along(const StrandGroup& group,
                                           std::span<const Vector3<Pack>> x) const {
    const int end = static_cast<int>(x.size()) - K + 1;
    double energy = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
      if (group.strands[lane] < 0) continue;
      for (int first = 0; first < end; first += lane_count) {
        const ElementsAlong<Kernel> elements(&rest_[group.first_row], x, lane, first, end);
        const Pack energies = kernel().value(elements.stencil, elements.rest);
        for (int l = 0; l < std::min(end - first, lane_count); ++l) energy += energies[l];
      }
    }
    return energy;
  }
  template <Filter filter>
  [[gnu::flatten]] double add_derivatives_along(const StrandGroup& group,
                                                std::span<const Vector3<Pack>> x,
                                                EdgeOutputs outputs) const {
    const int end = static_cast<int>(x.size()) - K + 1;
    double energy = 0;
    for (int lane = 0; lane < lane_count; ++lane) {
      if (group.strands[lane] < 0) continue;
      for (int first = 0; first < end; first += lane_count) {
        const ElementsAlong<Kernel> elements(&rest_[group.first_row], x, lane, first, end);
        Derivatives<Pack, K> derivatives;
        const Pack energies = element_.template evaluate_kernel<filter>(
            elements.stencil, elements.rest, derivatives.outputs());
        for (int l = 0; l < std::min(end - first, lane_count); ++l) {
          energy += energies[l];
          scatter_lane(derivatives, l, first + l, lane, outputs);
        }
      }
    }
    return energy;
  }

  // A kernel is made of small functions of wide vectors: a call left among them costs more than its
  // work, hence flatten.
  [[gnu::flatten]] Pack add_values(const Rest<Pack>* rest, std::span<const Vector3<Pack>> x) const {
    Pack energy = 0;
    for (int i = 0; i + K <= static_cast<int>(x.size()); ++i) {
      energy += kernel().value(window(x, i), rest[i]);
    }
    return energy;
  }
  template <Filter filter>
  [[gnu::flatten]] Pack add_derivatives(const Rest<Pack>* rest, std::span<const Vector3<Pack>> x,
                                        EdgeOutputs outputs) const {
    const int count = static_cast<int>(x.size()) - K + 1;
    const auto outputs_of = [&](int i) {
      return ElementOutputs<Pack, K>(&outputs.gradient[i], &outputs.hessian.block(i, 0));
    };
    Pack energy = 0;
    if constexpr (GeometricKernel<Kernel>) {
      if (count <= 0) return energy;
      // An element has more instructions than a processor looks ahead, and its geometry is a chain
      // of roots and quotients: that of the next one is computed while this one's is waited for.
      const auto geometry = [&](int i) { return kernel().geometry(window(x, i), rest[i]); };
      auto next = geometry(0);
      for (int i = 0; i < count; ++i) {
        const auto own = next;
        next = geometry(std::min(i + 1, count - 1));
        energy += kernel().evaluate(own, rest[i], filter, outputs_of(i));
      }
    } else {
      for (int i = 0; i < count; ++i) {
        energy += element_.template evaluate_kernel<filter>(window(x, i), rest[i], outputs_of(i));
      }
    }
    return energy;
  }
  /// Each element by itself first, since it is filtered, or not all of it is wanted.
  Pack add_apart(const Rest<Pack>* rest, std::span<const Vector3<Pack>> x,
                 EdgeOutputs outputs) const {
    Pack energy = 0;
    for (int i = 0; i + K <= static_cast<int>(x.size()); ++i) {
      Derivatives<Pack, K> derivatives;
      energy += element_.evaluate(window(x, i), rest[i], derivatives);
      scatter(derivatives, i, outputs);
    }
    return energy;
  }
  void update(const Stencil<Pack, K>& x, Rest<Pack>& rest, const StepTime& time) const {
    if (evaluation_ == Evaluation::lanes) {
      rest = kernel().update(x, rest, time);
      return;
    }
    for (int lane = 0; lane < lane_count; ++lane) {
      Stencil<double, K> stencil;
      for (int n = 0; n < K; ++n) stencil[n] = lane_of(x[n], lane);
      Lanes::set(rest, lane, kernel().update(stencil, Lanes::get(rest, lane), time));
    }
  }

  static Stencil<Pack, K> window(std::span<const Vector3<Pack>> x, int first) {
    Stencil<Pack, K> stencil;
    for (int n = 0; n < K; ++n) stencil[n] = x[first + n];
    return stencil;
  }

  static void scatter(const Derivatives<Pack, K>& derivatives, int i, EdgeOutputs& outputs) {
    if (!outputs.gradient.empty()) {
      for (int n = 0; n < K - 1; ++n) outputs.gradient[i + n] += derivatives.gradient[n];
    }
    if (!outputs.hessian.empty()) {
      for (int row = 0; row < K - 1; ++row) {
        for (int column = 0; column <= row; ++column) {
          outputs.hessian.block(i + row, row - column) += derivatives.block(row, column);
        }
      }
    }
  }

  double add_one_by_one(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const {
    const Rest<Pack>* rest = &rest_[(*groups_)[group].first_row];
    std::array<double, lane_count> energies{};
    for (int i = 0; i + K <= static_cast<int>(x.size()); ++i) {
      for (int lane = 0; lane < lane_count; ++lane) {
        Stencil<double, K> stencil;
        for (int n = 0; n < K; ++n) stencil[n] = lane_of(x[i + n], lane);
        Derivatives<double, K> derivatives;
        energies[lane] += element_.evaluate(stencil, Lanes::get(rest[i], lane), derivatives);
        scatter_lane(derivatives, 0, i, lane, outputs);
      }
    }
    double energy = 0;
    for (const double lane_energy : energies) energy += lane_energy;
    return energy;
  }

  static double number_of(double number, int) { return number; }
  static double number_of(const Pack& numbers, int lane) { return numbers[lane]; }

  /// Adds the derivatives of one element, which a lane of packs holds, to a lane of the outputs.
  template <class S>
  static void scatter_lane(const Derivatives<S, K>& derivatives, int from, int i, int lane,
                           EdgeOutputs& outputs) {
    const auto add_to = [&](Pack& target, const S& value) {
      target[lane] = target[lane] + number_of(value, from);
    };
    if (!outputs.gradient.empty()) {
      for (int n = 0; n < K - 1; ++n) {
        add_to(outputs.gradient[i + n].x, derivatives.gradient[n].x);
        add_to(outputs.gradient[i + n].y, derivatives.gradient[n].y);
        add_to(outputs.gradient[i + n].z, derivatives.gradient[n].z);
      }
    }
    if (!outputs.hessian.empty()) {
      for (int row = 0; row < K - 1; ++row) {
        for (int column = 0; column <= row; ++column) {
          Matrix3<Pack>& block = outputs.hessian.block(i + row, row - column);
          for (int m = 0; m < 9; ++m) add_to(block.m[m], derivatives.block(row, column).m[m]);
        }
      }
    }
  }

  KernelDerivatives<Kernel> element_;
  Evaluation evaluation_;
  const StrandGroups* groups_ = nullptr;
  StreamedVector<Rest<Pack>> rest_;
};

/// The parameters of a kernel and those of its batch, one flat object in a scene.
template <class Kernel>
struct BatchParameters {
  typename Kernel::Parameters kernel;
  FilterChoice<Kernel> filter;
  Evaluation evaluation = Evaluation::lanes;

  static Schema<BatchParameters> schema() {
    return Schema<BatchParameters>()
        .include(&BatchParameters::kernel)
        .include(&BatchParameters::filter)
        .key("evaluation", &BatchParameters::evaluation, "", any_number(),
             "strands side by side in lanes, or one by one (slow, for comparison)");
  }
};

/// Registers the energy that a kernel defines.
template <ElementKernel Kernel>
void register_energy(Registry& registry, const std::string& name, Description description) {
  using Parameters = BatchParameters<Kernel>;
  registry.of<Energy>().add<Parameters>(
      name, std::move(description), [](const Parameters& parameters) {
        return std::make_unique<BatchEnergy<Kernel>>(
            Kernel{parameters.kernel}, parameters.filter.filter, parameters.evaluation);
      });
}

}  // namespace ringlet
