#include <set>

#include "apps/study/picture/log_range.h"
#include "apps/study/picture/quantity_words.h"
#include "apps/study/picture/symbols.h"
#include "apps/study/picture/text.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("Quantities are told with three digits and a prefix of their unit") {
  CHECK(quantity_words(1.234e-4, "m") == "123 µm");
  CHECK(quantity_words(9.999e-4, "m") == "1 mm");
  CHECK(quantity_words(0.5, "s") == "500 ms");
  CHECK(quantity_words(-75, "s") == "-75 s");
  CHECK(quantity_words(0, "m") == "0 m");
  CHECK(quantity_words(41e6, "B") == "41 MB");
  CHECK(quantity_words(1e-30, "J") == "1e-15 fJ");
  CHECK(quantity_words(0.002, "1/m") == "0.002 1/m");
  CHECK(quantity_words(3, "") == "3");
}

TEST_CASE("A logarithmic axis holds its values and some ticks, whatever it spans") {
  for (const double span : {1.0, 1.5, 4.0, 30.0, 1e3, 1e6, 1e25}) {
    const double low = 0.037;
    const LogRange range = LogRange::around({low * span, low});
    CAPTURE(span, range.ticks.size());
    CHECK(range.low < low);
    CHECK(range.high > low * span);
    CHECK(range.ticks.size() >= 3);
    CHECK(range.ticks.size() <= 12);
    CHECK(range.ticks.front() >= range.low);
    CHECK(range.ticks.back() <= range.high);
  }
  CHECK(LogRange::around({}).low > 0);
}

TEST_CASE("Texts are shortened and wrapped by characters, not by bytes") {
  CHECK(shortened("ünïcödé", 7) == "ünïcödé");
  CHECK(shortened("ünïcödés", 7) == "ünïcöd…");
  CHECK(wrapped("äa bb cc", 5, 3) == std::vector<std::string>{"äa bb", "cc"});
  CHECK(wrapped("aa bb cc dd", 5, 1) == std::vector<std::string>{"aa… …"});
  CHECK(wrapped("aaaaaaaa", 5, 2) == std::vector<std::string>{"aaaa…"});
  CHECK(wrapped("", 5, 2).empty());
}

TEST_CASE("Within a string of gnuplot only a quote has a meaning") {
  CHECK(gnuplot_string("it's `x` \"$y\" @z {/a} \\n") == "'it''s `x` \"$y\" @z {/a} \\n'");
  CHECK(gnuplot_string("a\nb\r\tc") == "'a b  c'");
}

TEST_CASE("Values of an axis have colours of their own") {
  const auto different = [](const std::vector<std::string>& values) {
    const auto colours = colours_for(values);
    CHECK(colours.size() == values.size());
    return std::set(colours.begin(), colours.end()).size() == values.size();
  };
  CHECK(different({"tight", "clamp", "none"}));
  CHECK(different({"0.1", "1e-2"}));
  CHECK(different({"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"}));
  CHECK(different({"7"}));
  CHECK(colours_for({"1", "2"}) != colours_for({"one", "two"}));
}

TEST_CASE("Symbols are hollow or filled, and begin anew after six") {
  CHECK(symbol_for(1, true) == symbol_for(1, false) + 1);
  CHECK(symbol_for(0, true) != symbol_for(5, true));
  CHECK(symbol_for(6, true) == symbol_for(0, true));
  CHECK(symbol_for(-1, true) == symbol_for(0, true));
}
