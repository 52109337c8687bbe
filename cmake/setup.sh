# Sourced by apps/run.sh and tests/run.sh: `ringlet_setup` installs what is missing and configures
# build/release, both only where needed; `ringlet_setup page` also installs what pages and pictures need.

ringlet_root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
ringlet_build="$ringlet_root/build/release"
ringlet_packages=(g++ cmake ninja-build libeigen3-dev libtbb-dev libspdlog-dev nlohmann-json3-dev
                  catch2 libfcl-dev zlib1g-dev python3-jsonschema)
# With Node and npm the pages of reports and studies are bundled, with gnuplot pictures of studies are
# drawn; without them everything else is built and runs. They are many small packages, so only
# `ringlet_setup page` installs them. Whoever has them from elsewhere keeps those. Neither is ringlet
# held up where there is no Embree and libpng, with which `ringlet render` draws.
ringlet_render_packages=(libembree-dev libpng-dev)
ringlet_missing_page_packages() {
  command -v npm >/dev/null || printf '%s\n' nodejs npm
  command -v gnuplot >/dev/null || echo gnuplot-nox
}

ringlet_missing_packages() {
  local package
  for package in "$@"; do
    if ! dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed'; then
      echo "$package"
    fi
  done
}

ringlet_install() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg >/dev/null; then
    echo "This system has no apt. What must be installed: a C++20 compiler (g++ 12 or newer)," \
         "CMake 3.25, Ninja, Eigen 3.4, oneTBB, spdlog, nlohmann_json 3.11, FCL 0.7, zlib and" \
         "Catch2; for the pages of reports and studies also Node 18 and npm, for pictures of" \
         "studies gnuplot, for those of runs Embree 3.13 and libpng, for a test of the scenes'" \
         "schema Python 3 with jsonschema." \
         "Going on with what CMake finds." >&2
    return
  fi
  local missing
  mapfile -t missing < <(ringlet_missing_packages "${ringlet_packages[@]}")
  local optional
  mapfile -t optional < <(
    ringlet_missing_packages "${ringlet_render_packages[@]}"
    if [ "${1:-}" = page ]; then ringlet_missing_page_packages; fi
  )
  if [ "${#missing[@]}" -eq 0 ] && [ "${#optional[@]}" -eq 0 ]; then return; fi
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      if [ "${#missing[@]}" -eq 0 ]; then return; fi
      echo "Run this as root, or install these packages first: ${missing[*]} ${optional[*]}" >&2
      exit 2
    fi
    sudo=(sudo)
  fi
  echo "Installing ${missing[*]} ${optional[*]}" >&2
  local install=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y
                 --no-install-recommends)
  "${sudo[@]}" apt-get update -q || [ "${#missing[@]}" -eq 0 ]
  if [ "${#missing[@]}" -gt 0 ]; then "${install[@]}" "${missing[@]}"; fi
  if [ "${#optional[@]}" -gt 0 ]; then
    if "${install[@]}" "${optional[@]}"; then
      rm -f "$ringlet_build/build.ninja"  # so that CMake looks for them again
    else
      echo "Going on without ${optional[*]}: there may be no pages or pictures." >&2
    fi
  fi
}

ringlet_configure() {
  if [ -f "$ringlet_build/build.ninja" ]; then return; fi
  (cd "$ringlet_root" && cmake --preset release) || {
    echo "CMake could not configure ringlet; its message above says what it did not find." >&2
    exit 2
  }
}

ringlet_setup() {
  ringlet_install "$@"
  ringlet_configure
}
