#include "core/varying.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "core/strands.h"

namespace ringlet {
namespace {

/// Of a scene, in the order of Varying::By.
constexpr const char* varying_keys[] = {"", "by_strand", "by_vertex", "root_to_tip"};

/// Numbers of a text file between spaces, line ends or commas; a # begins a comment.
std::vector<double> read_numbers(const std::filesystem::path& file) {
  std::ifstream input(file);
  if (!input) throw Error("cannot open '" + file.string() + "'");
  std::vector<double> numbers;
  int line_number = 0;
  for (std::string line; std::getline(input, line);) {
    ++line_number;
    line.resize(std::min(line.find('#'), line.size()));
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      char* end = nullptr;
      numbers.push_back(std::strtod(word.c_str(), &end));
      if (*end == '\0') continue;
      throw Error("'" + file.string() + "', line " + std::to_string(line_number) +
                  ": expected a number, found '" + word + "'");
    }
  }
  return numbers;
}

}  // namespace

double Varying::number_of(int which, int expected, const char* what) const {
  if (static_cast<int>(numbers_.size()) != expected) {
    throw Error(pointer_ + ": expected " + std::to_string(expected) + " numbers, one for each " +
                what + ", found " + std::to_string(numbers_.size()));
  }
  return numbers_[which];
}

double Varying::at(const Strands& strands, int vertex) const {
  if (by_ == By::all) return numbers_.front();
  if (by_ == By::strand) return number_of(strands.strand_of(vertex), strands.count(), "strand");
  if (by_ == By::vertex) return number_of(vertex, strands.vertex_count(), "vertex");
  const double place = strands.fraction_along(vertex) * static_cast<double>(numbers_.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), numbers_.size() - 2);
  const double part = place - static_cast<double>(before);
  return (1 - part) * numbers_[before] + part * numbers_[before + 1];
}

Json Codec<Varying>::schema(const KeyInfo& key) {
  const Json number = Codec<double>::schema(key), list = Codec<std::vector<double>>::schema(key);
  Json from_root_to_tip = list;
  from_root_to_tip["minItems"] = 2;
  std::vector<Json> alternatives{number};
  for (std::size_t by = 1; by < std::size(varying_keys); ++by) {
    const bool along = static_cast<Varying::By>(by) == Varying::By::length;
    const Json numbers =
        along ? from_root_to_tip : choice_schema({list, Codec<ScenePath>::schema(key)});
    alternatives.push_back({{"type", "object"},
                            {"properties", {{varying_keys[by], numbers}}},
                            {"required", Json::array({varying_keys[by]})},
                            {"additionalProperties", false}});
  }
  return choice_schema(std::move(alternatives));
}

void Codec<Varying>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                          ParseContext& context, Varying& out) {
  const std::size_t problems = context.problems.size();
  Varying result;
  result.pointer_ = pointer;
  if (!json.is_object()) {
    KeyInfo number = info;
    number.type = Codec<double>::type();
    Codec<double>::read(json, pointer, number, context, result.numbers_.front());
  } else {
    for (std::size_t by = 1; by < std::size(varying_keys); ++by) {
      if (json.size() == 1 && json.contains(varying_keys[by]))
        result.by_ = static_cast<Varying::By>(by);
    }
    if (result.by_ == Varying::By::all) {
      context.problem(pointer, info.expected() + " with a list or file of numbers");
      return;
    }
    read_list(json.front(), pointer_to(pointer, json.begin().key()), info, context, result);
  }
  if (context.problems.size() == problems) out = std::move(result);
}

void Codec<Varying>::read_list(const Json& json, const std::string& pointer, const KeyInfo& info,
                               ParseContext& context, Varying& out) {
  KeyInfo number = info;
  number.type = "list of numbers";
  const bool along = out.by_ == Varying::By::length;
  if (json.is_string() && !along) {
    read_file(json, pointer, number, context, out);
    return;
  }
  if (!along) number.type += " or path of a file of numbers";
  Codec<std::vector<double>>::read(json, pointer, number, context, out.numbers_);
  if (along && json.is_array() && json.size() < 2) {
    context.problem(pointer, "expected at least 2 numbers, of the root and of the tip");
  }
}

void Codec<Varying>::read_file(const Json& json, const std::string& pointer, const KeyInfo& info,
                               ParseContext& context, Varying& out) {
  ScenePath path;
  const std::size_t problems = context.problems.size();
  Codec<ScenePath>::read(json, pointer, info, context, path);
  if (context.problems.size() > problems) return;
  out.file_ = path.absolute;
  try {
    out.numbers_ = read_numbers(out.file_);
  } catch (const Error& error) {
    context.problem(pointer, error.what());
  }
  for (std::size_t i = 0; i < out.numbers_.size(); ++i) {
    if (info.range.contains(out.numbers_[i])) continue;
    std::ostringstream found;
    found << "expected numbers " << info.range.text() << ", but number " << i + 1 << " of '"
          << out.file_.string() << "' is " << out.numbers_[i];
    context.problem(pointer, found.str());
    return;
  }
}

Json Codec<Varying>::write(const Varying& value) {
  if (value.by_ == Varying::By::all) return value.numbers_.front();
  const char* key = varying_keys[static_cast<std::size_t>(value.by_)];
  if (!value.file_.empty()) return {{key, value.file_.string()}};
  return {{key, value.numbers_}};
}

}  // namespace ringlet
