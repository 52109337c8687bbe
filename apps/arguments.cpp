#include "apps/arguments.h"

#include <charconv>

#include "core/error.h"
#include "core/suggest.h"

namespace ringlet {
namespace {

const Option& find_option(const std::string& name, const std::vector<Option>& options) {
  std::vector<std::string> known;
  for (const Option& option : options) {
    if (name == option.name || name == option.short_name) return option;
    known.push_back(option.name);
    if (!option.short_name.empty()) known.push_back(option.short_name);
  }
  throw Error("unknown option '" + name + "'; " + did_you_mean(name, known));
}

}  // namespace

Arguments::Arguments(const std::vector<std::string>& words,
                     const std::vector<std::string>& operands, const std::vector<Option>& options) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].size() > 1 && words[i][0] == '-') {
      take_option(words[i], words, i, options);
    } else {
      operands_.push_back(words[i]);
    }
  }
  if (operands_.size() > operands.size()) {
    throw Error("unexpected '" + operands_[operands.size()] + "'");
  }
  if (operands_.size() < operands.size() && operands[operands_.size()][0] != '[') {
    throw Error("missing " + operands[operands_.size()]);
  }
}

void Arguments::take_option(const std::string& word, const std::vector<std::string>& words,
                            std::size_t& i, const std::vector<Option>& options) {
  const bool is_long = word.starts_with("--");
  const std::size_t equals = is_long ? word.find('=') : std::string::npos;
  const Option& option = find_option(word.substr(0, equals), options);
  std::vector<std::string>& values = values_[option.name];
  if (!values.empty() && !option.repeatable) {
    throw Error("'" + option.name + "' is given twice");
  }
  if (option.value.empty()) {
    if (equals != std::string::npos) throw Error("'" + option.name + "' takes no value");
    values.emplace_back();
  } else if (equals != std::string::npos) {
    values.push_back(word.substr(equals + 1));
  } else if (i + 1 < words.size()) {
    values.push_back(words[++i]);
  } else {
    throw Error("'" + option.name + "' needs a value: " + option.value);
  }
}

std::optional<std::string> Arguments::operand(std::size_t index) const {
  return index < operands_.size() ? std::optional(operands_[index]) : std::nullopt;
}

std::optional<std::string> Arguments::value(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::nullopt : std::optional(found->second.front());
}

std::vector<std::string> Arguments::values(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::vector<std::string>() : found->second;
}

std::optional<int> Arguments::integer(const std::string& option, int least) const {
  const auto text = value(option);
  if (!text) return std::nullopt;
  int number = 0;
  const char* end = text->data() + text->size();
  const auto [rest, error] = std::from_chars(text->data(), end, number);
  if (error != std::errc() || rest != end || number < least) {
    throw Error("'" + option + "' expects an integer >= " + std::to_string(least) + ", found '" +
                *text + "'");
  }
  return number;
}

}  // namespace ringlet
