#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ringlet {

/// An option that a command knows.
struct Option {
  std::string name;             ///< "--steps"
  std::string value = {};       ///< what its value is called in the help; "" for a flag
  std::string meaning = {};     ///< one line of the help
  std::string short_name = {};  ///< "-o", or ""
  bool repeatable = false;
};

/// What stands on the command line after the name of a command.
class Arguments {
 public:
  /// Throws Error for an unknown option, a missing value, a repetition, or a number of operands
  /// other than wanted. operands are their names in the help; one in brackets may be left out.
  Arguments(const std::vector<std::string>& words, const std::vector<std::string>& operands,
            const std::vector<Option>& options);

  std::optional<std::string> operand(std::size_t index) const;
  bool has(const std::string& option) const { return values_.contains(option); }
  std::optional<std::string> value(const std::string& option) const;
  std::vector<std::string> values(const std::string& option) const;
  /// Throws Error if the value is not an integer >= least.
  std::optional<int> integer(const std::string& option, int least) const;

 private:
  void take_option(const std::string& word, const std::vector<std::string>& words, std::size_t& i,
                   const std::vector<Option>& options);

  std::vector<std::string> operands_;
  std::map<std::string, std::vector<std::string>> values_;
};

}  // namespace ringlet
