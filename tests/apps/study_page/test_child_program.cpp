#include "apps/study/picture/child_program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("A child program gets its input and tells what it printed") {
  const std::string input(300000, 'x');
  const auto all = run_program({"cat"}, input);
  REQUIRE(all);
  CHECK(all->exit_code == 0);
  CHECK(all->output == input);
  const auto both = run_program({"sh", "-c", "echo out; echo 'err $1' >&2; exit 3"}, "");
  REQUIRE(both);
  CHECK(both->exit_code == 3);
  CHECK(both->output == "out\n");
  CHECK(both->errors == "err $1\n");
}

TEST_CASE("A child program that a signal ends has no exit code") {
  const auto ended = run_program({"sh", "-c", "kill -9 $$"}, "");
  REQUIRE(ended);
  CHECK(ended->exit_code == -1);
}

TEST_CASE("A child program that does not exist is nothing") {
  CHECK(!run_program({"ringlet-has-no-such-program"}, ""));
}
