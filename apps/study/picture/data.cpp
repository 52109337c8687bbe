#include "apps/study/picture/data.h"

#include <algorithm>

namespace ringlet {
namespace {

std::optional<double> number(const Json& object, const std::string& key) {
  const auto at = object.find(key);
  if (at == object.end() || !at->is_number()) return std::nullopt;
  return at->get<double>();
}

std::string text(const Json& object, const std::string& key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_string() ? at->get<std::string>() : "";
}

std::vector<PictureAxis> axes_of(const Json& results) {
  std::vector<PictureAxis> axes;
  for (const Json& axis : results.value("axes", Json::array())) {
    const std::string name = text(axis, "name"), label = text(axis, "label"),
                      unit = text(axis, "unit");
    axes.push_back({name, (label.empty() ? name : label) + (unit.empty() ? "" : ", " + unit), {}});
    for (const Json& value : axis.value("values", Json::array())) {
      axes.back().values.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
  return axes;
}

/// Which value of an axis a variant has.
int index_on_axis(const std::vector<PictureAxis>& axes, std::size_t which, const Json& variant) {
  if (which >= axes.size()) return -1;
  const std::vector<std::string>& values = axes[which].values;
  const std::string value = text(variant.value("values", Json::object()), axes[which].name);
  const auto found = std::find(values.begin(), values.end(), value);
  return found == values.end() ? -1 : static_cast<int>(found - values.begin());
}

/// The first error, if the study has one.
std::optional<std::string> shown_error(const Json& results) {
  const Json errors = results.value("errors", Json::array());
  if (errors.empty() || !results.contains("reference")) return std::nullopt;
  return text(errors[0], "name");
}

std::optional<double> value_of(const Json& variant, const std::optional<std::string>& error) {
  if (!error) return number(variant, "newton_iterations");
  return number(variant.value("errors", Json::object()), *error);
}

std::optional<PicturePoint> point_of(const std::vector<PictureAxis>& axes, const Json& variant,
                                     const std::optional<std::string>& error) {
  const std::string status = text(variant, "status");
  const bool ran = status == "finished" || status == "not_converged";
  const auto seconds = number(variant, "seconds"), value = value_of(variant, error);
  if (!ran || !seconds || *seconds <= 0 || !value || *value < 0) return std::nullopt;
  const auto end = [&](const std::string& key) {
    const double time = number(variant, key).value_or(*seconds);
    return time > 0 ? time : *seconds;
  };
  return PicturePoint{text(variant, "name"),
                      *seconds,
                      end("seconds_low"),
                      end("seconds_high"),
                      *value,
                      index_on_axis(axes, 0, variant),
                      index_on_axis(axes, 1, variant),
                      status == "finished"};
}

std::string reason_of(const Json& variant) {
  std::string status = text(variant, "status");
  std::replace(status.begin(), status.end(), '_', ' ');
  const std::string reason = text(variant, "reason");
  return text(variant, "name") + " (" + status + (reason.empty() ? "" : ": ") + reason + ")";
}

std::optional<std::size_t> find_point(const PictureData& data, const std::string& name) {
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    if (data.points[i].name == name) return i;
  }
  return std::nullopt;
}

}  // namespace

PictureData picture_data(const Json& results) {
  PictureData data;
  const Json study = results.value("study", Json::object());
  data.study = text(study, "name");
  data.about = text(study, "about");
  data.timing_note = text(results, "timing_note");
  data.axes = axes_of(results);
  const std::optional<std::string> error = shown_error(results);
  data.label = error ? text(results["errors"][0], "label") : "Newton iterations a step";
  data.unit = error ? text(results["errors"][0], "unit") : "";
  for (const Json& variant : results.value("variants", Json::array())) {
    if (const auto point = point_of(data.axes, variant, error)) {
      data.points.push_back(*point);
    } else {
      data.without_place.push_back(reason_of(variant));
    }
  }
  data.default_variant = find_point(data, text(results, "default"));
  if (!error) return data;
  for (const Json& name : results.value("fronts", Json::object()).value(*error, Json::array())) {
    if (const auto point = find_point(data, name)) data.front.push_back(*point);
  }
  return data;
}

}  // namespace ringlet
