#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests:
#   tests/run.sh [options of ctest]
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

ringlet_setup
cmake --build "$ringlet_build"
ctest --test-dir "$ringlet_build" --output-on-failure --parallel "$(nproc)" "$@"
