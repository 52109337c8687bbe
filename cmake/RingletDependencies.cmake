# Everything ringlet is built on. All of it comes from the system's packages.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(spdlog REQUIRED)
find_package(fcl 0.7 REQUIRED)
find_package(ZLIB REQUIRED)
