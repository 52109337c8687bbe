#pragma once

#include <new>
#include <string>

#include "core/error.h"

namespace ringlet {

/// What kind of plugin an interface is; see core/registry.h.
template <class Interface>
struct Kind;

/// What every plugin of a scene is: it knows the name by which the scene chose it, for reports.
class Named {
 public:
  const std::string& name() const { return name_; }
  void set_name(const std::string& name) { name_ = name; }

 private:
  std::string name_;
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
template <class Interface, class Use>
decltype(auto) naming(const Interface& plugin, const Use& use) {
  return naming<Interface>(plugin.name(), use);
}

}  // namespace ringlet
