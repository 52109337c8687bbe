#include "apps/study/page.h"
#include "core/error.h"
#include "tests/apps/study_page/sample_results.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

constexpr const char* page = "<html><!--DATA--></html>";

/// What the code of a page reads: the text up to the first thing that ends the element.
Json embedded(const std::string& html) {
  const std::string head = "<script id=\"results\" type=\"application/json\">";
  const std::size_t at = html.find(head);
  REQUIRE(at != std::string::npos);
  const std::size_t begin = at + head.size();
  return Json::parse(html.substr(begin, html.find("</script", begin) - begin));
}

}  // namespace

TEST_CASE("The page of a study holds its results as they are") {
  const Json results = sample_results();
  const std::string html = study_page(results, page);
  CHECK(embedded(html) == results);
  CHECK(html.starts_with("<html><script"));
  CHECK(html.ends_with("</script>\n</html>"));
}

TEST_CASE("No name ends the script that holds the results of a study") {
  Json results = sample_results();
  results["variants"][0]["name"] = "</script><img src=x onerror=alert(1)> <!-- $& \"'";
  const std::string html = study_page(results, page);
  CHECK(embedded(html) == results);
  CHECK(html.find("<img") == std::string::npos);
  CHECK(html.find("<!--") == std::string::npos);
}

TEST_CASE("A name that is not UTF-8 does not keep the page of a study from being written") {
  Json results = sample_results();
  results["study"]["name"] = "caf\xe9";
  CHECK(embedded(study_page(results, page))["study"]["name"] == "caf\xef\xbf\xbd");
}

TEST_CASE("A page without a mark cannot show a study") {
  CHECK_THROWS_WITH(study_page(sample_results(), "<html>"), contains("<!--DATA-->"));
}
