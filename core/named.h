#pragma once

#include <cstddef>
#include <new>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/work_time.h"

namespace ringlet {

/// What kind of plugin an interface is; see core/registry.h.
template <class Interface>
struct Kind;

/// What every plugin of a scene is: it knows the name by which the scene chose it, and what it
/// costs, for reports.
class Named {
 public:
  const std::string& name() const { return name_; }
  void set_name(const std::string& name) { name_ = name; }
  /// The time of its calls through naming().
  WorkTime& work_time() const { return work_time_; }
  /// The memory that it holds now, bytes; 0 if that is nothing to speak of.
  virtual std::size_t bytes() const { return 0; }

 protected:
  Named() = default;
  ~Named() = default;
  Named(const Named&) = delete;
  Named& operator=(const Named&) = delete;

 private:
  std::string name_;
  mutable WorkTime work_time_;
};

/// An exception of a plugin, told with the kind and the name of the plugin.
class PluginError : public Error {
 public:
  using Error::Error;
};

/// Calls use(), which runs the plugin of an interface and a name. What it throws becomes a
/// PluginError, but for one of a plugin that it runs itself.
template <class Interface, class Use>
decltype(auto) naming(const std::string& name, const Use& use) {
  const auto who = [&] { return std::string(Kind<Interface>::name) + " '" + name + "': "; };
  try {
    return use();
  } catch (const PluginError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw PluginError(who() + error.what());
  } catch (...) {
    throw PluginError(who() + "throws what is no exception of the standard library");
  }
}
/// The same with the name of a plugin, whose time it measures.
template <class Interface, class Use>
decltype(auto) naming(const Interface& plugin, const Use& use) {
  const WorkTime::Timer timer(plugin.work_time());
  return naming<Interface>(plugin.name(), use);
}

/// Of which parts of a work the time is measured, and for how much of the work it stands: to look
/// at the clock may take as long as a part. Nothing: it is not measured.
using TimeSample = std::optional<double>;

/// The same of a part of a plugin's work.
template <class Interface, class Use>
decltype(auto) naming(const Interface& plugin, TimeSample sample, const Use& use) {
  std::optional<WorkTime::Timer> timer;
  if (sample) timer.emplace(plugin.work_time(), *sample);
  return naming<Interface>(plugin.name(), use);
}

}  // namespace ringlet
