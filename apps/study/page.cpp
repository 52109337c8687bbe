#include "apps/study/page.h"

#include "apps/pages/fill_page.h"
#include "apps/pages/page_templates.h"

namespace ringlet {

std::string study_page(const Json& results) { return study_page(results, study_page_template()); }

std::string study_page(const Json& results, const std::string& page) {
  return fill_page(page,
                   script_element("id=\"results\" type=\"application/json\"",
                                  results.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

}  // namespace ringlet
