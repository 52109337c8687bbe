#include "apps/study/combinations.h"
#include "apps/study/front.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

StudyFile study_of(Combine combine, const std::vector<int>& value_counts) {
  StudyFile study;
  study.combine = combine;
  for (const int count : value_counts) {
    study.axes.emplace_back();
    study.axes.back().values.assign(count, 0);
  }
  return study;
}

}  // namespace

TEST_CASE("the front has what nothing else is as fast and as accurate as") {
  const auto front = pareto_front({{"slow and bad", 3, 1},
                                   {"best", 4, 1e-3},
                                   {"fast", 1, 0.5},
                                   {"as fast, but worse", 1, 0.6},
                                   {"middle", 2, 0.1},
                                   {"slower, as good", 2.5, 0.1}});
  std::vector<std::string> names;
  for (const TradePoint& point : front) names.push_back(point.name);
  CHECK(names == std::vector<std::string>{"fast", "middle", "best"});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("a recommendation names the fastest for each bound that changes the answer") {
  const std::vector<TradePoint> front{{"coarse", 0.05, 0.02}, {"fine", 0.5, 2e-4}};
  const auto words = recommend(front, TradePoint{"plain", 0.25, 0.01}, "m");
  REQUIRE(words.size() == 2);
  CHECK(words[0] ==
        "for errors under 3 cm: coarse (50 ms, 2 cm; 5 times faster than the scene as it stands)");
  CHECK(words[1] ==
        "for errors under 300 um: fine (500 ms, 200 um; 2 times slower than the scene as it "
        "stands)");
  CHECK(recommend(front, std::nullopt, "m")[0] == "for errors under 3 cm: coarse (50 ms, 2 cm)");
  CHECK(recommend({{"coarse", 0.05, 0.02}}, TradePoint{"coarse", 0.05, 0.02}, "")[0] ==
        "for errors under 3 %: coarse (50 ms, 2 %; the scene as it stands)");
}

TEST_CASE("axes are combined as a grid, zipped, or one at a time") {
  CHECK(combine(study_of(Combine::grid, {2, 2})) ==
        std::vector<Combination>{
            {{0, 0}, {1, 0}}, {{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}, {{0, 1}, {1, 1}}});
  CHECK(combine(study_of(Combine::zip, {2, 2})) ==
        std::vector<Combination>{{{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}});
  CHECK(combine(study_of(Combine::one_at_a_time, {2, 1})) ==
        std::vector<Combination>{{{0, 0}}, {{0, 1}}, {{1, 0}}});
  CHECK(combine(study_of(Combine::grid, {})).empty());
}
