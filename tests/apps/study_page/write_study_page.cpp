// Writes the page of a study for the test in a browser:  write_study_page RESULTS.json OUT.html
#include <fstream>
#include <iostream>

#include "apps/study/page.h"
#include "core/error.h"

int main(int count, char** words) {
  if (count != 3) return 2;
  try {
    std::ifstream results(words[1]);
    std::ofstream(words[2]) << ringlet::study_page(ringlet::Json::parse(results));
  } catch (const ringlet::Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
