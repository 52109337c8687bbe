#pragma once

#include "core/batch_energy.h"

namespace ringlet {

/// What may be wrong with an energy.
enum class Mistake {
  none,
  sign,               ///< of the gradient
  factor,             ///< of the Hessian
  not_invariant,      ///< the energy depends on where the strand is
  nan_when_straight,  ///< 0/0
  rest,               ///< it is not at rest in the rest shape
  hold,               ///< it holds twice what it should of a negative load
  lanes,              ///< they compute another Hessian than plain doubles
  indefinite,         ///< no filter does anything
  zero                ///< it has no stiffness
};

template <>
struct EnumNames<Mistake> {
  static constexpr std::pair<Mistake, const char*> names[] = {
      {Mistake::none, "none"},
      {Mistake::sign, "sign"},
      {Mistake::factor, "factor"},
      {Mistake::not_invariant, "not_invariant"},
      {Mistake::nan_when_straight, "nan_when_straight"},
      {Mistake::rest, "rest"},
      {Mistake::hold, "hold"},
      {Mistake::lanes, "lanes"},
      {Mistake::indefinite, "indefinite"},
      {Mistake::zero, "zero"}};
};

/// Bending by the angle of two edges, with one mistake.
struct WrongBending {
  struct Parameters {
    Mistake mistake = Mistake::none;

    static Schema<Parameters> schema() {
      return Schema<Parameters>().key("mistake", &Parameters::mistake, "", any_number(),
                                      "what is wrong");
    }
  };
  static constexpr int vertices = 3;
  template <class S>
  struct Rest {
    S stiffness, angle;
  };
  Parameters parameters;

  bool has(Mistake mistake) const { return parameters.mistake == mistake; }

  template <class S>
  S angle(const Stencil<S, 3>& x) const {
    const Vector3<S> e0 = x[1] - x[0], e1 = x[2] - x[1];
    const S sine = norm(cross(e0, e1));
    const S angle = atan2(sine, dot(e0, e1));
    return has(Mistake::nan_when_straight) ? angle * (sine / sine) : angle;
  }
  Rest<double> rest(const ElementRest<3>& element) const {
    const double at_rest = angle<double>(element.positions);
    return {has(Mistake::zero) ? 0.0 : 1.0, has(Mistake::rest) ? at_rest + 0.1 : at_rest};
  }
  Hold hold(const Stencil<double, 3>& x, double slope, Rest<double>& rest) const {
    const bool is_wrong = has(Mistake::hold) && slope < 0;
    rest.angle = angle(x) - (is_wrong ? 2 * slope : slope);
    return Hold::exact;
  }
  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const S difference = angle(x) - rest.angle;
    S energy = 0.5 * rest.stiffness * difference * difference;
    if (has(Mistake::not_invariant)) energy += rest.stiffness * x[0].x * difference;
    return energy;
  }
  template <class S>
  S evaluate(const Stencil<S, 3>& x, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 3> outputs) const {
    Derivatives<S, 3> derivatives;
    const S energy = evaluate_by_autodiff<Curvature::exact>(*this, x, rest, derivatives.outputs());
    if (has(Mistake::sign)) {
      for (Vector3<S>& slope : derivatives.gradient) slope = -slope;
    }
    const bool is_scaled = has(Mistake::factor) || (has(Mistake::lanes) && std::is_same_v<S, Pack>);
    if (is_scaled) {
      for (Matrix3<S>& block : derivatives.blocks) block = S(2) * block;
    }
    if (filter != Filter::exact && !has(Mistake::indefinite)) {
      filter_eigenvalues(Filter::clamp, derivatives);
    }
    derivatives.add_to(outputs);
    return energy;
  }
};

}  // namespace ringlet
