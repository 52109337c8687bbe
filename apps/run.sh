#!/usr/bin/env bash
# Installs what is missing, builds ringlet and runs a scene:
#   apps/run.sh [SCENE.json] [options of `ringlet run`]
# Without a scene it runs apps/scenes/hairball.json.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

ringlet_setup
cmake --build "$ringlet_build" --target ringlet

if [ $# -eq 0 ] || [[ "$1" == -* ]]; then
  set -- "$ringlet_root/apps/scenes/hairball.json" "$@"
fi
status=0
"$ringlet_build/apps/ringlet" run "$@" || status=$?
if [ "$status" -ne 2 ]; then
  echo "To look at it: open run.pvd of that folder in ParaView, press Apply, then play." \
       "metrics.csv has a row a step, summary.json the totals."
fi
exit "$status"
