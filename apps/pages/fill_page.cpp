#include "apps/pages/fill_page.h"

#include "core/error.h"

namespace ringlet {

std::string script_element(const std::string& attributes, std::string text) {
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    text.replace(at, 1, "\\u003c");
  }
  return "<script " + attributes + ">" + text + "</script>\n";
}

std::string fill_page(const std::string& page, const std::string& elements) {
  const std::string mark = "<!--DATA-->";
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) throw Error("the page has no mark " + mark);
  return page.substr(0, at) + elements + page.substr(at + mark.size());
}

}  // namespace ringlet
